// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/quadrature/elliptic.hpp"
#include "limitcurve/quadrature/moment_series.hpp"

#include <cmath>
#include <concepts>

/// Closed forms of the unit wrench, one function for each pressure law: f, m and df/ds at s = c/a ∈ [0, ∞].
///
/// Almost all sums have positive terms only. In the textbook forms terms cancel, and all digits of m are lost as s → ∞.
/// Three branches:
///   s ≤ 1        the COR is under the finger: polynomial, or elliptic integrals of modulus s;
///   1 < s² ≤ 2   the closed form for a COR outside, in τ = s² − 1 = (s−1)(s+1), which is exact near the rim;
///   s² > 2       the series in pressure moments (moment_series.hpp), which converges fast and keeps the relative
///                precision of m.
/// Relative error of f and m: ≤ 8 ε of Real, the cone's m ≤ 16 ε. df/ds: ≤ 64 ε. Cost: limitcurve/README.md,
/// "Evaluators".
namespace limitcurve::closed_form {

inline constexpr long double pi = 3.141592653589793238462643383279502884L;

/// The series is used for s² above this: there terms of the closed forms begin to cancel, and the series is short.
inline constexpr double series_from = 2.0;

/// Hertz (n = ½): p = (3/2)(1−ρ²)^½ P/(πa²), the elastic sphere.
template <std::floating_point Real>
UnitForces<Real> hertz(Real s) noexcept {
  if (s <= 1) {
    const Real z = s * s;
    const Real scale = Real(3 * pi / 16);
    return {2 * scale * s * (1 - z / 4), scale * ((1 - s) * (1 + s) + Real(0.375) * z * z),
            2 * scale * (1 - Real(0.75) * z)};
  }
  if (s * s > Real(series_from)) return outside_series<PowerMoments<1, 2>>(s);
  const Real tau = (s - 1) * (s + 1);
  const Real t = std::sqrt(tau);
  const Real angle = std::atan2(Real(1), t);
  return {3 / (16 * s) * ((1 + tau) * (3 - tau) * angle + (3 + tau) * t),
          Real(3) / 64 * ((3 * (1 + tau * tau) - 2 * tau) * angle + 3 * (1 - tau) * t),
          Real(3) / 16 * ((1 - 3 * tau) * angle + (3 - 2 / (s * s)) * t)};
}

/// Rigid flat punch (n = −½): p = ½(1−ρ²)^(−½) P/(πa²), infinite at the rim.
template <std::floating_point Real>
UnitForces<Real> flat_punch(Real s) noexcept {
  const Real quarter_pi = Real(pi / 4);
  if (s <= 1) return {quarter_pi * s, quarter_pi / 2 * (1 + (1 - s) * (1 + s)), quarter_pi};
  if (s * s > Real(series_from)) return outside_series<PowerMoments<-1, 2>>(s);
  const Real tau = (s - 1) * (s + 1);
  const Real t = std::sqrt(tau);
  const Real angle = std::atan2(Real(1), t);
  return {(s * angle + t / s) / 2, ((1 - tau) * angle + t) / 4, (angle - t / (s * s)) / 2};
}

/// Uniform (n = 0): p = P/(πa²). B, D as in elliptic.hpp, of modulus s or 1/s; η is the complement.
template <std::floating_point Real>
UnitForces<Real> uniform(Real s) noexcept {
  const Real scale = Real(4 / (3 * pi));
  if (s <= 1) {
    const Real eta = (1 - s) * (1 + s);
    const auto [b, d] = elliptic_pair(s, eta);
    const Real e = b + eta * d;
    return {scale * s * (b + e), scale / 3 * ((1 + 2 * eta) * e + s * s * b), scale * (b + 2 * eta * d)};
  }
  const Real q = 1 / s;
  if (s * s > Real(series_from)) return outside_series<PowerMoments<0, 2>>(s);
  const Real eta = (s - 1) * (s + 1) / (s * s);
  const auto [b, d] = elliptic_pair(q, eta);
  return {scale * (2 * b + eta * d), scale / 3 * s * ((2 - 3 * eta) * b + eta * d), scale * (b - eta * d) / s};
}

/// Parabolic (n = 1): p = 2(1−ρ²) P/(πa²), the elastic foundation (Winkler). Contiguous to the uniform law.
template <std::floating_point Real>
UnitForces<Real> parabolic(Real s) noexcept {
  const Real scale = Real(1 / (45 * pi));
  if (s <= 1) {
    const Real z = s * s;
    const Real eta = (1 - s) * (1 + s);
    const auto [b, d] = elliptic_pair(s, eta);
    const Real e = b + eta * d;
    return {8 * scale * s * ((8 + 4 * eta) * e + (6 + 2 * z) * b),
            16 * scale / 5 * ((4 + (3 + 8 * eta) * eta) * e + 4 * z * (1 + eta) * b),
            8 * scale * ((4 + 8 * eta) * b + (2 + 16 * eta) * eta * d)};
  }
  const Real q = 1 / s;
  if (s * s > Real(series_from)) return outside_series<PowerMoments<2, 2>>(s);
  const Real eta = (s - 1) * (s + 1) / (s * s);
  const auto [b, d] = elliptic_pair(q, eta);
  const Real e = b + eta * d;
  return {2 * scale * s * s * ((32 - 24 * eta) * e + (32 - 48 * eta) * b),
          scale / 5 * s * s * s * (64 * (1 - 2 * eta) * e + (64 + (240 * eta - 176) * eta) * b),
          scale * s * ((32 - 96 * eta) * b + (16 + 48 * eta) * eta * d)};
}

/// Cone: p = arccosh(1/ρ) P/(πa²), infinite at the centre.
template <std::floating_point Real>
UnitForces<Real> cone(Real s) noexcept {
  if (s <= 1) {
    return {s * (Real(pi / 2) - 2 * s / 3), Real(pi / 6) - s * s * (Real(pi / 4) - 4 * s / 9),
            Real(pi / 2) - 4 * s / 3};
  }
  if (s * s > Real(series_from)) return outside_series<ConeMoments>(s);
  const Real tau = (s - 1) * (s + 1);
  const Real t = std::sqrt(tau);
  const Real angle = std::atan2(Real(1), t);
  // s³ − t³ = (s² + st + t²)/(s + t), because s² − t² = 1: the difference of the cubes does not cancel.
  const Real cubes = (s * s + s * t + tau) / (s + t);
  return {s * angle + (t - 2 * cubes / 3) / s, 4 * cubes / 9 - (s * s / 2 - Real(1) / 3) * angle - t / 6,
          angle + 2 * t - 4 * s / 3 - t / (s * s) * (1 + 2 * tau / 3)};
}

}  // namespace limitcurve::closed_form
