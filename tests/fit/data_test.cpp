// SPDX-License-Identifier: MIT
#include "fit/model_fit.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "tests/complaint.hpp"
#include "tests/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace limitcurve::fit {
namespace {

std::vector<std::vector<std::string>> rows_of(const std::string& name, std::size_t columns) {
  return test::rows_of(std::string(LIMITCURVE_DATA) + "/fit/" + name, columns);
}

std::map<std::string, double> truth() {
  std::map<std::string, double> values;
  for (const auto& row : rows_of("truth.csv", 3)) values[row.at(0)] = *parse_number(row.at(1));
  return values;
}

std::vector<Sample> slips(const std::string& name) {
  std::vector<Sample> samples;
  for (const auto& row : rows_of(name, 5)) {
    const auto number = [&](std::size_t column) { return *parse_number(row.at(column)); };
    samples.push_back({number(0), number(1), number(2), number(3), number(4)});
  }
  return samples;
}

TEST(SensorLog, RobustFitFindsTheTruthInSpiteOfMislabelledSlips) {
  const std::vector<Sample> samples = slips("slips.csv");
  ContactFitOptions options;
  options.fit_gamma = true;
  options.loss = Loss::cauchy();
  const FitReport report = fit_contact(samples, ContactModel::of(hertz()), options).report;
  for (const auto& [name, value] : truth()) {
    const Estimate& estimate = report.at(name);
    EXPECT_NEAR(estimate.value, value, 2.0 * estimate.std_error) << name;
    EXPECT_LT(estimate.std_error, 0.005 * value) << name;
  }
  ASSERT_FALSE(report.warnings.empty());
  test::expect_mention(report.warnings[0], "far off the curve");

  options.loss = Loss::squared();
  const FitReport plain = fit_contact(samples, ContactModel::of(hertz()), options).report;
  EXPECT_GT(std::fabs(plain.at("c").value - truth()["c"]), 3.0 * plain.at("c").std_error);
}

TEST(SensorLog, ThePressureLawIsFoundAndItsRivalsAreNamed) {
  ContactFitOptions options;
  options.fit_gamma = true;
  options.loss = Loss::cauchy();
  const LawSelection selection = select_law(slips("slips.csv"), options);
  EXPECT_EQ(selection.candidates[0].model, "hertz");
  for (std::size_t i = 0; i < selection.candidates.size(); ++i) {
    const ContactFit& candidate = selection.candidates[i];
    if (candidate.model == "uniform" || candidate.model == "flat-punch") {
      EXPECT_GT(selection.aic_difference[i], 10.0) << candidate.model;
    }
    if (candidate.model == "power") {
      EXPECT_NEAR(candidate.report.at("n").value, 0.5, 2.0 * candidate.report.at("n").std_error);
      EXPECT_GT(candidate.report.correlation_of("n", "c"), 0.9);
    }
  }
}

TEST(SensorLog, RadiiGiveTheGrowthOfTheContact) {
  LoadSamples samples;
  for (const auto& row : rows_of("radii.csv", 3))
    samples.samples.push_back({*parse_number(row[0]), *parse_number(row[1]), *parse_number(row[2])});
  const FitReport report = select_load(samples).candidates[0].report;
  EXPECT_NEAR(report.at("gamma").value, truth()["gamma"], 2.5 * report.at("gamma").std_error);
  EXPECT_NEAR(report.at("c").value, truth()["c"], 2.5 * report.at("c").std_error);
}

}  // namespace
}  // namespace limitcurve::fit
