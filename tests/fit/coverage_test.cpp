// SPDX-License-Identifier: MIT
#include "tests/fit/coverage.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <map>

namespace limitcurve::fit {
namespace {

/// A short version of `fit_coverage_study 200`; the module's README has its figures.
void expect_honest(double noise, bool tell) {
  constexpr int seeds = repetitions(300, 50);
  // A short build has fewer draws.
  const double wider = std::sqrt(300.0 / seeds);
  int blanks = 0;
  for (const auto& [name, honesty] : study(ContactModel::of(hertz()), hertz(), 0.5, noise, tell, seeds, blanks)) {
    // 300 draws determine the mean to 0.06 standard errors and a share of 95 % to 1.3 %: three times these.
    EXPECT_LT(std::fabs(honesty.bias), 0.1 + 3 * 0.06 * wider) << name;
    EXPECT_NEAR(honesty.coverage, 0.95, 3 * 0.0126 * wider) << name;
  }
  EXPECT_EQ(blanks, 0);
}

TEST(Coverage, LimitsAndRadiusWithErrorsThatAreKnownOrFoundFromTheScatter) {
  expect_honest(0.03, true);
  expect_honest(0.01, false);
}

/// With the truth at the end of a parameter's range about half of the fits end there. The intervals of the limits hold
/// the truth all the same, and so does γ's; of the shape nothing is reported.
void expect_honest_at_the_end(const ContactModel& model, const Law& law, double gamma, const std::string& at_end) {
  constexpr int seeds = repetitions(100, 50);
  const Truth truth{0.8, 0.005, gamma};
  const double mu_r = truth.mu_r(law);
  ContactFitOptions options;
  options.fit_gamma = at_end == "gamma";
  Random loads(5);
  const std::vector<Sample> exact = clean(law, truth, 100, loads);
  std::map<std::string, int> held;
  int ended = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    Random random(1000 + seed);
    std::vector<Sample> samples = exact;
    disturb(samples, 0.01, truth.mu, mu_r, true, random);
    const FitReport report = fit_contact(samples, model, options).report;
    EXPECT_TRUE(report.converged) << report.message;
    const Estimate& end = report.at(at_end);
    ended += at_end == "gamma" ? end.value > gamma - 1e-9 : std::isinf(end.std_error);
    for (const auto& [name, value] : {std::pair{"mu", truth.mu}, {"mu_r", mu_r}, {"gamma", gamma}}) {
      if (!options.fit_gamma && name == std::string("gamma")) continue;
      held[name] += holds(report.at(name), value);
    }
  }
  EXPECT_NEAR(ended, 0.5 * seeds, 0.1 * seeds + 1.5 * std::sqrt(seeds));
  for (const auto& [name, count] : held) EXPECT_GE(count, 0.95 * seeds - 3 * 0.218 * std::sqrt(seeds)) << name;
}

TEST(Coverage, AParameterAtTheEndOfItsRange) {
  expect_honest_at_the_end(ContactModel::of(hertz()), hertz(), 1.0, "gamma");
  expect_honest_at_the_end({ContactModel::Kind::power}, power(6.0), 0.0, "n");
}

/// With a free shape least squares is biased by up to so many standard errors; its intervals hold the truth all the
/// same.
constexpr double shape_bias = 0.4;

/// What is promised of the study of 1000 seeds, held by a tenth of it to what that tells.
void expect_promise(const ContactModel& model, const Law& law, double shape, double noise) {
  constexpr int whole = 1000;
  const int seeds = study_cases(whole);
  const double bias_unknown = seeds < whole ? 3.0 / std::sqrt(seeds) : 0.0;
  const double coverage_unknown = seeds < whole ? 3.0 * 0.218 / std::sqrt(seeds) : 0.0;
  int blanks = 0;
  for (const auto& [name, honesty] : study(model, law, shape, noise, true, seeds, blanks)) {
    EXPECT_LT(std::fabs(honesty.bias), shape_bias + bias_unknown) << name;
    EXPECT_GE(honesty.coverage, 0.93 - coverage_unknown) << name;
    EXPECT_LE(honesty.coverage, 0.97 + coverage_unknown) << name;
  }
  EXPECT_LE(blanks, 5);
}

TEST(Coverage, APressureLawThatIsHardlyKnownIsCovered) {
  expect_promise({ContactModel::Kind::power}, hertz(), 0.5, 0.01);
  expect_promise({ContactModel::Kind::xydas_kao}, xydas_kao(3.0), 3.0, 0.003);
}

}  // namespace
}  // namespace limitcurve::fit
