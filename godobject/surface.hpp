// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace limitcurve::godobject {

/// The surface of a solid in its body's frame. `contact` finds the surface point nearest the finger, with the outward normal
/// and the depth (≤ 0 outside), and what it needs to remember of the finger until the next step. It changes nothing: the memory is the
/// finger's, which keeps that of samples that it accepts. The finger is finite. Bounded, without allocation or exceptions.
// clang-format off
template <class Shape>
concept Surface = requires(const Shape& shape, const Eigen::Vector3d& finger, const ContactMemory& memory) {
  { shape.contact(finger, memory) } noexcept -> std::same_as<Contact>;
};
// clang-format on

/// Any surface, chosen at run time: for programs that read from a file or a command line what the finger touches. Costs
/// one indirect call a contact. Immutable; copies share the surface. Allocates at construction only.
class AnySurface {
 public:
  // clang-format off
  template <class Shape>
  requires(Surface<Shape> && !std::same_as<Shape, AnySurface>)
  explicit AnySurface(Shape shape) : model_(std::make_shared<Model<Shape>>(std::move(shape))) {}
  // clang-format on

  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept {
    return model_->contact(finger, memory);
  }

 private:
  struct Interface {
    Interface() = default;
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;
    virtual ~Interface() = default;
    [[nodiscard]] virtual Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept = 0;
  };

  template <class Shape>
  struct Model final : Interface {
    explicit Model(Shape with) : shape(std::move(with)) {}
    [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept override {
      return shape.contact(finger, memory);
    }
    Shape shape;
  };

  std::shared_ptr<const Interface> model_;
};

static_assert(Surface<AnySurface>);

}  // namespace limitcurve::godobject
