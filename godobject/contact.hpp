// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace limitcurve::godobject {

/// Three numbers of a state that is plain data.
using Numbers = std::array<double, 3>;
[[nodiscard]] inline Eigen::Vector3d vector(const Numbers& numbers) noexcept {
  return {numbers[0], numbers[1], numbers[2]};
}
[[nodiscard]] inline Numbers numbers(const Eigen::Vector3d& vector) noexcept {
  return {vector.x(), vector.y(), vector.z()};
}

/// Where a device holds its finger. To begin with at the origin, not turned.
struct DevicePose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< x_h [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of unit length; what it spins about the contact normal is twist
  double twist = 0.0;  ///< turned beside that about the contact normal [rad]: of a device that gives an angle only
};

/// What a surface remembers of a finger between steps: which face it is on, so that a finger pressed deep into a thin
/// plate does not come out at the other side. Plain data, one for each finger; a SoftFinger keeps that of its last good sample.
struct ContactMemory {
  int face = -1;       ///< the face touched in the last step; < 0: none
  Numbers finger{};    ///< where the finger was then [m]
  bool known = false;  ///< there was a last step
};

/// Where a finger touches a surface: the result of step a (paper, eq. 7).
struct Contact {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< x_g, the surface point nearest the finger [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward unit normal there
  double depth = 0.0;                                 ///< d [m], how far the finger is beneath the surface; ≤ 0 outside
  ContactMemory memory = {};                          ///< what the surface needs to know in the next step
};

/// The spin of a device about the normal of the surface that it moves over: ∫ω·n dt, the normal being the present one. This is the path
/// integral whose power is M·dα/dt for a moment M about the normal: moving without turning gives none, on any surface, and the angle that a
/// device has to begin with does not matter. A `SoftFinger` has one in it; give a batch its angle. Plain data.
struct Spin {
  double angle = 0.0;   ///< [rad] since the first sample, unwrapped
  Numbers normal{};     ///< of the last sample
  Numbers axis{};       ///< of the last orientation, a unit quaternion: its vector part …
  double scalar = 1.0;  ///< … and its scalar part
  bool started = false;

  /// After the next sample: the device's orientation and the outward normal, both of unit length and in the surface's frame. Between two samples
  /// the device turns about one axis by less than π, and the normal counts as the mean of both: the error of a path falls with the square of
  /// the time step, and is 0 where the normal stays or turns evenly about the axis.
  [[nodiscard]] Spin moved(const Eigen::Quaterniond& orientation, const Eigen::Vector3d& present_normal) const noexcept;
};

}  // namespace limitcurve::godobject
