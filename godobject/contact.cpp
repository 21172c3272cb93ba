// SPDX-License-Identifier: MIT
#include "godobject/contact.hpp"

#include <cmath>

namespace limitcurve::godobject {

Spin Spin::moved(const Orientation& orientation, const Eigen::Vector3d& present_normal) const noexcept {
  Spin next{angle, plain::numbers(present_normal), plain::numbers(orientation.vec()), orientation.w(), true};
  if (!started) return next;
  const Orientation last(scalar, axis[0], axis[1], axis[2]);
  Orientation turn = orientation * last.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  // The turn as a vector ω Δt: its angle is 2 atan2(|v|, w).
  const double sine = turn.vec().norm();
  const double angle_per_sine = sine > 0.0 ? 2.0 * std::atan2(sine, turn.w()) / sine : 2.0;
  next.angle += angle_per_sine * 0.5 * turn.vec().dot(plain::vector(normal) + present_normal);
  return next;
}

}  // namespace limitcurve::godobject
