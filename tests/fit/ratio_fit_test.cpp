// SPDX-License-Identifier: MIT
#include "fit/ratio_fit.hpp"

#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::fit {

namespace {

double value(const FitReport& report, const char* name) {
  for (const Estimate& estimate : report.estimates) {
    if (estimate.name == name) return estimate.value;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// Weights 1 : 4, so the mean is 3.8 mm; χ² = (0.8/0.2)² + (0.2/0.1)² = 20 with one degree of freedom, beyond which
// erfc(√10) of all samples lie.
TEST(RatioFit, IsTheWeightedMeanWithTheChanceOfItsScatter) {
  const Law law = hertz();
  const FitReport report =
      fit_ratio(std::array{RatioSample{0.003, 0.0006, 9.0}, RatioSample{0.004, 0.0002, 4.0}}, *law);
  EXPECT_NEAR(value(report, "ratio"), 0.0038, 1e-15);
  EXPECT_NEAR(report.estimates.front().std_error, 0.0001 / std::sqrt(1.25), 1e-15);
  EXPECT_NEAR(value(report, "chi_squared"), 20.0, 1e-9);
  EXPECT_EQ(value(report, "degrees_of_freedom"), 1.0);
  EXPECT_NEAR(value(report, "p_value"), std::erfc(std::sqrt(10.0)), 1e-12);
  EXPECT_EQ(report.warnings.size(), 1U);
}

TEST(RatioFit, AgreeingRatiosAreOne) {
  const Law law = hertz();
  const FitReport report =
      fit_ratio(std::array{RatioSample{0.003, 0.0002, 1.0}, RatioSample{0.0031, 0.0002, 1.0}}, *law);
  EXPECT_NEAR(value(report, "p_value"), std::erfc(0.25), 1e-12);  // χ² = 2·(0.05/0.2)²
  EXPECT_TRUE(report.warnings.empty());
}

// A standard deviation is no standard error: without n there is no test, but the n from which on it fails. With that n,
// p is 0.05.
TEST(RatioFit, WithoutNItOnlySaysWhichNWouldRefuteIt) {
  const Law law = hertz();
  std::array samples{RatioSample{0.003, 0.001}, RatioSample{0.004, 0.001}, RatioSample{0.0045, 0.002}};
  const FitReport unknown = fit_ratio(samples, *law);
  EXPECT_TRUE(std::isnan(unknown.estimates[0].std_error) && std::isnan(unknown.estimates[1].std_error));
  EXPECT_TRUE(std::isnan(value(unknown, "p_value")));
  samples[0].n = 5.0;  // of one row alone it says nothing either
  EXPECT_TRUE(std::isnan(value(fit_ratio(samples, *law), "p_value")));
  for (RatioSample& sample : samples) sample.n = value(unknown, "n_for_p_0.05");
  const FitReport refuted = fit_ratio(samples, *law);
  EXPECT_NEAR(value(refuted, "p_value"), 0.05, 1e-12);
  EXPECT_NEAR(value(refuted, "ratio"), value(unknown, "ratio"), 1e-16);
  EXPECT_NEAR(value(refuted, "chi_squared"), samples[0].n * value(unknown, "chi_squared_per_n"), 1e-12);
  EXPECT_EQ(value(fit_ratio(std::array{RatioSample{0.003, 0.001}, RatioSample{0.003, 0.001}}, *law), "n_for_p_0.05"),
            std::numeric_limits<double>::infinity());
}

TEST(RatioFit, RefusesWhatIsNoLengthAndNoCount) {
  const Law law = hertz();
  for (const double bad :
       {0.0, -0.003, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(fit_ratio(std::array{RatioSample{0.003, 0.0002}, RatioSample{bad, 0.0002}}, *law),
                 std::invalid_argument)
        << bad;
    EXPECT_THROW(fit_ratio(std::array{RatioSample{0.003, bad}, RatioSample{0.003, 0.0002}}, *law),
                 std::invalid_argument)
        << bad;
    if (bad == 0.0) continue;
    EXPECT_THROW(fit_ratio(std::array{RatioSample{0.003, 0.0002, bad}, RatioSample{0.003, 0.0002}}, *law),
                 std::invalid_argument)
        << bad;
  }
}

}  // namespace

}  // namespace limitcurve::fit
