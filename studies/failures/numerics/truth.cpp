// SPDX-License-Identifier: MIT
#include "truth.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

namespace limitcurve::stability {

namespace {

const Exact pi = boost::math::constants::pi<Exact>();

/// ₂F₁(a, b; c; z), 0 ≤ z < 1, or z = 1 by Gauss's theorem (DLMF 15.4.20).
Exact hypergeometric(const Exact& a, const Exact& b, const Exact& c, const Exact& z) {
  using boost::math::tgamma;
  if (z == 1) return tgamma(c) * tgamma(Exact(c - a - b)) / (tgamma(Exact(c - a)) * tgamma(Exact(c - b)));
  const Exact enough("1e-60");
  Exact term = 1;
  Exact sum = 1;
  for (int k = 0; term != 0 && (k < 20 || abs(term) > enough * abs(sum) * (1 - z)); ++k) {
    term *= (a + k) * (b + k) / ((c + k) * (k + 1)) * z;
    sum += term;
  }
  return sum;
}

}  // namespace

ExactWrench exact_power(double exponent, double distance) {
  using boost::math::tgamma;
  const Exact n = exponent;
  const Exact s = distance;
  const Exact half = 0.5;
  if (s <= 1) {
    const Exact m0 = tgamma(Exact(1.5)) * tgamma(Exact(n + 2)) / tgamma(Exact(n + 2.5));
    return {(n + 1.5) * m0 * s * hypergeometric(half, -n - half, 2, s * s),
            m0 * hypergeometric(half, -n - 1.5, 1, s * s)};
  }
  const Exact z = 1 / (s * s);
  return {hypergeometric(-half, half, n + 2, z), hypergeometric(half, half, n + 3, z) / (2 * (n + 2) * s)};
}

ExactWrench exact_hertz(double distance) {
  const Exact s = distance;
  const Exact z = s * s;
  if (s <= 1) return {3 * pi / 8 * s * (1 - z / 4), 3 * pi / 16 * (1 - z + Exact(3) / 8 * z * z)};
  const Exact angle = asin(Exact(1 / s));
  const Exact root = sqrt(Exact(z - 1));
  return {3 / (16 * s) * (z * (4 - z) * angle + (z + 2) * root),
          Exact(3) / 64 * ((8 - 8 * z + 3 * z * z) * angle + 3 * (2 - z) * root)};
}

ExactWrench exact_flat_punch(double distance) {
  const Exact s = distance;
  const Exact z = s * s;
  if (s <= 1) return {pi / 4 * s, pi / 4 * (1 - z / 2)};
  const Exact angle = asin(Exact(1 / s));
  return {(s * angle + sqrt(Exact(1 - 1 / z))) / 2, ((1 - z / 2) * angle + sqrt(Exact(z - 1)) / 2) / 2};
}

ExactWrench exact_cone(double distance) {
  const Exact s = distance;
  const Exact z = s * s;
  if (s <= 1) return {pi / 2 * s - 2 * z / 3, pi / 6 - pi / 4 * z + 4 * z * s / 9};
  const Exact angle = asin(Exact(1 / s));
  const Exact t = sqrt(Exact(z - 1));
  return {(z * angle + t + 2 * t * t * t / 3 - 2 * z * s / 3) / s,
          (Exact(1) / 3 - z / 2) * angle - t / 6 - 4 * t * t * t / 9 + 4 * z * s / 9};
}

double relative_error(double value, const Exact& exact) {
  if (std::isnan(value)) return std::numeric_limits<double>::infinity();
  return std::max(static_cast<double>(abs(Exact(value / exact - 1))), 0x1p-54);
}

}  // namespace limitcurve::stability
