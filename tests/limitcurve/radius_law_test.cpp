// SPDX-License-Identifier: MIT
#include "limitcurve/contact/radius_law.hpp"
#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test {

namespace {

/// Johnson, Contact Mechanics, eq. 4.22: a³ = 3PR/(4E*).
TEST(RadiusLaw, HertzCubes) {
  const RadiusLaw law = RadiusLaw::parse("hertz:R=0.008,E=2e5");
  for (const double load : {1e-6, 0.3, 1.0, 50.0}) {
    const double radius = law.radius(load);
    EXPECT_NEAR(4.0 * 2e5 * radius * radius * radius / (3.0 * load * 0.008), 1.0, 4e-15) << load;
  }
  EXPECT_EQ(law.radius(0.0), 0.0);
}

/// A silicone finger as published: 2.07 mm at 1 N, exponent 0.259.
TEST(RadiusLaw, PowerGrows) {
  const RadiusLaw law = RadiusLaw::parse("power:c=0.00207,gamma=0.259");
  EXPECT_EQ(law.radius(1.0), 0.00207);
  EXPECT_NEAR(law.radius(10.0) / 0.00207, 1.8155156627731355, 1e-15);  // 10^0.259
  EXPECT_NEAR(law.radius(6.0) / law.radius(2.0), law.growth(3.0), 1e-15);
}

constexpr std::array<LoadSample, 4> measured{{{0.5, 0.0021}, {1.0, 0.0025}, {3.0, 0.0030}, {8.0, 0.0031}}};

TEST(SampledRadiusLaw, MeetsItsSamplesAndIsAPowerBetween) {
  const RadiusLaw law = RadiusLaw::sampled(measured);
  for (const LoadSample& sample : measured) EXPECT_NEAR(law.radius(sample.load) / sample.value, 1.0, 1e-14);
  // Between two samples the geometric mean of the loads has that of the radii; beyond the last the power goes on.
  EXPECT_NEAR(law.radius(std::sqrt(3.0)) / std::sqrt(0.0025 * 0.0030), 1.0, 1e-14);
  EXPECT_NEAR(law.radius(64.0 / 3.0) / (0.0031 * 0.0031 / 0.0030), 1.0, 1e-14);
  EXPECT_NEAR(law.growth(3.0, 1.0), 1.2, 1e-14);
  EXPECT_TRUE(law.is_sampled());
}

TEST(SampledRadiusLaw, FindsTheLoadOfAMoment) {
  const RadiusLaw law = RadiusLaw::sampled(measured);
  for (const double load : {1e-3, 0.4, 0.7, 2.0, 5.0, 100.0})
    EXPECT_NEAR(law.load_of_product(load * law.radius(load)) / load, 1.0, 1e-13);
}

TEST(SampledRadiusLaw, IsThatOfTheMomentsItIsMadeOf) {
  constexpr double mu = 0.6;
  constexpr double moment_ratio = 0.589;
  const std::array<LoadSample, 3> moments{{{1.0, 1.1e-3}, {2.0, 2.7e-3}, {4.0, 6.0e-3}}};
  const RadiusLaw law = RadiusLaw::of_moments(moments, mu, moment_ratio);
  for (const LoadSample& sample : moments)
    EXPECT_NEAR(moment_ratio * mu * sample.load * law.radius(sample.load) / sample.value, 1.0, 1e-14);
  EXPECT_NEAR(moment_ratio * mu * 7.0 * RadiusLaw::of_mu_r(0.003, 0.0, mu, moment_ratio).radius(7.0), 0.003 * 7.0,
              1e-16);
}

TEST(SampledRadiusLaw, TakesRadiiInProportionToTheLoad) {
  for (const double step : {1.4, 0.1, 1e-3, 1e-7}) {
    std::vector<LoadSample> rows;
    for (const int k : {0, 1, 2, 3, 7, 8}) rows.push_back({0.5 + step * k, 0.0014 * (0.5 + step * k)});
    const RadiusLaw law = RadiusLaw::sampled(rows);
    for (const auto& [load, value] : rows) EXPECT_NEAR(law.radius(load) / value, 1.0, 1e-14) << step;
    EXPECT_LE(law.growth(1e3, 1.0), 1e3 * (1.0 + 1e-14)) << step;
  }
}

TEST(SampledRadiusLaw, RefusesWhatIsNoLaw) {
  const auto refused = [](const std::vector<LoadSample>& rows, const char* told) {
    expect_mention(complaint([&] { RadiusLaw::sampled(rows); }), told);
  };
  refused({{1.0, 0.002}}, "expected at least 2");
  refused({{1.0, 0.002}, {1.0, 0.003}}, "load of sample 2");
  refused({{1.0, 0.002}, {2.0, 0.0009}}, "exponent before sample 2");
}

TEST(RadiusLaw, ParametersComeInAnyOrder) {
  EXPECT_EQ(RadiusLaw::parse("hertz:E=2e5,R=0.008").radius(3.0), RadiusLaw::hertz(0.008, 2e5).radius(3.0));
}

TEST(RadiusLaw, SaysWhatIsWrong) {
  for (const auto& [text, place] : {std::pair{"", "radius law ''"},
                                    {"constant", "no 'a' in '', expected a=NUMBER"},
                                    {"cone:a=1", "'cone:a=1'"},
                                    {"constant:", "expected a=NUMBER"},
                                    {"constant:a=", "'a' in 'a=': got ''"},
                                    {"constant:a=1x", "got '1x', expected a number"},
                                    {"constant:b=1", "got 'b=1'"},
                                    {"constant:a=1,", "got ''"},
                                    {"constant:a=1,a=2", "'a' twice in 'a=1,a=2'"},
                                    {"constant:a=0", "a = 0 m"},
                                    {"constant:a=-1", "a = -1 m"},
                                    {"constant:a=nan", "a = nan m"},
                                    {"constant:a=inf", "a = inf m"},
                                    {"hertz:R=0.008", "expected R=NUMBER,E=NUMBER"},
                                    {"hertz:R=0.008,E=0", "E = 0 Pa"},
                                    {"hertz:R=-0.008,E=1", "R = -0.008 m"},
                                    {"hertz:R=1e300,E=1e-300", "R/E = inf m/Pa"},
                                    {"hertz:R=0.008,E=nan", "E = nan Pa"},
                                    {"power:c=0.002,gamma=1.5", "gamma = 1.5"},
                                    {"power:c=0.002,gamma=-0.1", "gamma = -0.1"},
                                    {"power:c=0,gamma=0.2", "c = 0 m/N^gamma"},
                                    {"power:c=0.002,gamma=0.2 ", "got '0.2 '"}}) {
    const std::string told = complaint([&, &text = text] { RadiusLaw::parse(text); });
    expect_mention(told, place);
    expect_mention(told, std::string("radius law '") + text + "'");
  }
}

}  // namespace

}  // namespace limitcurve::test
