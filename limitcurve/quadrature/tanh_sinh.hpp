// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace limitcurve {

/// The tanh–sinh rule (Takahasi and Mori 1974): the trapezoidal rule in t of x = tanh u, u = π/2 sinh t, on [−1, 1].
/// Its own, because one evaluation of an integrand gives force and moment, and each needs its own error; the rules of
/// libraries integrate one number.
template <class Real>
class TanhSinhRule {
 public:
  /// Two points of the rule, ±x.
  struct Node {
    Real from_end;  ///< 1 − x
    Real weight;    ///< dx/dt
  };

  /// Step of the first row; each further one halves it, down to 2^−7.
  static constexpr Real first_step = Real(0.5);

  /// It is built on first use, and the constructor of every law uses it first; later calls do not allocate, throw or
  /// lock.
  [[nodiscard]] static const TanhSinhRule& get() {
    static const TanhSinhRule rule;
    return rule;
  }
  /// The points that a row adds to those before it; without x = 0, whose weight is π/2.
  [[nodiscard]] const std::array<std::vector<Node>, 7>& rows() const noexcept { return rows_; }

 private:
  TanhSinhRule() {
    constexpr Real half_pi = Real(1.570796326794896619231321691639751442L);
    // Smallest distance from an end. The most peaked law (xydas-kao:k=0.01) has its scale at 2^−100 of the radius, and
    // below 1e-60 of it a part in 4e13 of its force.
    constexpr Real least = Real(1e-80L);
    Real step = first_step;
    for (std::size_t row = 0; row < rows_.size(); ++row, step /= 2) {
      for (int k = 1;; k += row == 0 ? 1 : 2) {
        const Real t = static_cast<Real>(k) * step;
        const Real u = half_pi * std::sinh(t);
        const Real from_end = std::exp(-u) / std::cosh(u);
        if (from_end < least) break;
        rows_[row].push_back({from_end, half_pi * std::cosh(t) / (std::cosh(u) * std::cosh(u))});
      }
    }
  }

  std::array<std::vector<Node>, 7> rows_;
};

/// Integrals and the truncation error of each. The caller adds rounding.
template <std::size_t count, class Real>
struct Integrals {
  std::array<Real, count> value{};
  std::array<Real, count> error{};
  /// The sum of the differences of the last four rows: an error of integrands that are not smooth,
  /// where one difference may be small by chance.
  std::array<Real, count> wavering{};
};

/// ∫₀^length of `integrand(from_left, from_right)`, an array of `count` numbers. The distances from both ends keep
/// their digits. Split the interval at singularities inside it. A component that is NaN gives NaN.
///
/// Rows are added until two agree in the first `wanted` components to 2e-17 of the integral, in double to 1e-14. The
/// error is the difference of the last two rows, which is much larger than the error of the last. The rule leaves out
/// 1e-80 of the half interval at each end: an integrand may grow there like (distance)^−½, not faster. At most 1200
/// evaluations.
template <std::size_t count, class Real, class Integrand>
[[nodiscard]] Integrals<count, Real> integrate(const Integrand& integrand, Real length,
                                               std::size_t wanted = count) noexcept {
  constexpr Real agreement = sizeof(Real) > sizeof(double) ? Real(2e-17L) : Real(1e-14);
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real half = length / 2;
  Integrals<count, Real> result;
  result.value.fill(nan);
  std::array<Real, count> before{};
  std::array<Real, count> earlier{};
  std::array<Real, count> sum = integrand(half, half);
  for (Real& one : sum) one *= Real(1.570796326794896619231321691639751442L);
  Real scale = half * TanhSinhRule<Real>::first_step;
  for (const auto& row : TanhSinhRule<Real>::get().rows()) {
    for (const auto& [from_end, weight] : row) {
      const Real near = half * from_end;
      const std::array<Real, count> left = integrand(near, length - near);
      const std::array<Real, count> right = integrand(length - near, near);
      for (std::size_t i = 0; i < count; ++i) sum[i] += weight * (left[i] + right[i]);
    }
    earlier = before;
    before = result.error;
    bool agree = true;
    for (std::size_t i = 0; i < count; ++i) {
      const Real now = scale * sum[i];
      result.error[i] = std::fabs(now - result.value[i]);
      result.value[i] = now;
      result.wavering[i] = result.error[i] + before[i] + earlier[i];
      agree = agree && (i >= wanted || result.error[i] <= agreement * std::fabs(now));
    }
    if (agree) break;
    scale /= 2;
  }
  return result;
}

}  // namespace limitcurve
