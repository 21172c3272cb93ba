// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

#include <boost/math/policies/policy.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace limitcurve {

/// Boost.Math's tanh–sinh rule. Built on first use, which every law's construction sees to; afterwards nothing here allocates, throws or locks:
/// eight rows of abscissas, step 2^−7 in the last, are what Boost has ready. An integrand that is no number gives NaN or ∞.
template <class Real>
[[nodiscard]] auto& tanh_sinh_rule() {
  using namespace boost::math::policies;
  using Rule = boost::math::quadrature::tanh_sinh<Real, policy<evaluation_error<ignore_error>, domain_error<ignore_error>>>;
  // How near to an end the rule looks, of half the interval. The most peaked law (xydas-kao:k=0.01) has its scale at 2^−100 of the radius.
  static Rule rule(/*rows=*/8, Real(1e-60L));
  return rule;
}

/// Values with the truncation error of each; rounding is the caller's to add.
template <std::size_t count, class Real>
struct Integrals {
  std::array<Real, count> value{};
  std::array<Real, count> error{};
};

/// ∫₀^length of the integrands [0, wanted), of `integrand(from_left, from_right)`, which returns the array of all `count`; the others are NaN.
/// Both distances keep their digits. Singularities inside the interval are not welcome: split there.
///
/// Rows are added until two agree to 2e-17 of the integral, in double to 1e-14; the error is their difference, far above that of the last row.
/// What lies within 1e-60 of the half interval from an end is left out: integrands that grow towards it no faster than (distance)^−½ are welcome.
/// At most 1200 evaluations for each integral.
template <std::size_t count, class Real, class Integrand>
[[nodiscard]] Integrals<count, Real> integrate(const Integrand& integrand, Real length, std::size_t wanted = count) noexcept {
  constexpr bool extended = sizeof(Real) > sizeof(double);
  constexpr Real agreement = extended ? Real(2e-17L) : Real(1e-14);
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  Integrals<count, Real> result;
  result.value.fill(nan);
  result.error.fill(nan);
  const Real half = length / 2;
  for (std::size_t i = 0; i < wanted; ++i) {
    // Boost gives the place and its distance from the nearer end, that from the left one as a negative number.
    const auto component = [&](Real, Real from_end) -> Real {
      const Real near = half * std::fabs(from_end);
      return from_end < 0 ? integrand(near, length - near)[i] : integrand(length - near, near)[i];
    };
    Real error = nan;
    result.value[i] = half * tanh_sinh_rule<Real>().integrate(component, Real(-1), Real(1), agreement, &error);
    result.error[i] = half * error;
  }
  return result;
}

}  // namespace limitcurve
