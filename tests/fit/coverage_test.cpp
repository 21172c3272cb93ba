// SPDX-License-Identifier: MIT
#include "tests/fit/coverage.hpp"

#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limitcurve::fit {
namespace {

/// A short version of `fit_coverage_study 1000`, whose figures the module's README gives.
void expect_honest(const ContactModel& model, double noise, bool tell) {
  constexpr int seeds = 300;
  int blanks = 0;
  for (const auto& [name, honesty] : synthetic::study(model, hertz(), 0.5, noise, tell, seeds, blanks)) {
    // 300 draws tell the mean to 0.06 standard errors and a share of 95 % to 1.3 %: three of each.
    EXPECT_LT(std::fabs(honesty.bias), 0.1 + 3 * 0.06) << name;
    EXPECT_NEAR(honesty.coverage, 0.95, 3 * 0.0126) << name;
  }
  EXPECT_EQ(blanks, 0);
}

TEST(Coverage, LimitsAndRadiusWithKnownErrorsOfThreePercent) {
  expect_honest(ContactModel::of(hertz()), 0.03, true);
}

TEST(Coverage, LimitsAndRadiusWithErrorsFoundFromTheScatter) {
  expect_honest(ContactModel::of(hertz()), 0.01, false);
}

TEST(Coverage, PressureLawWithErrorsOfAThirdOfAPercent) {
  expect_honest({ContactModel::Kind::power}, 0.003, true);
}

}  // namespace
}  // namespace limitcurve::fit
