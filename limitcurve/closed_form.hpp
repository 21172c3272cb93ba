// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/economised_cone.hpp"
#include "limitcurve/economised_flat_punch.hpp"
#include "limitcurve/economised_hertz.hpp"
#include "limitcurve/economised_outside.hpp"
#include "limitcurve/economised_parabolic.hpp"
#include "limitcurve/economised_uniform.hpp"
#include "limitcurve/elliptic.hpp"
#include "limitcurve/moment_series.hpp"
#include "limitcurve/piecewise_polynomial.hpp"

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

/// Unit wrenches in closed form, one function a pressure law: f, m and df/ds at s = c/a, for s ∈ [0, ∞].
///
/// Every form is written so that only positive terms meet (or nearly so), which the textbook forms are not:
/// those lose all digits of m as s → ∞. In long double three branches, each with its reason:
///   s ≤ 1        the COR is under the finger: polynomial, or elliptic integrals of modulus s;
///   1 < s² ≤ 2   the closed form for a COR outside, in τ = s² − 1 = (s−1)(s+1), which is exact near the rim;
///   s² > 2       the series in pressure moments (moment_series.hpp): converges fast and keeps m to relative precision.
/// In double and float the last two are piecewise polynomials (economised_*.hpp) in a variable in which the form is
/// analytic: s⁻² from s = 1 + 1/16 on; nearer to the rim w = √(1 − s⁻²), or, where there is a logarithm at the rim, the closed form.
/// Relative error of f and m: ≤ 8 ε of Real, the cone's m ≤ 16 ε. df/ds: ≤ 64 ε. Cost: README, "Evaluators". What of
/// the three is not used costs nothing once the call is inlined.
namespace limitcurve::closed_form {

inline constexpr long double pi = 3.141592653589793238462643383279502884L;

namespace detail {
/// Beyond this square of s the closed forms outside the rim start to cancel, and the series is short.
inline constexpr double series_from = 2.0;

/// s − 1 from which the polynomials in s⁻² serve; there 1 − s⁻² < ⅛.
inline constexpr double near_rim = 0.0625;

/// A form outside the rim, for s − 1 ≥ near_rim. At s = ∞: (1, 0), slope 0.
template <const auto& wrench, const auto& slope, class Real>
[[gnu::always_inline]] inline UnitForces<Real> away_from_rim(Real s) noexcept {
  constexpr std::size_t pieces = economised::outside_middles.size();
  static constexpr PiecewisePolynomials<Real, pieces, wrench.size() / (2 * pieces), 2> wrenches(wrench);
  static constexpr PiecewisePolynomials<Real, pieces, slope.size() / pieces, 1> slopes(slope);
  // The piece by the leading bits of s − 1, an eighth of an octave each, while the division is still under way: a call costs its latency.
  using Bits = limitcurve::detail::BitsOf<Real>;
  constexpr int eighths = std::numeric_limits<Real>::digits - 4;
  constexpr Real last = 4;  // from here to ∞ one piece
  const Real beyond = s - 1;
  const Real q = 1 / s;
  const auto piece = static_cast<std::size_t>((std::bit_cast<Bits>(beyond < last ? beyond : last) >> eighths) -
                                              (std::bit_cast<Bits>(static_cast<Real>(near_rim)) >> eighths));
  const PiecePlace<Real> place{piece, q * q - static_cast<Real>(economised::outside_middles[piece])};
  const auto [force, moment] = wrenches.at(place);
  return {force, q * moment, q * q * q * slopes.at(place)[0]};
}

/// A form that is analytic in w = √(1 − s⁻²), for s > 1.
template <const auto& wrench, const auto& slope, const auto& rim_wrench, const auto& rim_slope, class Real>
[[gnu::always_inline]] inline UnitForces<Real> outside(Real s) noexcept {
  if (s - 1 >= Real(near_rim)) return away_from_rim<wrench, slope>(s);
  constexpr std::size_t terms = rim_slope.size();
  static constexpr PiecewisePolynomials<Real, 1, terms, 2> wrenches(rim_wrench);
  static constexpr PiecewisePolynomials<Real, 1, terms, 1> slopes(rim_slope);
  const Real q = 1 / s;
  // (s−1)(s+1)/s², not 1 − s⁻², keeps the digits of w at the rim, which the flat punch's slope wants.
  const PiecePlace<Real> place{0, std::sqrt((s - 1) * (s + 1)) * q - Real(economised::rim_middle)};
  const auto [force, moment] = wrenches.at(place);
  return {force, q * moment, q * q * q * slopes.at(place)[0]};
}
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
    return detail::outside<economised::hertz_wrench, economised::hertz_slope, economised::hertz_rim_wrench, economised::hertz_rim_slope>(s);
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
    return detail::outside<economised::flat_punch_wrench, economised::flat_punch_slope, economised::flat_punch_rim_wrench,
                           economised::flat_punch_rim_slope>(s);
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
    if (s - 1 >= Real(detail::near_rim)) return detail::away_from_rim<economised::uniform_wrench, economised::uniform_slope>(s);
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
    if (s - 1 >= Real(detail::near_rim)) return detail::away_from_rim<economised::parabolic_wrench, economised::parabolic_slope>(s);
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
    return detail::outside<economised::cone_wrench, economised::cone_slope, economised::cone_rim_wrench, economised::cone_rim_slope>(s);
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
