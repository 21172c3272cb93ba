// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

#include <array>

namespace limitcurve::table {

/// The smallest Bernstein coefficient of the polynomial Σ aᵢ uⁱ of degree 4 on [0, 1]: b_j = Σ_{i ≤ j} C(j,i)/C(4,i)
/// aᵢ. It is a lower bound of the polynomial on [0, 1].
inline Extended least_bernstein_coefficient(const std::array<Extended, 5>& a) noexcept {
  constexpr std::array<std::array<Extended, 5>, 5> choose{
      {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};
  Extended least = a[0];
  for (std::size_t j = 1; j < 5; ++j) {
    Extended sum = 0;
    for (std::size_t i = 0; i <= j; ++i) sum += choose[j][i] / choose[4][i] * a[i];
    // In this form a NaN becomes the result.
    least = sum >= least ? least : sum;
  }
  return least;
}

}  // namespace limitcurve::table
