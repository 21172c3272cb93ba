// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace limitcurve {

/// One abscissa of the rule on [0, 1]: its distance from either end, both to full relative precision, and its weight.
template <class Real>
struct DoubleExponentialNode {
  Real from_left;
  Real from_right;
  Real weight;  ///< without the step h
};

/// Tanh–sinh quadrature (Takahasi and Mori 1974), level k with step 2^−k. Our own rather than Boost's, because an exact
/// curve is evaluated inside control loops: after the first construction nothing here allocates, throws or locks,
/// several integrals share their abscissas, and the distance from *both* ends is exact (the ring kernel needs it).
template <class Real>
class DoubleExponential {
 public:
  static constexpr int first_level = 2;
  static constexpr int last_level = 7;

  /// The shared rule. Built on first use (some 0.3 ms); every law's construction sees to it.
  static const DoubleExponential& rule();

  template <std::size_t count>
  struct Result {
    std::array<Real, count> value{};
    std::array<Real, count> error{};  ///< of truncation; rounding is the caller's to add
  };

  /// ∫₀^length of `count` integrands of one sign at once; `integrand(from_left, from_right)` returns their array.
  /// Endpoint singularities weaker than 1/x are welcome; interior ones are not: split there.
  ///
  /// Levels are added until two agree to `agreement`; the error returned is the difference of the last two in extended
  /// precision, where it is below what a double shows, and its square (relative) in double, where convergence is
  /// quadratic unless a feature of tiny weight hides beside a smooth rest. At most 2300 evaluations.
  template <std::size_t count, class Integrand>
  [[nodiscard]] Result<count> integrate(Integrand&& integrand, Real length) const noexcept {
    Result<count> result;
    std::array<Real, count> sums{};
    std::array<Real, count> previous{};
    for (int level = 0; level <= last_level; ++level) {
      add_side(left_[static_cast<std::size_t>(level)], integrand, length, sums);
      add_side(right_[static_cast<std::size_t>(level)], integrand, length, sums);
      const Real step = std::ldexp(length, -level);
      Real change = 0;
      for (std::size_t i = 0; i < count; ++i) {
        result.value[i] = step * sums[i];
        const Real difference = std::fabs(result.value[i] - previous[i]);
        result.error[i] = difference;
        if (difference > 0) change = std::fmax(change, difference / std::fabs(result.value[i]));
      }
      previous = result.value;
      if (level < first_level || !(change < agreement)) continue;
      if constexpr (!extended) {
        for (std::size_t i = 0; i < count; ++i) result.error[i] *= change;
      }
      break;
    }
    return result;
  }

 private:
  DoubleExponential();

  static constexpr bool extended = sizeof(Real) > sizeof(double);
  static constexpr Real agreement = extended ? Real(2e-17L) : Real(2e-11);
  /// A tail is cut after two falling terms that no longer change the sum. Falling: where the integrand is all at one
  /// end, the terms between the middle and there do not count either.
  static constexpr Real negligible = extended ? Real(1e-24L) : Real(1e-18);

  template <std::size_t count, class Integrand>
  static void add_side(const std::vector<DoubleExponentialNode<Real>>& nodes, Integrand& integrand, Real length,
                       std::array<Real, count>& sums) noexcept {
    int quiet = 0;
    std::array<Real, count> last{};
    for (const DoubleExponentialNode<Real>& node : nodes) {
      const std::array<Real, count> values = integrand(length * node.from_left, length * node.from_right);
      bool counts = false;
      for (std::size_t i = 0; i < count; ++i) {
        const Real term = node.weight * values[i];
        sums[i] += term;
        counts = counts || std::fabs(term) > negligible * std::fabs(sums[i]) || !(std::fabs(term) < std::fabs(last[i]));
        last[i] = term;
      }
      quiet = counts ? 0 : quiet + 1;
      if (quiet == 2) break;
    }
  }

  // Per level, the abscissas left and right of the middle, from the middle outwards.
  std::array<std::vector<DoubleExponentialNode<Real>>, last_level + 1> left_;
  std::array<std::vector<DoubleExponentialNode<Real>>, last_level + 1> right_;
};

extern template class DoubleExponential<double>;
extern template class DoubleExponential<Extended>;

}  // namespace limitcurve
