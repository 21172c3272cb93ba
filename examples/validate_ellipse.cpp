// SPDX-License-Identifier: MIT
// Job 2, validate: the error of the usual ellipse for each pressure law, and of the one that never
// holds too much.
#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/validate/validate.hpp"

#include <cmath>
#include <cstdio>

int main() {
  // Over-estimate of the capacity by the ellipse, in percent, from 30-digit arithmetic.
  const struct {
    limitcurve::Law law;
    double over_estimate;
  } laws[] = {{limitcurve::flat_punch(), 8.26},
              {limitcurve::uniform(), 7.04},
              {limitcurve::hertz(), 6.38},
              {limitcurve::parabolic(), 5.97}};

  bool right = true;
  for (const auto& [law, expected] : laws) {
    const limitcurve::ExactCurve exact(law);
    const auto ellipse = limitcurve::curve_error(limitcurve::Ellipse::through_intercepts(exact.moment_ratio()), exact);
    const auto inner = limitcurve::curve_error(limitcurve::inner_ellipse(exact), exact);
    std::printf(
        "%-10s ellipse too strong by %.2f %%, its COR %.2f to %.2f times the true one; inner ellipse too weak by %.2f "
        "%%\n",
        law->name().c_str(), 100.0 * ellipse.max_over_estimate, ellipse.min_cor_ratio, ellipse.max_cor_ratio,
        100.0 * inner.max_under_estimate);
    right = right && std::abs(100.0 * ellipse.max_over_estimate - expected) < 0.005 && inner.max_over_estimate < 1e-12;
  }
  return right ? 0 : 1;
}
