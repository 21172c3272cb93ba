// SPDX-License-Identifier: MIT
#include "fit/ellipse_fit.hpp"

#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace limitcurve::fit {
namespace {

/// The radial error's sum of squares, straight from the definition and independent of the module.
double sum_of_squares(const Law& law, double force_max, double moment_max, std::size_t points) {
  double sum = 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    const double s = i + 1 == points ? std::numeric_limits<double>::infinity()
                                     : std::tan(std::acos(0.0) * static_cast<double>(i) / static_cast<double>(points - 1));
    const WrenchEstimate exact = law->evaluate(s);
    const double gauge = std::hypot(exact.wrench.force / force_max, exact.wrench.moment / moment_max);
    sum += (1.0 / gauge - 1.0) * (1.0 / gauge - 1.0);
  }
  return sum;
}

TEST(EllipseFit, ThroughTheInterceptsOverEstimatesByThePublishedAmounts) {
  const std::vector<std::pair<Law, double>> known{{flat_punch(), 0.0826}, {uniform(), 0.0704}, {hertz(), 0.0638}, {parabolic(), 0.0597}};
  for (const auto& [law, over] : known) {
    const EllipseFit fit = ellipse_through_intercepts(law);
    EXPECT_NEAR(fit.max_over_estimate, over, 6e-5) << law->name();
    EXPECT_LE(fit.max_under_estimate, 1e-15) << law->name();
    EXPECT_EQ(fit.report.at("moment_max").value, law->moment_ratio());
  }
}

TEST(EllipseFit, LeastSquaresIsAMinimumThatBruteForceFinds) {
  for (const Law& law : {flat_punch(), uniform(), hertz(), parabolic(), cone()}) {
    constexpr std::size_t points = 91;
    const EllipseFit fit = fit_ellipse(law, points);
    EXPECT_TRUE(fit.report.converged) << fit.report.message;
    // A compass search over both axes, from the intercepts.
    double a = 1.0;
    double b = law->moment_ratio();
    double best = sum_of_squares(law, a, b, points);
    for (double step = 0.05; step > 1e-9;) {
      bool improved = false;
      for (const auto& [da, db] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
        const double candidate = sum_of_squares(law, a + da, b + db, points);
        if (candidate >= best) continue;
        best = candidate;
        a += da;
        b += db;
        improved = true;
        break;
      }
      if (!improved) step /= 2.0;
    }
    EXPECT_NEAR(fit.ellipse.force_max(), a, 1e-7) << law->name();
    EXPECT_NEAR(fit.ellipse.moment_max(), b, 1e-7) << law->name();
    EXPECT_NEAR(fit.report.rms, std::sqrt(best / points), 1e-12) << law->name();
    EXPECT_GT(fit.report.at("force_max").std_error, 0.0);
    EXPECT_LT(fit.report.rms, ellipse_through_intercepts(law, points).report.rms);
  }
}

TEST(EllipseFit, RefusesTooFewPoints) {
  EXPECT_THROW(fit_ellipse(hertz(), 2), std::invalid_argument);
  EXPECT_THROW(ellipse_through_intercepts(hertz(), 0), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::fit
