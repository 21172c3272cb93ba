// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/surface.hpp"

#include <limits>

namespace limitcurve::godobject {

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
