// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/economised_elementary.hpp"
#include "limitcurve/economised_elliptic.hpp"
#include "limitcurve/elliptic.hpp"
#include "limitcurve/moment_series.hpp"

#include <cmath>
#include <concepts>

/// Unit wrenches in closed form, one function a pressure law: f, m and df/ds at s = c/a, for s ∈ [0, ∞].
///
/// Every form is written so that only positive terms meet (or nearly so), which the textbook forms are not:
/// those lose all digits of m as s → ∞. In long double three branches, each with its reason:
///   s ≤ 1        the COR is under the finger: polynomial, or elliptic integrals of modulus s;
///   1 < s² ≤ 2   the closed form for a COR outside, in τ = s² − 1 = (s−1)(s+1), which is exact near the rim;
///   s² > 2       the series in pressure moments (moment_series.hpp): converges fast and keeps m to relative precision.
/// In double and float the last two are piecewise polynomials (economised_*.hpp) in a variable in which the form is
/// analytic, w = √(1 − s⁻²), or, where it has a logarithm at the rim, in η = 1 − s⁻² down to ⅛ and the closed form below.
/// Relative error of f and m: ≤ 8 ε of Real, the cone's m ≤ 16 ε. df/ds: ≤ 64 ε. Cost: README, "Evaluators". What of
/// the three is not used costs nothing once the call is inlined.
namespace limitcurve::closed_form {

inline constexpr long double pi = 3.141592653589793238462643383279502884L;

namespace detail {
/// Beyond this square of s the closed forms outside the rim start to cancel, and the series is short.
inline constexpr double series_from = 2.0;

/// A form that is analytic in w = √(1 − s⁻²) ∈ [0, 1], for s > 1. At s = ∞: (1, 0), slope 0.
template <const auto& wrench, const auto& slope, class Real>
[[gnu::always_inline]] inline UnitForces<Real> outside_in_root(Real s) noexcept {
  static constexpr PiecewisePolynomials<Real, 9, 12, 2> wrenches(wrench);
  static constexpr PiecewisePolynomials<Real, 9, 12, 1> slopes(slope);
  // √((s−1)(s+1)) keeps the digits of w at the rim, which the flat punch's slope wants; beyond `far` it would overflow, and w is 1.
  constexpr Real far = sizeof(Real) == sizeof(float) ? Real(1e18) : Real(1e150);
  const Real near = s > far ? far : s;
  const auto place = place_in_equal_pieces<9>(std::sqrt((near - 1) * (near + 1)) * (1 / near));
  const Real q = 1 / s;
  const auto [force, moment] = wrenches.at(place);
  return {force, q * moment, q * q * q * slopes.at(place)[0]};
}

/// A form with a logarithm at the rim, for s⁻² ≤ ⅞. At s = ∞: (1, 0), slope 0.
template <const auto& wrench, const auto& slope, class Real>
[[gnu::always_inline]] inline UnitForces<Real> outside_in_complement(Real q) noexcept {
  static constexpr PiecewisePolynomials<Real, 12, 11, 2> wrenches(wrench);
  static constexpr PiecewisePolynomials<Real, 12, 12, 1> slopes(slope);
  const auto place = place_in_octaves<3>(1 - q * q);
  const auto [force, moment] = wrenches.at(place);
  return {force, q * moment, q * q * q * slopes.at(place)[0]};
}

/// Where the above ends.
inline constexpr double near_rim = 0.875;
}  // namespace detail

/// Hertz (n = ½): p = (3/2)(1−ρ²)^½ P/(πa²), the elastic sphere.
template <std::floating_point Real>
[[gnu::always_inline]] inline UnitForces<Real> hertz(Real s) noexcept {
  if (s <= 1) {
    const Real z = s * s;
    const Real scale = Real(3 * pi / 16);
    return {2 * scale * s * (1 - z / 4), scale * ((1 - s) * (1 + s) + Real(0.375) * z * z), 2 * scale * (1 - Real(0.75) * z)};
  }
  if constexpr (has_polynomials<Real>) {
    return detail::outside_in_root<economised::hertz_wrench, economised::hertz_slope>(s);
  } else {
    if (s * s > Real(detail::series_from)) return outside_series<PowerMoments<1, 2>>(s);
    const Real tau = (s - 1) * (s + 1);
    const Real t = std::sqrt(tau);
    const Real angle = std::atan2(Real(1), t);
    return {3 / (16 * s) * ((1 + tau) * (3 - tau) * angle + (3 + tau) * t),
            Real(3) / 64 * ((3 * (1 + tau * tau) - 2 * tau) * angle + 3 * (1 - tau) * t),
            Real(3) / 16 * ((1 - 3 * tau) * angle + (3 - 2 / (s * s)) * t)};
  }
}

/// Rigid flat punch (n = −½): p = ½(1−ρ²)^(−½) P/(πa²), infinite at the rim.
template <std::floating_point Real>
[[gnu::always_inline]] inline UnitForces<Real> flat_punch(Real s) noexcept {
  const Real quarter_pi = Real(pi / 4);
  if (s <= 1) return {quarter_pi * s, quarter_pi / 2 * (1 + (1 - s) * (1 + s)), quarter_pi};
  if constexpr (has_polynomials<Real>) {
    return detail::outside_in_root<economised::flat_punch_wrench, economised::flat_punch_slope>(s);
  } else {
    if (s * s > Real(detail::series_from)) return outside_series<PowerMoments<-1, 2>>(s);
    const Real tau = (s - 1) * (s + 1);
    const Real t = std::sqrt(tau);
    const Real angle = std::atan2(Real(1), t);
    return {(s * angle + t / s) / 2, ((1 - tau) * angle + t) / 4, (angle - t / (s * s)) / 2};
  }
}

/// Uniform (n = 0): p = P/(πa²). B, D as in elliptic.hpp, of modulus s or 1/s; η is the complement.
template <std::floating_point Real>
[[gnu::always_inline]] inline UnitForces<Real> uniform(Real s) noexcept {
  const Real scale = Real(4 / (3 * pi));
  if (s <= 1) {
    const Real eta = (1 - s) * (1 + s);
    const auto [b, d] = elliptic_pair(s, eta);
    const Real e = b + eta * d;
    return {scale * s * (b + e), scale / 3 * ((1 + 2 * eta) * e + s * s * b), scale * (b + 2 * eta * d)};
  }
  const Real q = 1 / s;
  if constexpr (has_polynomials<Real>) {
    if (q * q <= Real(detail::near_rim)) return detail::outside_in_complement<economised::uniform_wrench, economised::uniform_slope>(q);
  } else {
    if (s * s > Real(detail::series_from)) return outside_series<PowerMoments<0, 2>>(s);
  }
  const Real eta = (s - 1) * (s + 1) / (s * s);
  const auto [b, d] = elliptic_pair(q, eta);
  return {scale * (2 * b + eta * d), scale / 3 * s * ((2 - 3 * eta) * b + eta * d), scale * (b - eta * d) / s};
}

/// Parabolic (n = 1): p = 2(1−ρ²) P/(πa²), the elastic foundation (Winkler). Contiguous to the uniform law.
template <std::floating_point Real>
[[gnu::always_inline]] inline UnitForces<Real> parabolic(Real s) noexcept {
  const Real scale = Real(1 / (45 * pi));
  if (s <= 1) {
    const Real z = s * s;
    const Real eta = (1 - s) * (1 + s);
    const auto [b, d] = elliptic_pair(s, eta);
    const Real e = b + eta * d;
    return {8 * scale * s * ((8 + 4 * eta) * e + (6 + 2 * z) * b), 16 * scale / 5 * ((4 + (3 + 8 * eta) * eta) * e + 4 * z * (1 + eta) * b),
            8 * scale * ((4 + 8 * eta) * b + (2 + 16 * eta) * eta * d)};
  }
  const Real q = 1 / s;
  if constexpr (has_polynomials<Real>) {
    if (q * q <= Real(detail::near_rim)) return detail::outside_in_complement<economised::parabolic_wrench, economised::parabolic_slope>(q);
  } else {
    if (s * s > Real(detail::series_from)) return outside_series<PowerMoments<2, 2>>(s);
  }
  const Real eta = (s - 1) * (s + 1) / (s * s);
  const auto [b, d] = elliptic_pair(q, eta);
  const Real e = b + eta * d;
  return {2 * scale * s * s * ((32 - 24 * eta) * e + (32 - 48 * eta) * b),
          scale / 5 * s * s * s * (64 * (1 - 2 * eta) * e + (64 + (240 * eta - 176) * eta) * b),
          scale * s * ((32 - 96 * eta) * b + (16 + 48 * eta) * eta * d)};
}

/// Cone: p = arccosh(1/ρ) P/(πa²), infinite at the centre.
template <std::floating_point Real>
[[gnu::always_inline]] inline UnitForces<Real> cone(Real s) noexcept {
  if (s <= 1) {
    return {s * (Real(pi / 2) - 2 * s / 3), Real(pi / 6) - s * s * (Real(pi / 4) - 4 * s / 9), Real(pi / 2) - 4 * s / 3};
  }
  if constexpr (has_polynomials<Real>) {
    return detail::outside_in_root<economised::cone_wrench, economised::cone_slope>(s);
  } else {
    if (s * s > Real(detail::series_from)) return outside_series<ConeMoments>(s);
    const Real tau = (s - 1) * (s + 1);
    const Real t = std::sqrt(tau);
    const Real angle = std::atan2(Real(1), t);
    // s³ − t³ = (s² + st + t²)/(s + t), because s² − t² = 1: the difference of the cubes does not cancel.
    const Real cubes = (s * s + s * t + tau) / (s + t);
    return {s * angle + (t - 2 * cubes / 3) / s, 4 * cubes / 9 - (s * s / 2 - Real(1) / 3) * angle - t / 6,
            angle + 2 * t - 4 * s / 3 - t / (s * s) * (1 + 2 * tau / 3)};
  }
}

}  // namespace limitcurve::closed_form
