// SPDX-License-Identifier: MIT
#pragma once

#include "../surface.hpp"

namespace limitcurve::godobject {

/// A sphere about the origin. It does not remember where a finger entered. So a finger that is pressed past the centre
/// comes out on the far side, and a finger that crosses the whole sphere in one step never touches it. A finger at the
/// centre keeps the normal of the last step.
class SphereSurface {
 public:
  explicit SphereSurface(double radius);  ///< [m] > 0, ≤ 1e6; throws std::invalid_argument
  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  double radius_;
};

/// A capsule: all points within a radius of the segment from (0, 0, −h) to (0, 0, h). Like the sphere, it does not
/// remember where a finger entered. On the segment a finger keeps the normal of the last step.
class CapsuleSurface {
 public:
  CapsuleSurface(double radius, double half_length);  ///< [m] > 0, ≥ 0, ≤ 1e6; throws std::invalid_argument
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  double radius_;
  double half_length_;
};

/// The cylinder x² + y² ≤ R², |z| ≤ h, with flat ends. A finger inside stays on the face (side or end) through which it
/// entered, so it cannot pass through a thin disc, not even in one step. It can pass through a thin rod, because the
/// side is a single face and does not remember where the finger entered. A finger on the axis keeps the normal of the
/// last step.
class CylinderSurface {
 public:
  CylinderSurface(double radius, double half_length);  ///< [m] > 0, ≤ 1e6; throws std::invalid_argument
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  [[nodiscard]] int entered(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const noexcept;

  double radius_;
  double half_length_;
};

/// The box |x| ≤ h_x, |y| ≤ h_y, |z| ≤ h_z. A finger stays on the face through which it entered, at any depth, until it
/// leaves over an edge. So it cannot pass through a thin plate, not even in one step.
class BoxSurface {
 public:
  explicit BoxSurface(const Eigen::Vector3d& half_edges);  ///< [m], each > 0, ≤ 1e6; throws std::invalid_argument
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  [[nodiscard]] bool beside(const Eigen::Vector3d& finger, int axis) const noexcept;
  [[nodiscard]] int crossed(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const noexcept;
  [[nodiscard]] int nearest_face(const Eigen::Vector3d& finger) const noexcept;

  Eigen::Vector3d half_edges_;
};

static_assert(Surface<SphereSurface> && Surface<CapsuleSurface> && Surface<CylinderSurface> && Surface<BoxSurface>);

}  // namespace limitcurve::godobject
