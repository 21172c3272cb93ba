// SPDX-License-Identifier: MIT
#include "tests/fit/coverage.hpp"
#include "tests/repetitions.hpp"

#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limitcurve::fit {
namespace {

/// With a free shape least squares is biased by up to so many standard errors; its intervals hold the truth all the same.
constexpr double shape_bias = 0.4;

/// A short version of `fit_coverage_study 200`; the module's README has its figures.
void expect_honest(const ContactModel& model, double noise, bool tell) {
  constexpr int seeds = repetitions(300, 50);
  // A short build has fewer draws.
  const double wider = std::sqrt(300.0 / seeds);
  int blanks = 0;
  for (const auto& [name, honesty] : synthetic::study(model, hertz(), 0.5, noise, tell, seeds, blanks)) {
    // 300 draws determine the mean to 0.06 standard errors and a share of 95 % to 1.3 %: three times these.
    EXPECT_LT(std::fabs(honesty.bias), (model.kind == ContactModel::Kind::law ? 0.1 : shape_bias) + 3 * 0.06 * wider) << name;
    EXPECT_NEAR(honesty.coverage, 0.95, 3 * 0.0126 * wider) << name;
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

/// What is promised of the study of 1000 seeds, held by a tenth of it to what that tells.
void expect_promise(const ContactModel& model, const Law& law, double shape, double noise) {
  constexpr int whole = 1000;
  const int seeds = study_cases(whole);
  const double bias_unknown = seeds < whole ? 3.0 / std::sqrt(seeds) : 0.0;
  const double coverage_unknown = seeds < whole ? 3.0 * 0.218 / std::sqrt(seeds) : 0.0;
  int blanks = 0;
  for (const auto& [name, honesty] : synthetic::study(model, law, shape, noise, true, seeds, blanks)) {
    EXPECT_LT(std::fabs(honesty.bias), shape_bias + bias_unknown) << name;
    EXPECT_GE(honesty.coverage, 0.93 - coverage_unknown) << name;
    EXPECT_LE(honesty.coverage, 0.97 + coverage_unknown) << name;
  }
  EXPECT_LE(blanks, 5);
}

TEST(Coverage, PressureLawOfPowerNHardlyKnownIsCovered) {
  expect_promise({ContactModel::Kind::power}, hertz(), 0.5, 0.01);
}

TEST(Coverage, PressureLawOfXydasAndKaoHardlyKnownIsCovered) {
  expect_promise({ContactModel::Kind::xydas_kao}, xydas_kao(3.0), 3.0, 0.003);
}

}  // namespace
}  // namespace limitcurve::fit
