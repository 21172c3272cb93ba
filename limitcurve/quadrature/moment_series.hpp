// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/wrench.hpp"

#include <array>
#include <cstddef>

namespace limitcurve {

/// Even moments ⟨ρ^{2k}⟩ of the family (1−ρ²)ⁿ, n = numerator/denominator: k!/(n+2)_k.
template <int numerator, int denominator>
struct PowerMoments {
  static constexpr long double next_ratio(int k) {
    return (k + 1.0L) / (static_cast<long double>(numerator) / denominator + 2.0L + k);
  }
};

/// Even moments of the cone law: k!/((k+1)(3/2)_k).
struct ConeMoments {
  static constexpr long double next_ratio(int k) { return (k + 1.0L) * (k + 1.0L) / ((k + 2.0L) * (1.5L + k)); }
};

/// Coefficients of the series of the unit wrench outside the rim in z = s⁻²: the power series of the elliptic kernels
/// (DLMF 19.5.1, 19.5.2), integrated term by term:
///   f = Σ e_k ⟨ρ^{2k}⟩ z^k,  e_k = (−½)_k(½)_k/k!²;   m = s⁻¹ Σ b_k ⟨ρ^{2k+2}⟩ z^k,  b_k = ½(½)_k²/((2)_k k!).
template <class Real, class Moments>
struct OutsideSeries {
  /// Enough for z ≤ ½ and a mantissa of 64 bits: the terms fall faster than z^k/k².
  static constexpr std::size_t terms = sizeof(Real) > sizeof(double) ? 56 : 44;
  std::array<Real, terms> force{};
  std::array<Real, terms> moment{};
  std::array<Real, terms> slope{};  // of s³ df/ds = −2 Σ (k+1) f_{k+1} z^k

  constexpr OutsideSeries() {
    long double pressure_moment = 1.0L;
    long double e = 1.0L;
    long double b = 0.5L;
    for (std::size_t i = 0; i < terms; ++i) {
      const auto k = static_cast<long double>(i);
      const long double next_moment = pressure_moment * Moments::next_ratio(static_cast<int>(i));
      const long double next_e = e * (k - 0.5L) * (k + 0.5L) / ((k + 1.0L) * (k + 1.0L));
      force[i] = static_cast<Real>(e * pressure_moment);
      moment[i] = static_cast<Real>(b * next_moment);
      slope[i] = static_cast<Real>(-2.0L * (k + 1.0L) * next_e * next_moment);
      b *= (k + 0.5L) * (k + 0.5L) / ((k + 2.0L) * (k + 1.0L));
      e = next_e;
      pressure_moment = next_moment;
    }
  }
};

/// The unit wrench for s² ≥ 2 by the series above. At s = ∞: (1, 0), slope 0. Relative error ≤ 2 ε.
template <class Moments, class Real>
UnitForces<Real> outside_series(Real s) noexcept {
  static constexpr OutsideSeries<Real, Moments> series{};
  const Real q = 1 / s;
  const Real z = q * q;
  Real force = 0;
  Real moment = 0;
  Real slope = 0;
  for (std::size_t k = series.terms; k-- > 0;) {
    force = force * z + series.force[k];
    moment = moment * z + series.moment[k];
    slope = slope * z + series.slope[k];
  }
  return {force, q * moment, q * z * slope};
}

}  // namespace limitcurve
