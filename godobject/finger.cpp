// SPDX-License-Identifier: MIT
#include "godobject/finger.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace limitcurve::godobject {

using Eigen::Vector3d;

Vector3d FingerState::position() const noexcept {
  return vector(goal) - vector(normal) * depth;
}

FingerOutput FingerState::output() const noexcept {
  return {state, vector(proxy), angle, depth, vector(normal), load, vector(force), moment, cor, slip_work};
}

Vector3d FingerState::centre_of_rotation() const noexcept {
  // The proxy slides along −force and turns against the moment: v = ω n × (x_p − C). So C follows from the proxy, not from the finger.
  const Vector3d friction_force = vector(force);
  const double size = friction_force.norm();
  if (!(cor > 0.0) || size == 0.0) return vector(proxy) + Vector3d::Constant(0.0 * cor);
  return vector(proxy) - friction_force.cross(vector(normal)) * (std::copysign(cor, moment) / size);
}

}  // namespace limitcurve::godobject
