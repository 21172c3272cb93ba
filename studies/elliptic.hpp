// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve::study {

/// Complete elliptic integrals of modulus q as the library has them inside (its quadrature/elliptic.hpp derives them): B = K − D and
/// D = (K − E)/q².
struct EllipticPair {
  double b, d;

  [[nodiscard]] double first_kind() const { return b + d; }
};

/// `complement` is 1 − q², passed so that it keeps its digits as q → 1. Relative error ≤ 8 ε.
inline EllipticPair elliptic_pair(double q, double complement) {
  constexpr double half_pi = 1.570796326794896619231;
  complement = std::max(complement, std::numeric_limits<double>::min());
  double a = 1.0, g = std::sqrt(complement), c = q, power = 0.5, sum = 0.5;
  for (int n = 0; n < 16; ++n) {
    const double next = 0.5 * (a + g);
    g = std::sqrt(a * g);
    c = n == 0 ? q / (4.0 * next) : q * c * c / (4.0 * next);
    a = next;
    power *= 2.0;
    sum += power * c * c;
    if (q * c <= std::numeric_limits<double>::epsilon() * a) break;
  }
  const double k = half_pi / a;
  if (complement >= 1.0 / 64) return {k * (1.0 - sum), k * sum};
  const EllipticPair other = elliptic_pair(std::sqrt(complement), q * q);
  const double b = (half_pi - complement * k * other.b) / (q * q * other.first_kind());
  return {b, k - b};
}

}  // namespace limitcurve::study
