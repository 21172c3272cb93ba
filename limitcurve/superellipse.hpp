// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/intercepts.hpp"
#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/number.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve {

/// The superellipse (f/A)ⁿ + (m/B)ⁿ = 1, n > 1: 2 is the ellipse, n → 1 the diamond, n → ∞ the box. One exponent fitted
/// to a law (minimax_superellipse in boundary_error.hpp) is off by some 0.9 %, where the ellipse is off by 6 to 8 %.
/// Its COR, though, is wrong without bound towards both ends unless n = 2: there the normal turns like xⁿ⁻¹, not like x.
///
/// A limit boundary; no trigonometry, two powers a call. Relative error of both components ≤ 4 ε(1 + 1/(n−1)) for every
/// twist, the ends included: a flatter side turns a small change of the twist into a large step along it.
class Superellipse {
 public:
  /// Intercepts in unit wrenches, > 0 and finite, and the exponent, > 1 and finite; throws std::invalid_argument otherwise.
  Superellipse(double force_max, double moment_max, double exponent)
      : force_max_(force_max), moment_max_(moment_max), exponent_(exponent), inverse_(1.0 / (exponent - 1.0)) {
    check_intercepts(force_max, moment_max);
    if (!(exponent > 1.0) || std::isinf(exponent)) throw out_of_range("exponent", exponent, "1", "> 1 and finite");
  }

  /// Through (1, 0) and (0, m₀).
  static Superellipse through_intercepts(double moment_ratio, double exponent) { return {1.0, moment_ratio, exponent}; }

  [[nodiscard]] double force_max() const noexcept { return force_max_; }
  [[nodiscard]] double moment_max() const noexcept { return moment_max_; }
  [[nodiscard]] double exponent() const noexcept { return exponent_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max_ / force_max_; }

  /// Support point. In the normalised plane x = f/A, y = m/B the normal is (p, q) = (Av, Bw) ∝ (xⁿ⁻¹, yⁿ⁻¹); hence the
  /// smaller of x, y is (smaller of p, q / larger)^{1/(n−1)} times the larger, which is (1 + ratioⁿ)^{−1/n}.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const double p = force_max_ * twist.slide;
    const double q = moment_max_ * twist.spin;
    const double ratio = std::pow(std::min(p, q) / std::max(p, q), inverse_);
    const double larger = std::pow(1.0 + std::pow(ratio, exponent_), -1.0 / exponent_);
    return between_intercepts(force_max_, moment_max_, p >= q, larger, ratio);
  }

  /// For n > 2 the slope is infinite at the ends; it is given as that of u = 1e-80 (large, finite).
  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept {
    const double total = twist.slide + twist.spin;
    const double slide = std::max(twist.slide / total, end_distance);
    const double spin = std::max(twist.spin / total, end_distance);
    // d ln(q/p)/du = 1/(u(1−u)); then d ln x = −yⁿ d ln(y/x), d ln y = xⁿ d ln(y/x).
    const UnitWrench near = wrench({slide, spin});
    const double force_share = std::pow(near.force / force_max_, exponent_);
    const double moment_share = std::pow(near.moment / moment_max_, exponent_);
    const double turn = inverse_ / (slide * spin);
    return {wrench(twist), {-near.force * (moment_share * turn), near.moment * (force_share * turn)}};
  }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    const double x = direction.force / force_max_;
    const double y = direction.moment / moment_max_;
    const double ratio = std::min(x, y) / std::max(x, y);
    const double length = std::max(x, y) * unit_length(ratio);
    const double normal = std::pow(ratio, exponent_ - 1.0);
    return {{direction.force / length, direction.moment / length},
            x >= y ? SlipTwist{1.0 / force_max_, normal / moment_max_} : SlipTwist{normal / force_max_, 1.0 / moment_max_}};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return symmetric_gauge(force_max_, moment_max_, wrench, [this](double ratio) { return unit_length(ratio); });
  }

 private:
  /// Keeps u⁻¹ finite at the ends.
  static constexpr double end_distance = 1e-80;

  /// (1 + ratioⁿ)^{1/n}: length of (1, ratio).
  [[nodiscard]] double unit_length(double ratio) const noexcept { return std::pow(1.0 + std::pow(ratio, exponent_), 1.0 / exponent_); }

  double force_max_;
  double moment_max_;
  double exponent_;
  double inverse_;  // 1/(n−1)
};

static_assert(LimitBoundary<Superellipse>);

}  // namespace limitcurve
