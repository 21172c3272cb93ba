// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve::test {

/// A limit curve of somebody's own, x^n + y^n = 1 with x = f/A and y = m/B: near the axes its
/// normal turns like x^(n−1). For n < 2 the curvature there is infinite, for n > 2 zero.
struct Superellipse {
  double force_max;
  double moment_max;
  double exponent;

  [[nodiscard]] double moment_ratio() const noexcept { return moment_max / force_max; }

  /// With p = Av and q = Bw the smaller of x, y is (smaller of p, q/larger)^{1/(n−1)} times the
  /// larger, which is (1 + ratioⁿ)^{−1/n}.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    if (twist.is_zero()) return {};
    twist = twist.direction();
    const double p = force_max * twist.slide;
    const double q = moment_max * twist.spin;
    const double ratio = std::pow(std::min(p, q) / std::max(p, q), 1.0 / (exponent - 1.0));
    const double larger = 1.0 / length_of(ratio);
    return p >= q ? UnitWrench{force_max * larger, moment_max * (ratio * larger)}
                  : UnitWrench{force_max * (ratio * larger), moment_max * larger};
  }

  /// d ln(y/x)/du = 1/((n−1)u(1−u)); at the ends that of u = 1e-80: for n > 2 it has no bound.
  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept {
    twist = twist.magnitudes();
    constexpr double end_distance = 1e-80;
    const double total = twist.slide + twist.spin;
    const double slide = std::max(twist.slide / total, end_distance);
    const double spin = std::max(twist.spin / total, end_distance);
    const UnitWrench wrench = this->wrench({slide, spin});
    const double x = wrench.force / force_max;
    const double y = wrench.moment / moment_max;
    const double turn = 1.0 / ((exponent - 1.0) * slide * spin);
    return {this->wrench(twist),
            {-wrench.force * std::pow(y, exponent) * turn, wrench.moment * std::pow(x, exponent) * turn}};
  }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    direction = direction.magnitudes();
    const double x = direction.force / force_max;
    const double y = direction.moment / moment_max;
    const double length = gauge(direction);
    const double normal = std::pow(std::min(x, y) / std::max(x, y), exponent - 1.0);
    return {{direction.force / length, direction.moment / length},
            x >= y ? SlipTwist{1.0 / force_max, normal / moment_max} : SlipTwist{normal / force_max, 1.0 / moment_max}};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    const auto [force, moment] = wrench.magnitudes();
    if (!(force + moment > 0.0 && force + moment <= std::numeric_limits<double>::max())) return force + moment;
    const double x = force / force_max;
    const double y = moment / moment_max;
    const double larger = std::max(x, y);
    return larger * length_of(std::min(x, y) / larger);
  }

 private:
  /// Of (1, ratio).
  [[nodiscard]] double length_of(double ratio) const noexcept {
    return std::pow(1.0 + std::pow(ratio, exponent), 1.0 / exponent);
  }
};

static_assert(LimitCurve<Superellipse>);

}  // namespace limitcurve::test
