// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

/// The usual good integration of eq. (17) with Boost: the angle by complete elliptic integrals of their modulus, the
/// radius by a library's rule with a requested accuracy. It does not use the positions of the integrand's
/// singularities.
namespace limitcurve::stability::customary {

using Function = std::function<double(double)>;

/// The requested accuracy, for rules that accept one.
inline constexpr double asked = 1e-9;

/// The integrand of the unit force, (4/π) ρ g(ρ) φ(ρ, s), as in docs/theory.md.
inline Function force_integrand(Function density, double s) {
  return [density = std::move(density), s](double rho) {
    // Boost throws at modulus 1, so stay below it.
    const double q = std::min(std::min(rho, s) / std::max(rho, s), 1.0 - std::numeric_limits<double>::epsilon());
    if (q == 0.0) return 0.0;
    const double e = boost::math::ellint_2(q);
    const double kernel = rho <= s ? e : (e - (1.0 - q * q) * boost::math::ellint_1(q)) / q;
    return 4.0 / std::numbers::pi * rho * density(rho) * kernel;
  };
}

/// The result of a rule, and its optional error estimate.
struct Answer {
  double value;
  double stated_error;
};

inline Answer tanh_sinh(const Function& integrand, double from = 0.0, double to = 1.0) {
  static boost::math::quadrature::tanh_sinh<double> rule;
  Answer answer{};
  answer.value = rule.integrate(integrand, from, to, asked, &answer.stated_error);
  return answer;
}

/// Piece by piece between known points.
inline Answer tanh_sinh(const Function& integrand, const std::vector<double>& places) {
  Answer sum{};
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Answer piece = tanh_sinh(integrand, places[i], places[i + 1]);
    sum.value += piece.value;
    sum.stated_error += piece.stated_error;
  }
  return sum;
}

inline constexpr unsigned gauss_points = 30;

inline double gauss(const Function& integrand, const std::vector<double>& places = {0.0, 1.0}) {
  double value = 0.0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    value += boost::math::quadrature::gauss<double, gauss_points>::integrate(integrand, places[i], places[i + 1]);
  }
  return value;
}

/// 0, s if it is inside, 1.
inline std::vector<double> split_at(double s) {
  return s < 1.0 ? std::vector<double>{0.0, s, 1.0} : std::vector<double>{0.0, 1.0};
}

}  // namespace limitcurve::stability::customary
