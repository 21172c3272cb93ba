// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>

namespace limitcurve::godobject {

/// What a body is made of.
struct BodyParameters {
  double mass = 0.1;                                          ///< [kg] > 0
  Eigen::Vector3d inertia = Eigen::Vector3d::Constant(1e-4);  ///< principal moments about the centre of mass [kg m²], each > 0
  Eigen::Vector3d gravity = {0.0, 0.0, -9.81};                ///< [m/s²]
  /// Which velocities are free, in world axes: three of the centre of mass, three of rotation. The planar body of the
  /// x-y plane is {1, 1, 0, 0, 0, 1}.
  std::array<bool, 6> free = {true, true, true, true, true, true};

  /// A block of even density with these edges [m] > 0. Throws std::invalid_argument naming what is out of range.
  static BodyParameters block(double mass, const Eigen::Vector3d& edges);
  /// Of even density too: a ball [m] > 0; a cylinder and a capsule (both along z) of a length [m] > 0 and ≥ 0, that of the capsule
  /// between the centres of its ends. Throw like `block`.
  static BodyParameters ball(double mass, double radius);
  static BodyParameters cylinder(double mass, double radius, double length);
  static BodyParameters capsule(double mass, double radius, double length);
  /// A block moving in the x-y plane only, with gravity along −y.
  static BodyParameters planar_block(double mass, const Eigen::Vector3d& edges, double gravity);

  /// Throws std::invalid_argument naming the parameter, its value, unit and range.
  void validate() const;
};

/// Where a body is and how it moves. The body's frame has its origin in the centre of mass and its axes along the principal ones.
struct BodyState {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< of the centre of mass [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, of unit length
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< [rad/s], world axes

  [[nodiscard]] Eigen::Vector3d to_body(const Eigen::Vector3d& point) const noexcept {
    return orientation.conjugate() * (point - position);
  }
  [[nodiscard]] Eigen::Vector3d to_world(const Eigen::Vector3d& point) const noexcept { return position + orientation * point; }
};

/// The orientation after turning with the angular velocity ω (world axes) for a time: exp(ω t/2) q, normalised.
/// The half angle's sine and cosine are the Cayley map's, (1 − τ²)/(1 + τ²) with τ = |ω|t/4: exact in direction, third order
/// in the angle, without trigonometry, and of unit length by construction (to rounding, which is normalised away).
Eigen::Quaterniond turned(const Eigen::Quaterniond& orientation, const Eigen::Vector3d& angular_velocity, double time) noexcept;

/// Kinetic energy [J].
double kinetic_energy(const BodyParameters& body, const BodyState& state) noexcept;
/// Potential energy in the body's gravity, 0 at the world's origin [J].
double gravity_energy(const BodyParameters& body, const BodyState& state) noexcept;
/// Angular momentum about the centre of mass, world axes [kg m²/s].
Eigen::Vector3d angular_momentum(const BodyParameters& body, const BodyState& state) noexcept;

}  // namespace limitcurve::godobject
