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

/// The half space below the plane z = 0 of the body's frame, outward normal +z.
class PlaneSurface {
 public:
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory&) const noexcept {
    return {{finger.x(), finger.y(), 0.0}, Eigen::Vector3d::UnitZ(), -finger.z()};
  }
};

/// A sphere about the origin. A finger that reaches its centre keeps the side it came from.
class SphereSurface {
 public:
  explicit SphereSurface(double radius);  ///< [m] > 0; throws std::invalid_argument
  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  double radius_;
};

/// All points within a radius of the segment from (0, 0, −h) to (0, 0, h). A finger that reaches the segment keeps the side it came from.
class CapsuleSurface {
 public:
  CapsuleSurface(double radius, double half_length);  ///< [m] > 0, ≥ 0; throws std::invalid_argument
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  double radius_;
  double half_length_;
};

/// The cylinder x² + y² ≤ R², |z| ≤ h, with flat ends. A finger inside stays on the face (side or end) that it came in by:
/// a thin disc is not passed through, not even in one step. On the axis it keeps the side that it came from.
class CylinderSurface {
 public:
  CylinderSurface(double radius, double half_length);  ///< [m] > 0; throws std::invalid_argument
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  [[nodiscard]] int entered(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const noexcept;

  double radius_;
  double half_length_;
};

/// The box |x| ≤ h_x, |y| ≤ h_y, |z| ≤ h_z. A finger stays on the face that it came in by, however deep it is pressed, until
/// it leaves over an edge: a thin plate is not passed through, not even in one step, and opposite faces do not change places.
class BoxSurface {
 public:
  explicit BoxSurface(const Eigen::Vector3d& half_edges);  ///< [m], each > 0; throws std::invalid_argument
  [[nodiscard]] const Eigen::Vector3d& half_edges() const noexcept { return half_edges_; }
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  [[nodiscard]] bool beside(const Eigen::Vector3d& finger, int axis) const noexcept;
  [[nodiscard]] int crossed(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const noexcept;
  [[nodiscard]] int nearest_face(const Eigen::Vector3d& finger) const noexcept;

  Eigen::Vector3d half_edges_;
};

static_assert(Surface<PlaneSurface> && Surface<SphereSurface> && Surface<CapsuleSurface> && Surface<CylinderSurface> &&
              Surface<BoxSurface>);

}  // namespace limitcurve::godobject
