// SPDX-License-Identifier: MIT
#pragma once

#include "bench/finger_motion.hpp"

#include <cmath>

/// The arithmetic between one proxy and the next, written plainly, to hold a whole step against: each begins where the last one left the
/// proxy, and so waits for all of these operations in turn, however many the processor does at a time. Sliding on a plane with one twist
/// and one load; nothing is checked, and nothing told but the proxy.
namespace limitcurve::godobject::bench {

struct NakedProxy {
  double x = 0.0;      ///< [m]
  double y = 0.0;      ///< [m]
  double turn = 0.0;   ///< angle [rad] times the arm by which it is a length [m]
  double place = 0.5;  ///< of the last slip on the curve
};

/// Limits of both naked curves, and the arm of their twist [m]: of the order of what parameters() gives.
inline constexpr double naked_reach = 1.2e-3;
inline constexpr double naked_arm = 2e-2;

/// Radial, ellipse: one root and one quotient, side by side.
[[gnu::noinline]] inline double step_radially(NakedProxy& proxy, const Sample& sample) noexcept {
  const double goal = naked_arm * sample.twist;
  const double x = proxy.x - sample.contact.point.x();
  const double y = proxy.y - sample.contact.point.y();
  const double turn = proxy.turn - goal;
  const double square = (x * x + y * y) + turn * turn;
  const double share = std::sqrt(square) * (naked_reach / square);
  proxy.x = sample.contact.point.x() + x * share;
  proxy.y = sample.contact.point.y() + y * share;
  proxy.turn = goal + turn * share;
  return proxy.turn;
}

/// Closest point by one step of Halley's from the last place, on the parabola (u(2 − u), 1 − u²) from axis to axis: a curve whose jet
/// costs nothing to have.
[[gnu::noinline]] inline double step_to_closest(NakedProxy& proxy, const Sample& sample) noexcept {
  const double goal = naked_arm * sample.twist;
  const double x = proxy.x - sample.contact.point.x();
  const double y = proxy.y - sample.contact.point.y();
  const double turn = proxy.turn - goal;
  const double r = std::sqrt(x * x + y * y);
  const double rho = std::fabs(turn);
  const double u = proxy.place;
  // The slip is along the curve's normal, which is (u, 1 − u).
  const double over_force = r * (1.0 / naked_reach) - u * (2.0 - u);
  const double over_moment = rho * (1.0 / naked_reach) - (1.0 - u * u);
  const double residual = (1.0 - u) * over_force - u * over_moment;
  const double fall = over_force + over_moment + 2.0 * ((1.0 - u) * (1.0 - u) + u * u);
  const double foot = u + residual * fall / (fall * fall - (3.0 - 6.0 * u) * residual);
  const double force_share = foot * (2.0 - foot) * (naked_reach / r);
  const double moment_share = (1.0 - foot * foot) * (naked_reach / rho);
  proxy.place = foot;
  proxy.x = sample.contact.point.x() + x * force_share;
  proxy.y = sample.contact.point.y() + y * force_share;
  proxy.turn = goal + turn * moment_share;
  return proxy.turn;
}

}  // namespace limitcurve::godobject::bench
