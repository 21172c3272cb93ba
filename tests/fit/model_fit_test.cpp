// SPDX-License-Identifier: MIT
#include "fit/model_fit.hpp"

#include "limitcurve/validate/choose.hpp"
#include "tests/complaint.hpp"
#include "tests/fit/synthetic.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <regex>

namespace limitcurve::fit {
namespace {

TEST(ModelFit, RatioOnTheTableOfKinoshitaGivesBackItsRatios) {
  // Kinoshita et al. 1997, as the paper's Table 1 has it: means ± SD of μ_l, μ_r [mm] and of their ratio [mm].
  struct Row {
    const char* material;
    double mu, mu_sd, mu_r, mu_r_sd, ratio, ratio_sd;
  };
  for (const Row& row :
       {Row{"rayon", 0.42, 0.07, 3.05, 0.57, 7.39, 0.91}, Row{"suede", 0.61, 0.1, 3.84, 0.74, 6.37, 0.88},
        Row{"sandpaper", 1.67, 0.24, 10.11, 1.50, 6.20, 1.54}}) {
    // Per newton of load: one pure slide, one pure twist.
    const std::vector<Sample> samples{{1.0, row.mu, 0.0, row.mu_sd, 1e-3 * row.mu_r_sd},
                                      {1.0, 0.0, 1e-3 * row.mu_r, row.mu_sd, 1e-3 * row.mu_r_sd}};
    const ModelFit found = fit(Kind::ratio, samples);
    const Estimate& ratio = found.report.at("ratio");
    EXPECT_NEAR(ratio.value, 1e-3 * row.mu_r / row.mu, 1e-9) << row.material;
    EXPECT_NEAR(found.report.at("mu").std_error, row.mu_sd, 1e-6) << row.material;
    // The published ratio is a mean of ratios, not a ratio of means: the two differ by the scatter between subjects.
    EXPECT_NEAR(ratio.value, 1e-3 * row.ratio, 0.2e-3 * row.ratio_sd) << row.material;
    EXPECT_GT(found.report.at("radius").value, 9e-3);
    EXPECT_LT(found.report.at("radius").value, 13e-3);
    ASSERT_EQ(found.report.warnings.size(), 1u);
    test::expect_mention(found.report.warnings[0], "more than the finger's");
  }
}

TEST(ModelFit, EachNameDoesItsFit) {
  Random random(1);
  const std::vector<Sample> samples = clean(uniform(), {0.8, 0.004}, 60, random);
  FitOptions of_uniform;
  of_uniform.law = uniform();
  EXPECT_EQ(fit(Kind::ellipse, samples).report.estimates[0].name, "force_max");
  EXPECT_NEAR(fit(Kind::law, samples, of_uniform).report.at("radius").value, 0.004, 1e-10);
  const ModelFit chosen = fit(Kind::law, samples);
  EXPECT_NEAR(chosen.report.at("radius").value, 0.004, 1e-6);
  EXPECT_EQ(chosen.candidates.front(), std::pair(std::string("uniform"), 0.0));
  EXPECT_TRUE(fit(Kind::ellipse, hertz()).error.has_value());
}

TEST(ModelFit, TheDefaultGrowthIsAPowerAndOthersAreAsked) {
  const LoadSamples samples{LoadSamples::Quantity::radius,
                            {{1.0, 2e-3}, {2.0, 2e-3}, {4.0, 2.1e-3}, {8.0, 1.9e-3}, {9.0, 2e-3}}};
  for (const LoadModel model : {LoadModel::linear, LoadModel::hertz, LoadModel::power}) {
    FitOptions options;
    options.load_model = model;
    const ModelFit found = fit(Kind::load, samples, options);
    EXPECT_EQ(found.model, to_string(model));
    EXPECT_EQ(found.report.find(Estimate::Role::radius)->value, fit_load(samples, model).report.at("c").value);
  }
  EXPECT_EQ(fit(Kind::load, samples).report.at("gamma").value,
            fit_load(samples, LoadModel::power).report.at("gamma").value);
  FitOptions best;
  best.load_model = LoadModel::best;
  EXPECT_EQ(fit(Kind::load, samples, best).model, "linear");
}

TEST(ModelFit, UnknownNamesAndOtherDataAreToldWhatWasExpected) {
  const std::vector<Sample> samples(3, {1.0, 0.5, 0.001});
  test::expect_mention(test::complaint([&] { parse_kind("elipse"); }), "model 'elipse': expected ellipse");
  test::expect_mention(test::complaint([&] { fit(Kind::load, samples); }), "fit load: expected radii or moments");
  test::expect_mention(test::complaint([&] { fit(Kind::law, LoadSamples{}); }), "fit law: expected slips");
  test::expect_mention(test::complaint([&] { fit(Kind::ellipse, Law()); }), "law");
}

/// The program's locale is German, with a comma in its numbers, where it can be made.
class GermanNumbers {
 public:
  GermanNumbers() {
    const std::string folder = testing::TempDir() + "locale";
    std::filesystem::create_directories(folder);
    const std::string make = "localedef -i de_DE -f UTF-8 --no-archive " + folder + "/de_DE.UTF-8 >/dev/null 2>&1";
    if (std::system(make.c_str()) == 0 && ::setenv("LOCPATH", folder.c_str(), 1) == 0)
      std::setlocale(LC_ALL, "de_DE.UTF-8");
    ::unsetenv("LOCPATH");
    std::filesystem::remove_all(folder);
  }
  ~GermanNumbers() { std::setlocale(LC_ALL, "C"); }
  [[nodiscard]] static bool are_set() { return std::localeconv()->decimal_point == std::string(","); }
};

TEST(ModelFit, NumbersInMessagesDoNotDependOnTheLocale) {
  const GermanNumbers german;
  if (!GermanNumbers::are_set()) GTEST_SKIP() << "no localedef, or no source of de_DE";
  Random random(3);
  std::vector<Sample> samples = clean(hertz(), {0.6, 0.0045, 0.3}, 60, random);
  disturb(samples, 0.01, 0.6, 0.0016, false, random);
  std::string told = in_percent(0.0123) + in_percent(0.5) + in_percent(3.3e-5);
  for (const Kind kind : {Kind::ratio, Kind::law, Kind::ellipse}) {
    const FitReport report = fit(kind, samples).report;
    told += report.note + report.message;
    for (const std::string& warning : report.warnings) told += warning;
  }
  test::expect_mention(told, "fits better");
  EXPECT_FALSE(std::regex_search(told, std::regex("[0-9],[0-9]"))) << told;
}

}  // namespace
}  // namespace limitcurve::fit
