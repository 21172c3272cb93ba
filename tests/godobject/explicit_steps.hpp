// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/grasp.hpp"

#include <Eigen/Geometry>

#include <span>

/// The integrators that are simpler than Grasp's own, to be compared with it.
namespace limitcurve::godobject::test {

enum class ExplicitRule {
  euler,       ///< place by the old velocity, velocity by the old forces: gains energy at every stiffness
  symplectic,  ///< place by the new velocity: loses the grip at kΔt²/m > 4, undamped
};

/// Moves a grasp by one time step [s] with the forces that its fingers exert now.
inline void step_explicitly(Grasp& grasp, std::span<const DevicePose> devices, double time_step, ExplicitRule rule) {
  const BodyParameters& body = grasp.parameters();
  const BodyState old = grasp.body();
  Eigen::Vector3d force = body.mass * body.gravity;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < grasp.finger_count(); ++i) {
    const FingerState& finger = grasp.finger(i).state();
    const Eigen::Vector3d place = Eigen::Vector3d(finger.goal.data()) - Eigen::Vector3d(finger.normal.data()) * finger.depth;
    const Eigen::Vector3d on_body = -grasp.force_on_user(i);
    force += on_body;
    moment += (old.orientation * place).cross(on_body) - grasp.moment_on_user(i);
  }
  moment -= old.angular_velocity.cross(angular_momentum(body, old));
  const Eigen::Vector3d turning = (old.orientation.conjugate() * moment).cwiseQuotient(body.inertia);
  BodyState next = old;
  next.velocity += force * (time_step / body.mass);
  next.angular_velocity += old.orientation * turning * time_step;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (!body.free[static_cast<std::size_t>(i)]) next.velocity[i] = old.velocity[i];
    if (!body.free[static_cast<std::size_t>(i) + 3]) next.angular_velocity[i] = old.angular_velocity[i];
  }
  const BodyState& mover = rule == ExplicitRule::symplectic ? next : old;
  next.position = old.position + mover.velocity * time_step;
  next.orientation = turned(old.orientation, mover.angular_velocity, time_step);
  grasp.carry(next, devices, time_step);
}

}  // namespace limitcurve::godobject::test
