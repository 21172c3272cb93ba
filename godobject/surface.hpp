// SPDX-License-Identifier: MIT
#pragma once

#include "contact.hpp"

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace limitcurve::godobject {

/// The surface of a solid, in its body's frame. Your `contact` returns the surface point nearest to the finger, the
/// outward normal there, the depth (≤ 0 outside), and the memory for the next query. You may rely on `finger`
/// being finite. Your function must not keep state, because the SoftFinger keeps the memory, and only of samples that
/// the finger accepts. It must take bounded time, and must not allocate or throw.
// clang-format off
template <class Shape>
concept Surface = requires(const Shape& shape, const Eigen::Vector3d& finger, const ContactMemory& memory) {
  { shape.contact(finger, memory) } noexcept -> std::same_as<Contact>;
};
// clang-format on

/// Any surface, chosen at run time, for example by a file or a command line. Costs one indirect call for each contact.
/// Immutable; copies share the surface. Any surface converts to it, for example in `finger.update(SphereSurface(0.05),
/// pose)`. The conversion allocates: in a loop make it once.
class AnySurface {
 public:
  // clang-format off
  template <class Shape>
  requires(Surface<Shape> && !std::same_as<Shape, AnySurface>)
  AnySurface(Shape shape) : model_(std::make_shared<Model<Shape>>(std::move(shape))) {}
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
    [[nodiscard]] virtual Contact contact(const Eigen::Vector3d& finger,
                                          const ContactMemory& memory) const noexcept = 0;
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

/// The half space below the plane z = 0 of the body's frame, outward normal +z.
class PlaneSurface {
 public:
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory&) const noexcept {
    return {{finger.x(), finger.y(), 0.0}, Eigen::Vector3d::UnitZ(), -finger.z()};
  }
};

static_assert(Surface<PlaneSurface>);

}  // namespace limitcurve::godobject
