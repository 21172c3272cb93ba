// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/wrench.hpp"

#include <algorithm>
#include <concepts>

namespace limitcurve {

/// A convex curve in the quadrant f, m ≥ 0, from (f_max, 0) to (0, m_max), known by the wrench that each slip
/// twist causes. The exact curve, the table, the ellipse and its kin and the uncoupled box all are one;
/// projections, gauges and the god-object are written once against this.
///
/// Requirements, each tested by name for every curve (tests/limitcurve/curve_suite.cpp):
///  - `wrench(t)`: the curve point that has t as an outward normal (any one of them where a face is flat);
///  - `point(t)`:  the same with its derivative in the spin fraction;
///  - `along(w)`:  the curve point on the ray through w ≠ 0, and the normal there (any one at a corner);
///  - `gauge(w)`:  the factor γ ≥ 0 with w/γ on the curve: < 1 holds, > 1 slips, 0 for w = 0;
///  - `moment_ratio()`: moment intercept over force intercept, m₀ = μ_r/(μ a).
/// None of them throws, allocates, locks, or loops without bound.
// clang-format off
template <class Curve>
concept LimitCurve = requires(const Curve& curve, SlipTwist twist, UnitWrench wrench) {
  { curve.wrench(twist) } noexcept -> std::same_as<UnitWrench>;
  { curve.point(twist) } noexcept -> std::same_as<SlopedPoint>;
  { curve.along(wrench) } noexcept -> std::same_as<RadialPoint>;
  { curve.gauge(wrench) } noexcept -> std::same_as<double>;
  { curve.moment_ratio() } noexcept -> std::same_as<double>;
};
// clang-format on

/// How far `wrench` is from the origin in units of the curve point on the same ray. Both components are
/// non-negative and collinear, so their sum serves as the length, without a square root.
constexpr double gauge_from(UnitWrench wrench, UnitWrench on_curve) noexcept {
  return (wrench.force + wrench.moment) / (on_curve.force + on_curve.moment);
}

/// Finds where the ray through `direction` meets a strictly convex curve, by Newton's method in the spin
/// fraction u, kept inside a bracket: f(u)·M − m(u)·F falls from M·f_max ≥ 0 at u = 0 to −F·m_max ≤ 0 at u = 1.
/// At most `search_limit` evaluations of `point` (4 to 7 as a rule).
template <class Curve>
RadialPoint search_along(const Curve& curve, UnitWrench direction, double u) noexcept {
  constexpr int search_limit = 60;
  double low = 0.0;
  double high = 1.0;
  SlopedPoint here = curve.point(SlipTwist::of_spin_fraction(u));
  for (int i = 0; i < search_limit; ++i) {
    const double cross = here.wrench.force * direction.moment - here.wrench.moment * direction.force;
    (cross > 0.0 ? low : high) = u;
    const double slope = here.slope.force * direction.moment - here.slope.moment * direction.force;
    double next = u - cross / slope;
    // A flat or singular place gives a step out of the bracket, or NaN: both fall to bisection.
    if (!(next > low && next < high)) next = cross == 0.0 ? u : 0.5 * (low + high);
    const double step = next - u;
    u = next;
    here = curve.point(SlipTwist::of_spin_fraction(u));
    if (step * step <= 1e-32 * u * (1.0 - u) || high - low < 1e-16) break;
  }
  return {here.wrench, SlipTwist::of_spin_fraction(u)};
}

}  // namespace limitcurve
