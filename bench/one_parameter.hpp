// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/exact_curve.hpp"
#include "limitcurve/limit_curve.hpp"
#include "tests/superellipse.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

/// Rivals in the charts: limit curves with one parameter beside the intercepts.
namespace limitcurve::bench {

/// x⁴ + y⁴ + κx²y² = 1 with x = f, y = m/m₀, 0 ≤ κ ≤ 6.
struct Quartic {
  double moment_ratio;
  double kappa;

  [[nodiscard]] double gauge(UnitWrench wrench) const {
    const double x = wrench.force * wrench.force;
    const double y = wrench.moment / moment_ratio * (wrench.moment / moment_ratio);
    return std::sqrt(std::sqrt(x * x + y * y + kappa * x * y));
  }

  /// With t the smaller of (v, m₀w) over the larger, r = smaller of (x, y) over the larger solves
  /// t(2 + κr²) = r(2r² + κ): r = κt/6 + z, z³ + 3pz = 2q, by Cardano.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const {
    const double q_slip = moment_ratio * twist.spin;
    const double t = std::min(twist.slide, q_slip) / std::max(twist.slide, q_slip);
    const double centre = kappa * t / 6.0;
    const double p = kappa / 6.0 - centre * centre;
    const double q = 0.5 * t + centre * (centre * centre - 0.25 * kappa);
    const double root = std::sqrt(q * q + p * p * p);
    const double ratio = centre + std::cbrt(q + root) + std::cbrt(q - root);
    const double larger = 1.0 / gauge({1.0, moment_ratio * ratio});
    return twist.slide >= q_slip ? UnitWrench{larger, moment_ratio * (ratio * larger)} : UnitWrench{ratio * larger, moment_ratio * larger};
  }
};

/// The curve `of(parameter)`, from `low` to `high`, with the least largest error of the radius
/// over 500 rays.
template <class Of>
auto best_of(const ExactCurve& exact, double low, double high, const Of& of) {
  const auto worst = [&](double parameter) {
    const auto curve = of(parameter);
    double error = 0.0;
    for (int i = 1; i < 500; ++i) {
      error = std::max(error, std::fabs(1.0 / curve.gauge(exact.wrench(SlipTwist::of_spin_fraction(i / 500.0))) - 1.0));
    }
    return error;
  };
  constexpr int bits = 20;
  return of(boost::math::tools::brent_find_minima(worst, low, high, bits).first);
}

}  // namespace limitcurve::bench
