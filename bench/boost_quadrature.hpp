// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/wrench.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve::bench {

/// The best method of Boost.Math for eq. (17), for comparison: the angle by complete elliptic integrals (Carlson's, in double, not
/// promoted), the radius by its tanh–sinh rule to its default tolerance, split at the COR, the distances from COR and
/// rim exact. The rule is built once. Relative error some 1e-15.
class BoostQuadrature {
 public:
  /// f and m of a pressure g(ρ, 1 − ρ) = πa²p/P, s ∈ (0, ∞).
  template <class Pressure>
  [[nodiscard]] UnitWrench wrench(const Pressure& pressure, double s) {
    return {
        integrate(s, [&](double rho, double rim, double from_cor) { return pressure(rho, rim) * rho * kernels(rho, s, from_cor).force; }),
        integrate(s, [&](double rho, double rim, double from_cor) { return pressure(rho, rim) * rho * kernels(rho, s, from_cor).moment; })};
  }

 private:
  /// (4/π)·E or (4/π)·qB, by B + (1−q²)D = E.
  static UnitWrench kernels(double rho, double s, double from_cor) {
    using boost::math::policies::promote_double;
    constexpr boost::math::policies::policy<promote_double<false>> in_double;
    constexpr double scale = 1.2732395447351627;
    const double larger = std::max(rho, s);
    const double q = std::min(rho, s) / larger;
    const double complement = std::max(from_cor / larger * ((rho + s) / larger), std::numeric_limits<double>::min());
    const double d = boost::math::ellint_rd(0.0, complement, 1.0, in_double) / 3.0;
    const double b = boost::math::ellint_rf(0.0, complement, 1.0, in_double) - d;
    const double e = b + complement * d;
    return rho <= s ? UnitWrench{scale * e, scale * rho * q * b} : UnitWrench{scale * q * b, scale * rho * e};
  }

  template <class Integrand>
  [[nodiscard]] double integrate(double s, const Integrand& integrand) {
    const double split = std::min(s, 1.0);
    // Boost passes the distance from the nearer end, negative at the left end.
    const double inner = rule_.integrate(
        [&](double x, double end) {
          const double rho = end > 0.0 ? x : -end;
          const double to_split = end > 0.0 ? end : split - rho;
          return integrand(rho, (1.0 - split) + to_split, (s - split) + to_split);
        },
        0.0, split);
    if (s >= 1.0) return inner;
    return inner + rule_.integrate(
                       [&](double x, double end) {
                         const double rim = end > 0.0 ? end : (1.0 - s) + end;
                         const double from_cor = end > 0.0 ? (1.0 - s) - end : -end;
                         return integrand(x, rim, from_cor);
                       },
                       s, 1.0);
  }

  boost::math::quadrature::tanh_sinh<double> rule_;
};

}  // namespace limitcurve::bench
