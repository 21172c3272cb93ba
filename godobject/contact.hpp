// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/version.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>

namespace limitcurve::godobject {

/// Three numbers of a state that is plain data.
using Numbers = std::array<double, 3>;
namespace plain {
[[nodiscard]] inline Eigen::Vector3d vector(const Numbers& numbers) noexcept {
  return {numbers[0], numbers[1], numbers[2]};
}
[[nodiscard]] inline Numbers numbers(const Eigen::Vector3d& vector) noexcept {
  return {vector.x(), vector.y(), vector.z()};
}
}  // namespace plain

/// Positions farther than this from the origin [m] are treated as device faults. Precisely: a sample is accepted if the
/// sum of the squares of its coordinates [m], its depth [m] and its twist [rad] is at most farthest²; NaN is rejected.
/// Put the origin near the contact, because at this distance positions, and with them loads, are rounded to 1e-10 m.
inline constexpr double farthest = 1e6;

/// Whether a sample is plausible (`farthest`), by the sum of squares of its coordinates, depth and twist.
template <class Real, class Number>
[[nodiscard]] constexpr auto is_plausible(Number sum_of_squares) noexcept {
  return sum_of_squares <= Number(static_cast<Real>(farthest * farthest));
}

/// A rotation: a quaternion of unit length. It converts from and to `Eigen::Quaterniond`, whose alignment depends on
/// the processor that a file is compiled for (-march=native): poses must have the same layout in your code and in the
/// library.
using Orientation = Eigen::Quaternion<double, Eigen::DontAlign>;

/// Takes a direction or an orientation by the rule of every door. Within 1e-6 of unit length, it keeps its bits. Within
/// 1e-2, it is normalised, because sensors round and engines count in single precision. Otherwise it is a fault, so
/// this returns false and changes nothing.
template <class Direction>
bool make_unit(Direction& direction) noexcept {
  const double square = direction.squaredNorm();
  if (std::fabs(square - 1.0) <= 2e-6) [[likely]]
    return true;
  if (!(std::fabs(std::sqrt(square) - 1.0) <= 1e-2)) return false;
  direction.normalize();
  return true;
}

/// The pose of a device's finger, in the frame of the surface.
struct DevicePose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< x_h [m]
  /// Of unit length, or within 1e-2 of it; its spin about the contact normal is twist.
  Orientation orientation = Orientation::Identity();
  double twist = 0.0;  ///< added twist about the contact normal [rad], for a device that measures an angle only
};

/// The pose of a body's frame in the world. A finger works in the frame of the body that it touches, even if that body
/// moves; `state` and `output` are in this frame. If your contacts are in the world's frame, call
/// `finger.update(to_body(body, contact), to_body(body, orientation), dt)` and use `to_world(body, output)`. If you
/// pass world coordinates instead, a body that moves beneath the finger causes no friction.
struct BodyPose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the body's origin [m]; of a free body the centre of mass
  Orientation orientation = Orientation::Identity();   ///< body to world, within 1e-2 of unit length

  /// The turn from the body's axes to the world's, normalised.
  [[nodiscard]] Orientation out_of_body() const noexcept { return into_body().conjugate(); }
  /// The inverse turn. If the orientation is no rotation, these turns are NaN, which the finger names as a fault.
  [[nodiscard]] Orientation into_body() const noexcept {
    Orientation turn = orientation.conjugate();
    if (!make_unit(turn)) turn.w() = std::numeric_limits<double>::quiet_NaN();
    return turn;
  }
  [[nodiscard]] Eigen::Vector3d to_body(const Eigen::Vector3d& point) const noexcept {
    return into_body() * (point - position);
  }
  [[nodiscard]] Eigen::Vector3d to_world(const Eigen::Vector3d& point) const noexcept {
    return position + out_of_body() * point;
  }
};

/// The state of a contact query between steps: the face that the finger is on, so that a finger pressed deep into a
/// thin plate does not come out at the other side. Plain data, one for each finger; a SoftFinger keeps the state of the
/// last good sample.
struct ContactMemory {
  int face = -1;       ///< the face touched in the last step; < 0: none
  Numbers finger{};    ///< the finger's position in the last step [m]
  bool known = false;  ///< whether there was a last step
};

/// The contact of a finger with a surface: the result of step a (paper, eq. 7).
struct Contact {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    ///< x_g, the surface point nearest the finger [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward normal there, within 1e-2 of unit length
  double depth = 0.0;                                 ///< d [m], depth of the finger beneath the surface; ≤ 0 outside
  ContactMemory memory = {};                          ///< to be passed to the next contact query
  /// Set this if, since the last sample, the finger left the surface and landed on it again, for example on another
  /// wall. The springs then start relaxed, as in a first contact. Your own surface may always leave it false; then only
  /// the first contact starts relaxed. If the finger landed on another body, which has a different frame, call
  /// `SoftFinger::reset` before the step instead.
  bool landed = false;
};

/// Orientation, device pose or contact, from the world's frame into the body's.
[[nodiscard]] inline Orientation to_body(const BodyPose& body, const Orientation& orientation) noexcept {
  return body.into_body() * orientation;
}
[[nodiscard]] inline DevicePose to_body(const BodyPose& body, const DevicePose& device) noexcept {
  const Orientation turn = body.into_body();
  return {turn * (device.position - body.position), turn * device.orientation, device.twist};
}
[[nodiscard]] inline Contact to_body(const BodyPose& body, const Contact& contact) noexcept {
  const Orientation turn = body.into_body();
  return {turn * (contact.point - body.position), turn * contact.normal, contact.depth, contact.memory, contact.landed};
}

/// The spin of a device about the surface normal along its path: ∫ω·n dt, n the current normal. For a moment M about
/// the normal the power is M·dα/dt. Moving without turning gives no spin, on any surface; the device's initial
/// orientation does not matter. A `SoftFinger` has its own Spin; a batch takes the angle. Plain data.
///
/// If an orientation moves around a cone and returns to where it was, the spin has grown by the solid angle,
/// 2π(1 − cos θ) per circle at θ rad. That is correct for a finger that rolls onto new skin. A pad that keeps its skin
/// is wound up as well, until it slips. For example, a hanging weight of half of what friction carries sinks by 4 mm in
/// 50 circles at 0.1 rad, and by 17 mm at 0.2 rad (Hertz, P = 1 N, μ = 0.6, a = 6 mm, k_l = 1000 N/m, k_r = 0.036 N
/// m/rad). If your pad only rocks, give its twist by `DevicePose::twist`, or in `update(contact, twist)`, and keep the
/// orientation still.
struct Spin {
  double angle = 0.0;   ///< [rad] since the first sample, unwrapped
  Numbers normal{};     ///< of the last sample
  Numbers axis{};       ///< of the last orientation, a unit quaternion: its vector part …
  double scalar = 1.0;  ///< … and its scalar part
  bool started = false;

  /// The spin after the next sample: the device's orientation and the outward normal, both of unit length and in the
  /// surface's frame. Assumes that the device turns about one axis by less than π between samples, and takes the mean
  /// of both normals. The error along a path is of second order in the time step, and 0 if the normal stays or turns
  /// evenly about that axis.
  [[nodiscard]] Spin moved(const Orientation& orientation, const Eigen::Vector3d& present_normal) const noexcept;
};

}  // namespace limitcurve::godobject
