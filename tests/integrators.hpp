// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/body/grasp.hpp"

#include <Eigen/LU>

#include <span>

/// The integrators that simulators use, to be compared with Grasp's own.
namespace limitcurve::godobject::test {

enum class Integrator {
  implicit_euler,    ///< Grasp's own
  symplectic_euler,  ///< position from the new velocity: loses the grip at kΔt²/m > 4, undamped
};

/// A body's velocities after a step [s] under a force [N] and a moment about the centre of mass [N m], world axes.
/// Locked axes keep theirs: of the inertia only the free block is solved, since what locks an axis bears the moment
/// about it.
inline void accelerate(const BodyParameters& body, BodyState& state, const Eigen::Vector3d& force,
                       const Eigen::Vector3d& moment, double time_step) {
  const Eigen::Matrix3d axes = state.orientation.toRotationMatrix();
  Eigen::Matrix3d inertia = axes * body.inertia.asDiagonal() * axes.transpose();
  Eigen::Vector3d turning = moment - state.angular_velocity.cross(angular_momentum(body, state));
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (body.free[static_cast<std::size_t>(i)]) state.velocity[i] += force[i] * (time_step / body.mass);
    if (body.free[static_cast<std::size_t>(i) + 3]) continue;
    inertia.row(i).setZero();
    inertia.col(i).setZero();
    inertia(i, i) = 1.0;
    turning[i] = 0.0;
  }
  state.angular_velocity += inertia.partialPivLu().solve(turning) * time_step;
}

/// Moves a grasp by one time step [s]; by the symplectic integrator with the forces that its fingers exert now.
inline void step_by(Integrator integrator, Grasp& grasp, std::span<const DevicePose> devices, double time_step) {
  if (integrator == Integrator::implicit_euler) return grasp.step(devices, time_step);
  const BodyState old = grasp.body();
  Eigen::Vector3d force = grasp.parameters().mass * grasp.parameters().gravity;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < grasp.finger_count(); ++i) {
    // On the line through the finger, as Grasp has it.
    const Eigen::Vector3d on_body = -grasp.force_on_user(i);
    force += on_body;
    moment += (old.orientation * grasp.finger(i).state().sample.position()).cross(on_body) - grasp.moment_on_user(i);
  }
  BodyState next = old;
  accelerate(grasp.parameters(), next, force, moment, time_step);
  next.position = old.position + next.velocity * time_step;
  next.orientation = turned(old.orientation, next.angular_velocity, time_step);
  grasp.carry(next, devices, time_step);
}

}  // namespace limitcurve::godobject::test
