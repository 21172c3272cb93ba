// SPDX-License-Identifier: MIT
#pragma once

#include "../contact.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace limitcurve::godobject {

/// Mass, inertia, gravity and free motions of a rigid body.
struct BodyParameters {
  double mass = 0.1;  ///< [kg], 1e-15 to 1e15
  Eigen::Vector3d inertia =
      Eigen::Vector3d::Constant(1e-4);          ///< principal moments about the centre of mass [kg m²], 1e-30 to 1e15
  Eigen::Vector3d gravity = {0.0, 0.0, -9.81};  ///< [m/s²], up to 1e15
  /// The velocities that are free, in world axes: three of the centre of mass, three of rotation. A body in the x-y
  /// plane has {1, 1, 0, 0, 0, 1}.
  std::array<bool, 6> free = {true, true, true, true, true, true};

  /// A block of even density with these edges [m] > 0. Throws std::invalid_argument with the parameter out of range.
  static BodyParameters block(double mass, const Eigen::Vector3d& edges);
  /// A ball, a cylinder and a capsule of even density; radius [m] > 0. Cylinder and capsule lie along z; the length [m]
  /// of the cylinder is > 0, that of the capsule, between the centres of its ends, ≥ 0. Throw like `block`.
  static BodyParameters ball(double mass, double radius);
  static BodyParameters cylinder(double mass, double radius, double length);
  static BodyParameters capsule(double mass, double radius, double length);
  /// A block that moves in the x-y plane only, with gravity [m/s²] along −y.
  static BodyParameters planar_block(double mass, const Eigen::Vector3d& edges, double gravity);

  /// Throws std::invalid_argument with the parameter, its value, unit and range, if one is out of range.
  void validate() const;
};

/// Pose and velocity of a body. The body's frame has its origin at the centre of mass and its axes along the principal
/// axes of inertia.
struct BodyState : BodyPose {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< [rad/s], world axes
};

/// The orientation after a rotation with the angular velocity ω [rad/s] (world axes) for a time [s]: exp(ω t/2) q, of
/// unit length. Sine and cosine of the half angle are those of the Cayley map, for example (1 − τ²)/(1 + τ²), with
/// τ = x + x³/3 and x = |ω|t/4. The axis is exact, and the relative error of the angle is of fourth order.
Orientation turned(const Orientation& orientation, const Eigen::Vector3d& angular_velocity, double time) noexcept;

/// The axis of that rotation times the tangent of a quarter of its angle.
Eigen::Vector3d quarter_turn(const Eigen::Vector3d& angular_velocity, double time) noexcept;

/// Kinetic energy [J].
double kinetic_energy(const BodyParameters& body, const BodyState& state) noexcept;
/// Potential energy in the body's gravity, 0 at the world's origin [J].
double gravity_energy(const BodyParameters& body, const BodyState& state) noexcept;
/// Angular momentum about the centre of mass, world axes [kg m²/s].
Eigen::Vector3d angular_momentum(const BodyParameters& body, const BodyState& state) noexcept;

}  // namespace limitcurve::godobject
