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

/// Boost.Math's tanh–sinh rule. It is built on first use, and the constructor of every law uses it first; later calls do not allocate,
/// throw or lock, because its eight rows of abscissas (step 2^−7 in the last) are then ready. An integrand that is NaN gives NaN or ∞.
template <class Real>
[[nodiscard]] auto& tanh_sinh_rule() {
  using namespace boost::math::policies;
  using Rule = boost::math::quadrature::tanh_sinh<Real, policy<evaluation_error<ignore_error>, domain_error<ignore_error>>>;
  // Smallest distance from an end, as a fraction of half the interval. The most peaked law (xydas-kao:k=0.01) has its scale at 2^−100 of
  // the radius.
  static Rule rule(/*rows=*/8, Real(1e-60L));
  return rule;
}

/// Integrals and the truncation error of each. The caller adds rounding.
template <std::size_t count, class Real>
struct Integrals {
  std::array<Real, count> value{};
  std::array<Real, count> error{};
};

/// ∫₀^length of the first `wanted` components of `integrand(from_left, from_right)`, an array of `count` numbers; the other results are
/// NaN. The distances from both ends keep their digits. Split the interval at singularities inside it.
///
/// Rows are added until two agree to 2e-17 of the integral, in double to 1e-14. The error is the difference of the last two rows, which is
/// much larger than the error of the last. The rule leaves out 1e-60 of the half interval at each end: an integrand may grow there like
/// (distance)^−½, not faster. At most 1200 evaluations for each integral.
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
    // Boost's second argument is the distance from the nearer end, negative for the left end.
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
