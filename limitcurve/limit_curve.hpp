// SPDX-License-Identifier: MIT
#pragma once

#include "wrench.hpp"

#include <concepts>

namespace limitcurve {

/// A limit curve is a convex curve in the quadrant f, m ≥ 0, from (f_max, 0) to (0, m_max), in unit wrenches.
/// ExactCurve, Table, Ellipse and Polygon (box, diamond) model this concept. Errors and load curves are templates over
/// this concept.
///
/// A curve must have these functions; tests/limitcurve/curve_suite.cpp tests each requirement for every curve:
///  - `wrench(t)` returns the curve point whose outward normal is the slip twist t. On a flat face, it may be any point
///    of the face. A zero twist gives wrench 0.
///  - `point(t)` returns that point for t ≠ 0, with the derivative in the spin fraction u.
///  - `along(w)` returns the curve point on the ray from the origin through w ≠ 0, and the normal there. At a
///    corner, it may be any normal of the corner.
///  - `gauge(w)` returns the factor γ ≥ 0 for which w/γ is on the curve. The contact holds if γ < 1 and slips if γ > 1;
///    γ is 0 for w = 0, and ∞ for an infinite w.
///  - `moment_ratio()` returns the moment intercept divided by the force intercept, m₀ = μ_r/(μ a).
/// Signs of t and w must be ignored, and results must be ≥ 0 (slopes as in SlopedPoint). The functions must not throw,
/// allocate or lock, and every loop must be bounded. NaN must give NaN. Results must stay accurate if twists and
/// wrenches are multiplied by 1e-120 … 1e120.
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

/// The gauge of `wrench`: its length divided by that of `on_curve`, the curve point on the same ray. Components are ≥ 0
/// and collinear, so the sum of the components replaces the length, and no square root is needed.
constexpr double gauge_from(UnitWrench wrench, UnitWrench on_curve) noexcept {
  return (wrench.force + wrench.moment) / (on_curve.force + on_curve.moment);
}

}  // namespace limitcurve
