// SPDX-License-Identifier: MIT
#include "fit/load_fit.hpp"

#include "tests/complaint.hpp"
#include "tests/fit/synthetic.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

namespace limitcurve::fit {
namespace {

/// Values c P^{γ+e} at loads from 0.2 to 20 N, with relative Gaussian noise.
LoadSamples make(LoadSamples::Quantity quantity, double coefficient, double gamma, double noise, bool tell,
                 std::size_t count, Random& random) {
  LoadSamples result{quantity, {}};
  const double exponent = gamma + (quantity == LoadSamples::Quantity::moment ? 1.0 : 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double load = 0.2 * std::pow(100.0, static_cast<double>(i) / static_cast<double>(count - 1));
    const double exact = coefficient * std::pow(load, exponent);
    result.samples.push_back({load, exact * (1.0 + noise * random.normal()), tell ? noise * exact : 0.0});
  }
  return result;
}

std::string refusal(const LoadSamples& samples, LoadModel model) {
  return test::complaint([&] { fit_load(samples, model); });
}

TEST(LoadFit, RecoversAHundredTruthsToEightDigits) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const bool moments = i % 2 == 1;
    const double coefficient = std::exp(random.uniform(-8.0, -4.0));
    const double gamma = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 / 3.0 : random.uniform(0.0, 0.5);
    const LoadModel model = i % 3 == 0 ? LoadModel::linear : i % 3 == 1 ? LoadModel::hertz : LoadModel::power;
    LoadSamples samples = make(moments ? LoadSamples::Quantity::moment : LoadSamples::Quantity::radius, coefficient,
                               gamma, 0.0, false, 12, random);
    if (i % 4 < 2) {
      for (LoadSamples::Row& sample : samples.samples) sample.sigma = 0.01 * sample.value;
    }
    const FitReport report = fit_load(samples, model).report;
    EXPECT_TRUE(report.converged) << report.message;
    EXPECT_NEAR(report.at(moments ? "mu_r" : "c").value / coefficient, 1.0, 1e-8);
    EXPECT_NEAR(report.at("gamma").value, gamma, 1e-8);
  }
}

TEST(LoadFit, StandardErrorsAreThoseOfARegressionLine) {
  // In logarithms and without sigmas this is a straight line: compare with its textbook standard errors.
  Random random(3);
  const LoadSamples samples = make(LoadSamples::Quantity::radius, 3e-3, 0.2, 0.05, false, 25, random);
  const auto count = static_cast<Eigen::Index>(samples.samples.size());
  Eigen::MatrixX2d places(count, 2);
  Eigen::VectorXd values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const LoadSamples::Row& row = samples.samples[static_cast<std::size_t>(i)];
    places.row(i) << 1.0, std::log(row.load);
    values[i] = std::log(row.value);
  }
  const Eigen::Vector2d line = places.colPivHouseholderQr().solve(values);
  const double variance = (values - places * line).squaredNorm() / static_cast<double>(count - 2);
  const Eigen::Matrix2d squares = variance * (places.transpose() * places).inverse();
  const FitReport report = fit_load(samples, LoadModel::power).report;
  EXPECT_NEAR(report.at("gamma").value, line[1], 1e-10);
  EXPECT_NEAR(report.at("gamma").std_error, std::sqrt(squares(1, 1)), 1e-10);
  EXPECT_NEAR(report.at("c").std_error / report.at("c").value, std::sqrt(squares(0, 0)), 1e-10);
}

TEST(LoadFit, RobustLossOutlivesGrossOutliers) {
  // All outliers on one side: Huber's bounded pull then still shifts the answer by about a standard error, Cauchy's
  // does not.
  constexpr int seeds = 100;
  int within = 0;
  int plain_within = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    Random random(500 + seed);
    LoadSamples samples = make(LoadSamples::Quantity::radius, 2e-3, 0.26, 0.01, false, 60, random);
    for (std::size_t i = 5; i < samples.samples.size(); i += 10) samples.samples[i].value *= 2.5;
    const auto good = [&](const Loss& loss) {
      const FitReport report = fit_load(samples, LoadModel::power, loss).report;
      return holds(report.at("c"), 2e-3, 2.0) && holds(report.at("gamma"), 0.26, 2.0);
    };
    within += good(Loss::cauchy());
    plain_within += good(Loss::squared());
  }
  // Probability 0.91 for independent estimates: 84 or more of 100 in 99 % of cases.
  EXPECT_GE(within, 84);
  EXPECT_LE(plain_within, 50);
}

/// Few rows, of a growth that no fixed model has: the intervals of a robust loss, and of a choice, hold the truth.
TEST(LoadFit, FewRowsAreCovered) {
  const int sets = study_cases(400);
  for (const std::size_t rows : {3U, 5U, 8U}) {
    int robust = 0;
    int chosen = 0;
    for (int seed = 0; seed < sets; ++seed) {
      Random random(500 + seed);
      const LoadSamples samples = make(LoadSamples::Quantity::radius, 4e-3, 0.26, 0.05, true, rows, random);
      const auto covers = [](const FitReport& report) { return holds(report.at("gamma"), 0.26); };
      try {
        robust += covers(fit_load(samples, LoadModel::power, seed % 2 == 0 ? Loss::huber() : Loss::cauchy()).report);
        chosen += covers(select_load(samples).candidates.front().report);
      } catch (const std::invalid_argument&) {  // loads that hardly differ
        ++robust;
        ++chosen;
      }
    }
    const double least = 0.95 * sets - 3 * 0.218 * std::sqrt(sets);
    EXPECT_GE(robust, least) << rows;
    EXPECT_GE(chosen, least) << rows;
  }
}

