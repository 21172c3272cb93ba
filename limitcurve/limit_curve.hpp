// SPDX-License-Identifier: MIT
#pragma once

#include "wrench.hpp"

#include <concepts>

namespace limitcurve {

/// A limit curve is a convex curve in the quadrant f, m ≥ 0, from (f_max, 0) to (0, m_max), in unit wrenches.
/// ExactCurve, Table, Ellipse and Polygon (box, diamond) model this concept. Errors and load curves are templates over
/// this concept.
///
/// Requirements; tests/limitcurve/curve_suite.cpp has a test for each, and runs it for every curve:
///  - `wrench(t)`: the curve point whose outward normal is the slip twist t; on a flat face any point of the face. A
///  zero twist gives
///                 wrench 0;
///  - `point(t)`:  the same point, with its derivative in the spin fraction u, for t ≠ 0;
///  - `along(w)`:  the curve point on the ray from the origin through w ≠ 0, and the normal there; at a corner any one
///  of
///                 its normals;
///  - `gauge(w)`:  the factor γ ≥ 0 for which w/γ is on the curve; γ < 1: the contact holds, γ > 1: it slips, γ = 0 for
///                 w = 0, ∞ for an infinite w;
///  - `moment_ratio()`: moment intercept divided by force intercept, m₀ = μ_r/(μ a).
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
