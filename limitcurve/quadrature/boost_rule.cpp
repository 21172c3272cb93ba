// SPDX-License-Identifier: MIT
#include "limitcurve/quadrature/evaluators.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace limitcurve::evaluators {

namespace {

namespace policies = boost::math::policies;
/// NaN in place of exceptions, and no detour by long double.
using Quiet = policies::policy<policies::promote_double<false>, policies::domain_error<policies::ignore_error>,
                               policies::overflow_error<policies::ignore_error>,
                               policies::evaluation_error<policies::ignore_error>>;

/// The kernels of docs/theory.md by Carlson's integrals: (2/π)·E, (2/π)·qB and the slope's (2/π)·D, by B + (1−q²)D = E.
UnitForces<double> ring_kernel_by_carlson(double rho, double s, double from_cor) {
  constexpr double scale = 0.6366197723675814;
  const double larger = std::max(rho, s);
  const double q = std::min(rho, s) / larger;
  const double complement = std::max(from_cor / larger * ((rho + s) / larger), std::numeric_limits<double>::min());
  const double d = boost::math::ellint_rd(0.0, complement, 1.0, Quiet()) / 3.0;
  const double b = boost::math::ellint_rf(0.0, complement, 1.0, Quiet()) - d;
  const double e = b + complement * d;
  if (rho <= s) return {scale * e, scale * rho * q * b, scale * q * d * (q / s)};
  return {scale * q * b, scale * rho * e, scale * d / rho};
}

/// ∫₀^length of integrand(from_left, from_right) ≥ 0, and a bound on its error: Boost's estimate, which is that of the
/// last row but one, and the rounding of the kernels and the pressure.
template <class Integrand>
std::pair<double, double> integrate_by_boost(const Integrand& integrand, double length, double tolerance) {
  static boost::math::quadrature::tanh_sinh<double, Quiet> rule;
  const double half = 0.5 * length;
  double error = 0.0;
  // Boost passes the distance from the nearer end of [−1, 1], negative at the left end.
  const double value = half * rule.integrate(
                                  [&](double, double end) {
                                    const double near = half * std::fabs(end);
                                    return end < 0.0 ? integrand(near, length - near) : integrand(length - near, near);
                                  },
                                  tolerance, &error);
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  return {value, half * error + rounding * value};
}

}  // namespace

Quadrature<double> boost(const PressureLaw& law, double s, Slope slope, double tolerance) noexcept {
  using Part = double UnitForces<double>::*;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(s)) return {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
  if (std::isnan(s)) return {{nan, nan, nan}, {nan, nan, nan}};
  const auto exponent = static_cast<double>(law.rim_exponent());
  const auto outer = static_cast<double>(law.breaks().back());
  Quadrature<double> sum{};
  const auto add = [&](double left, double right, Part part) {
    const double length = right - left;
    // The pressure grows like rim^exponent: on the last piece rim = length·y^power takes that factor into dy.
    const bool is_last = right == outer && exponent != 0.0;
    const double power = is_last ? 1.0 / (1.0 + exponent) : 1.0;
    const double scale = is_last ? std::pow(length, exponent) * power : 1.0;
    const auto integrand = [&](double from_left, double from_right) {
      if (is_last) {
        const double log_y = from_left < from_right ? std::log1p(-from_left / length) : std::log(from_right / length);
        from_left = length * -std::expm1(power * log_y);
        from_right = length * std::exp(power * log_y);
      }
      const double rho = from_left < from_right ? left + from_left : right - from_right;
      if (rho < std::numeric_limits<double>::min()) return 0.0;
      const double rim = (outer - right) + from_right;
      const double from_cor = s <= left ? (left - s) + from_left : (s - right) + from_right;
      const double weight = exponent != 0.0 && !is_last ? std::pow(rim, exponent) : scale;
      return 2.0 * rho * law.density(RadialPosition<double>{rho, rim}) * weight *
             ring_kernel_by_carlson(rho, s, from_cor).*part;
    };
    const auto [value, error] = integrate_by_boost(integrand, length, tolerance);
    sum.forces.*part += value;
    sum.error.*part += error;
  };
  const std::vector<Extended>& breaks = law.breaks();
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const auto left = static_cast<double>(breaks[i]);
    const auto right = static_cast<double>(breaks[i + 1]);
    const double split = std::clamp(s, left, right);
    for (const Part part :
         {&UnitForces<double>::force, &UnitForces<double>::moment, &UnitForces<double>::force_slope}) {
      if (part == &UnitForces<double>::force_slope && slope == Slope::unwanted) continue;
      if (left < split) add(left, split, part);
      if (split < right) add(split, right, part);
    }
  }
  return sum;
}

}  // namespace limitcurve::evaluators