TEST(LoadFit, ChoosesTheModelThatMadeTheData) {
  const auto share = [&](double gamma, LoadModel truth) {
    int right = 0;
    for (int seed = 0; seed < 100; ++seed) {
      Random random(700 + seed);
      const LoadSamples samples = make(LoadSamples::Quantity::radius, 2e-3, gamma, 0.01, true, 60, random);
      right += select_load(samples).candidates[0].model == truth;
    }
    return right;
  };
  // AIC takes a free exponent where a fixed one is true in 16 % of cases, by its construction.
  EXPECT_GE(share(0.0, LoadModel::linear), 74);
  EXPECT_GE(share(1.0 / 3.0, LoadModel::hertz), 74);
  EXPECT_EQ(share(0.2, LoadModel::power), 100);
  // Half way between the two, with too much noise and too few loads to distinguish them.
  int warned = 0;
  for (int seed = 0; seed < 100; ++seed) {
    Random random(900 + seed);
    const LoadSelection unclear =
        select_load(make(LoadSamples::Quantity::radius, 2e-3, 1.0 / 6.0, 0.25, true, 6, random));
    warned += unclear.aic_difference[1] < 2.0 ? 1 : 0;
    const FitReport& best = unclear.candidates[0].report;
    EXPECT_EQ(best.warnings.empty(), unclear.aic_difference[1] >= 2.0);
    // The errors are those of a free gamma about the best: so are the covariances.
    const auto power = std::ranges::find(unclear.candidates, LoadModel::power, &LoadFit::model);
    if (power == unclear.candidates.begin()) continue;
    const auto covariance = [](const FitReport& report) {
      return report.correlation_of("c", "gamma") * report.at("c").std_error * report.at("gamma").std_error;
    };
    const auto off = [&](const char* name) { return power->report.at(name).value - best.at(name).value; };
    EXPECT_NEAR(covariance(best), covariance(power->report) + off("c") * off("gamma"), 1e-12);
  }
  EXPECT_GE(warned, 20);
}

TEST(LoadFit, WarnsOfGrossOutliersByRowAndOfAGrowthThatWasAssumed) {
  int alarms = 0;
  for (const bool tell : {false, true}) {
    for (int seed = 0; seed < 50; ++seed) {
      Random random(1100 + seed);
      LoadSamples samples = make(LoadSamples::Quantity::radius, 2e-3, 0.26, 0.02, tell, 25, random);
      alarms += fit_load(samples, LoadModel::power).report.warnings.empty() ? 0 : 1;
      EXPECT_TRUE(warns(fit_load(samples, LoadModel::linear).report, "gamma = 0 was assumed")) << seed;
      samples.samples[11].value *= seed % 2 == 0 ? 3.0 : 0.4;
      for (const Loss& loss : {Loss::squared(), Loss::huber(), Loss::cauchy()}) {
        EXPECT_TRUE(warns(fit_load(samples, LoadModel::power, loss).report, "far off the curve")) << seed;
      }
    }
  }
  EXPECT_LE(alarms, 4);
}

TEST(LoadFit, SaysWhatSigmasAndTheRangeOfGammaContradict) {
  Random random(4);
  const auto warned = [](const LoadSamples& samples, const char* words) {
    return warns(fit_load(samples, LoadModel::power).report, words);
  };
  LoadSamples samples = make(LoadSamples::Quantity::radius, 2e-3, 0.3, 0.01, true, 20, random);
  EXPECT_FALSE(warned(samples, "times as much as their sigmas predict"));
  for (LoadSamples::Row& sample : samples.samples) sample.sigma *= 0.1;
  EXPECT_TRUE(warned(samples, "times as much as their sigmas predict"));
  EXPECT_FALSE(warned(samples, "end of its range"));
  EXPECT_TRUE(warned(make(LoadSamples::Quantity::radius, 2e-3, 1.8, 0.01, true, 20, random),
                     "gamma is at the end of its range, 1.5"));
}

TEST(LoadFit, RefusesByName) {
  Random random(7);
  LoadSamples one_load{LoadSamples::Quantity::radius, {{1.0, 2e-3}, {1.0, 2.1e-3}, {1.0, 1.9e-3}}};
  test::expect_mention(refusal(one_load, LoadModel::power), "gamma");
  EXPECT_EQ(refusal(one_load, LoadModel::linear), "none");
  EXPECT_EQ(refusal({LoadSamples::Quantity::moment, {{1.0, 2e-3}}}, LoadModel::power)
                .find("not identifiable from 1 sample: mu_r, gamma, expected at least 3"),
            0U);
  test::expect_mention(refusal({LoadSamples::Quantity::moment, {}}, LoadModel::linear), "at least one");
  one_load.samples[1].value = -1.0;
  EXPECT_EQ(refusal(one_load, LoadModel::linear), "sample 2: radius = -1: expected > 0 and finite");
}

}  // namespace
}  // namespace limitcurve::fit
