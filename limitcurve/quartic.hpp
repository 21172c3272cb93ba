// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/intercepts.hpp"
#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/number.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve {

/// The quartic x⁴ + y⁴ + κx²y² = 1 with x = f/A, y = m/B and 0 ≤ κ ≤ 6, where it is convex: 2 is the ellipse, 6 is nearly
/// a diamond (flat on the diagonal), 0 nearly a box (flat at the ends). Fitted to a law (minimax_quartic in
/// boundary_error.hpp) it is off by some 0.65 %, and unlike the superellipse it turns as it should at both ends.
///
/// A limit boundary; no trigonometry, no iteration: two square roots and a cube root at most. Relative error of both
/// components ≤ 16 ε for κ away from 0 and 6; where a side is flat (κ = 6 at the diagonal) the place on it is as
/// uncertain as the twist makes it, the distance along the normal is not.
class Quartic {
 public:
  /// Intercepts in unit wrenches, > 0 and finite, and κ ∈ [0, 6]; throws std::invalid_argument otherwise.
  Quartic(double force_max, double moment_max, double kappa) : force_max_(force_max), moment_max_(moment_max), kappa_(kappa) {
    check_intercepts(force_max, moment_max);
    if (!(kappa >= 0.0 && kappa <= 6.0)) throw out_of_range("kappa", kappa, "1", "0 <= kappa <= 6");
  }

  /// Through (1, 0) and (0, m₀).
  static Quartic through_intercepts(double moment_ratio, double kappa) { return {1.0, moment_ratio, kappa}; }

  [[nodiscard]] double force_max() const noexcept { return force_max_; }
  [[nodiscard]] double moment_max() const noexcept { return moment_max_; }
  [[nodiscard]] double kappa() const noexcept { return kappa_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max_ / force_max_; }

  /// Support point: with t the smaller of (Av, Bw) over the larger, r = smaller of (x, y) over the larger solves
  /// t = r(2r² + κ)/(2 + κr²), and the larger is (1 + κr² + r⁴)^{−1/4}.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const double p = force_max_ * twist.slide;
    const double q = moment_max_ * twist.spin;
    const double ratio = ratio_of(std::min(p, q) / std::max(p, q));
    const double larger = 1.0 / unit_length(ratio);
    return between_intercepts(force_max_, moment_max_, p >= q, larger, ratio);
  }

  /// Where a side is flat (κ = 0 at the ends, κ = 6 at the diagonal) the slope is infinite; given large but finite.
  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept {
    const double total = twist.slide + twist.spin;
    const double p = force_max_ * (twist.slide / total);
    const double q = moment_max_ * (twist.spin / total);
    const bool sliding = p >= q;
    const double greater = std::max(p, q);
    const double ratio = ratio_of(std::min(p, q) / greater);
    const double square = ratio * ratio;
    const double larger = 1.0 / unit_length(ratio);
    // dt/dr = (2κ + (12 − κ²)r² + 2κr⁴)/(2 + κr²)², written so that nothing cancels towards κ = 6, r = 1.
    const double gap = (1.0 - ratio) * (1.0 + ratio);
    const double stiff = 2.0 * kappa_ * gap * gap + (6.0 - kappa_) * (2.0 + kappa_) * square;
    const double denominator = 2.0 + kappa_ * square;
    const double rate = denominator * denominator / std::max(stiff, flattest);
    // d(1, r)·larger/dr, with length⁴ = 1 + κr² + r⁴.
    const double quarter = larger * larger * larger * larger * larger;
    const double larger_rate = -quarter * ratio * (0.5 * kappa_ + square);
    const double smaller_rate = quarter * (1.0 + 0.5 * kappa_ * square);
    // t = Bu/(A(1−u)) or its inverse: |dt/du| = AB/greater².
    const double turn = rate * (force_max_ * moment_max_) / (greater * greater);
    if (sliding) {
      return {{force_max_ * larger, moment_max_ * (ratio * larger)},
              {force_max_ * (larger_rate * turn), moment_max_ * (smaller_rate * turn)}};
    }
    return {{force_max_ * (ratio * larger), moment_max_ * larger},
            {-force_max_ * (smaller_rate * turn), -moment_max_ * (larger_rate * turn)}};
  }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    const double x = direction.force / force_max_;
    const double y = direction.moment / moment_max_;
    const double ratio = std::min(x, y) / std::max(x, y);
    const double square = ratio * ratio;
    const double length = std::max(x, y) * unit_length(ratio);
    const double major = 2.0 + kappa_ * square;
    const double minor = ratio * (2.0 * square + kappa_);
    return {{direction.force / length, direction.moment / length},
            x >= y ? SlipTwist{major / force_max_, minor / moment_max_} : SlipTwist{minor / force_max_, major / moment_max_}};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return symmetric_gauge(force_max_, moment_max_, wrench, [this](double ratio) { return unit_length(ratio); });
  }

 private:
  /// Least dt/dr that is divided by: what remains of it one rounding away from a flat place.
  static constexpr double flattest = 1e-32;

  /// (1 + κr² + r⁴)^{1/4}: length of (1, r).
  [[nodiscard]] double unit_length(double ratio) const noexcept {
    const double square = ratio * ratio;
    return std::sqrt(std::sqrt(1.0 + square * (kappa_ + square)));
  }

  /// r ∈ [0, 1] with 2r³ − κt r² + κr − 2t = 0 for t ∈ [0, 1]. With r = κt/6 + z: z³ + Pz = Q, P ≥ 0, whose one real root
  /// is Cardano's U − V; as Q/(U² + UV + V²) it does not cancel. Relative error ≤ 12 ε.
  [[nodiscard]] double ratio_of(double t) const noexcept {
    const double centre = kappa_ * t / 6.0;
    const double third_p = kappa_ / 6.0 * (1.0 - centre * t);
    const double half_q = 0.5 * t * (1.0 - kappa_ * (kappa_ / 12.0) + kappa_ * centre * centre / 3.0);
    const double size = std::fabs(half_q);
    // hypot: the squares of a small t would underflow.
    const double u = std::cbrt(size + std::hypot(size, third_p * std::sqrt(third_p)));
    if (u == 0.0) return centre;
    const double v = third_p / u;
    const double z = 2.0 * half_q / (u * u + third_p + v * v);
    return std::clamp(centre + z, 0.0, 1.0);
  }

  double force_max_;
  double moment_max_;
  double kappa_;
};

static_assert(LimitBoundary<Quartic>);

}  // namespace limitcurve
