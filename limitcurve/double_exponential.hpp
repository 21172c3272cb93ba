// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace limitcurve {

/// The precision in which reference values are computed; results are rounded to double once, at the end.
using Extended = long double;

/// One abscissa of the rule on [0, 1]: its distance from either end, both to full relative precision, and its weight.
struct DoubleExponentialNode {
  Extended from_left;
  Extended from_right;
  Extended weight;  ///< without the step h
};

/// Tanh–sinh quadrature (Takahasi and Mori 1974), level k with step 2^−k. Our own rather than Boost's, because an exact
/// curve is evaluated inside control loops: after the first construction nothing here allocates, throws or locks,
/// several integrals share their abscissas, and the distance from *both* ends is exact (the ring kernel needs it).
class DoubleExponential {
 public:
  static constexpr int first_level = 2;
  static constexpr int last_level = 7;

  /// The shared rule. Built on first use (some 0.3 ms); laws touch it at construction.
  static const DoubleExponential& rule();

  template <std::size_t count>
  struct Result {
    std::array<Extended, count> value{};
    std::array<Extended, count> error{};  ///< of truncation; rounding is the caller's to add
  };

  /// ∫₀^length of `count` integrands of one sign at once; `integrand(from_left, from_right)` returns their array.
  /// Endpoint singularities weaker than 1/x are welcome; interior ones are not: split there.
  ///
  /// Error: the difference of the last two levels squared (relative) once the levels have been seen to converge
  /// quadratically, as they do for analytic integrands; else the difference itself. At most 2300 evaluations.
  template <std::size_t count, class Integrand>
  [[nodiscard]] Result<count> integrate(Integrand&& integrand, Extended length) const noexcept {
    Result<count> result;
    std::array<Extended, count> sums{};
    std::array<Extended, count> previous{};
    Extended last_change = 1;
    for (int level = 0; level <= last_level; ++level) {
      add_side(left_[static_cast<std::size_t>(level)], integrand, length, sums);
      add_side(right_[static_cast<std::size_t>(level)], integrand, length, sums);
      const Extended step = std::ldexp(length, -level);
      Extended change = 0;
      for (std::size_t i = 0; i < count; ++i) {
        result.value[i] = step * sums[i];
        const Extended difference = std::fabs(result.value[i] - previous[i]);
        result.error[i] = difference;
        if (difference > 0) change = std::fmax(change, difference / std::fabs(result.value[i]));
      }
      previous = result.value;
      const bool quadratic = change < 30 * last_change * std::sqrt(last_change);
      last_change = change;
      if (level < first_level || !(change < enough_change)) continue;
      if (!quadratic && change > 1e-17L) continue;
      for (std::size_t i = 0; i < count; ++i) result.error[i] *= change;
      break;
    }
    return result;
  }

 private:
  DoubleExponential();

  /// Levels closer than this differ from the integral by the square of it: below the last bit of a double.
  static constexpr Extended enough_change = 1e-10L;
  /// A tail is cut after two terms that no longer change the sum.
  static constexpr Extended negligible = 1e-24L;

  template <std::size_t count, class Integrand>
  static void add_side(const std::vector<DoubleExponentialNode>& nodes, Integrand& integrand, Extended length,
                       std::array<Extended, count>& sums) noexcept {
    int quiet = 0;
    for (const DoubleExponentialNode& node : nodes) {
      const std::array<Extended, count> values = integrand(length * node.from_left, length * node.from_right);
      bool counts = false;
      for (std::size_t i = 0; i < count; ++i) {
        const Extended term = node.weight * values[i];
        sums[i] += term;
        counts = counts || std::fabs(term) > negligible * std::fabs(sums[i]);
      }
      quiet = counts ? 0 : quiet + 1;
      if (quiet == 2) break;
    }
  }

  // Per level, the abscissas left and right of the middle, from the middle outwards.
  std::array<std::vector<DoubleExponentialNode>, last_level + 1> left_;
  std::array<std::vector<DoubleExponentialNode>, last_level + 1> right_;
};

}  // namespace limitcurve
