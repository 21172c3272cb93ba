// SPDX-License-Identifier: MIT
#include "godobject/finger.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace limitcurve::godobject {

using Eigen::Vector3d;

Vector3d FingerState::centre_of_rotation() const noexcept {
  // The proxy moves by v = ω n × (x_p − C), against friction: C follows from the proxy, not from the finger.
  const bool is_round = patch.slip == Vector3d::Zero();
  const Vector3d slide = is_round ? output.force : Vector3d(patch.axis * patch.slip.x() + output.normal.cross(patch.axis) * patch.slip.y());
  const double turn = is_round ? output.moment : patch.slip.z();
  const double size = slide.norm();
  if (!(output.cor > 0.0) || size == 0.0) return output.proxy + Vector3d::Constant(0.0 * output.cor);
  return output.proxy + output.normal.cross(slide) * (std::copysign(output.cor, turn) / size);
}

}  // namespace limitcurve::godobject
