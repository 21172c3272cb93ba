// SPDX-License-Identifier: MIT

#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test::load_curves_test {

namespace {

constexpr double mu = 0.7;
const std::array<double, 5> loads{0.1, 0.5, 1.0, 3.0, 20.0};
const std::array<const char*, 4> radius_laws{"constant:a=0.005", "hertz:R=0.008,E=2e5", "power:c=0.00207,gamma=0.259",
                                             "power:c=0.002,gamma=1"};

TEST(SlipTwists, TurnByEqualSteps) {
  const auto twists = slip_twists(91);
  ASSERT_EQ(twists.size(), 91U);
  EXPECT_EQ(twists.front().cor(), 0.0);
  EXPECT_EQ(twists.back().cor(), inf);
  for (std::size_t i = 0; i < twists.size(); ++i) {
    const double degrees = std::atan2(twists[i].slide, twists[i].spin) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(degrees, static_cast<double>(i), 1e-12);
  }
  EXPECT_EQ(slip_twists(2).size(), 2U);
  EXPECT_THROW(slip_twists(1), std::invalid_argument);
  EXPECT_THROW(slip_twists(0), std::invalid_argument);
}

/// F = μP f(c/a), M = μPa m(c/a), with a(P) from the radius law.
TEST(PCurve, IsTheUnitCurveScaled) {
  const Law law = uniform();
  const ExactCurve curve(law);
  for (const char* text : radius_laws) {
    const RadiusLaw radius_law = RadiusLaw::parse(text);
    for (const double load : loads) {
      const double radius = radius_law.radius(load);
      const auto points = p_curve(curve, {mu, radius_law}, load, 33);
      ASSERT_EQ(points.size(), 33U);
      EXPECT_EQ(points.front().cor, 0.0);
      EXPECT_EQ(points.front().force, 0.0);
      EXPECT_NEAR(points.front().moment / moment_capacity(curve.moment_ratio(), radius_law, mu, load), 1.0, 1e-15);
      EXPECT_EQ(points.back().cor, inf);
      EXPECT_NEAR(points.back().force / (mu * load), 1.0, 1e-15);
      EXPECT_EQ(points.back().moment, 0.0);
      for (const LoadPoint& point : points) {
        EXPECT_EQ(point.load, load);
        const UnitWrench unit = law->evaluate(point.cor / radius).wrench;
        const UnitWrench expected{mu * load * unit.force, mu * load * radius * unit.moment};
        EXPECT_TRUE(are_near_in_relative_terms(point, expected, 1e-14));
      }
    }
  }
}

/// With a growing radius the same COR moves inwards, c/a falls, and the moment's arm grows.
TEST(CCurve, IsBentWhenTheRadiusGrows) {
  const Law law = hertz();
  const ExactCurve curve(law);
  const RadiusLaw radius_law = RadiusLaw::hertz(0.008, 2e5);
  const double cor = radius_law.radius(1.0);
  const auto points = c_curve(curve, {mu, radius_law}, cor, loads);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double radius = std::cbrt(0.75 * loads[i] * 0.008 / 2e5);
    const UnitWrench unit = law->evaluate(cor / radius, Method::ring).wrench;
    const UnitWrench expected{mu * loads[i] * unit.force, mu * loads[i] * radius * unit.moment};
    EXPECT_TRUE(are_near_in_relative_terms(points[i], expected, 1e-14));
    if (i > 0) {
      EXPECT_GT(points[i].moment / points[i].force, 1.1 * points[i - 1].moment / points[i - 1].force);
    }
  }
}

TEST(MomentCapacity, GrowsAsTheLoadTimesTheRadius) {
  const RadiusLaw radius_law = RadiusLaw::power(0.002, 0.25);
  EXPECT_NEAR(moment_capacity(0.6, radius_law, 0.5, 16.0), 0.6 * 0.5 * 16.0 * 0.002 * 2.0, 1e-17);
  for (const RadiusLaw& any : {radius_law, RadiusLaw::of_mu_r(0.002, -0.3, 0.5, 0.6)})
    EXPECT_EQ(moment_capacity(0.6, any, 0.5, 0.0), 0.0);
  EXPECT_NEAR(moment_capacity(0.6, radius_law, 0.5, 32.0) / moment_capacity(0.6, radius_law, 0.5, 2.0),
              std::pow(16.0, 1.25), 1e-12);
}

template <class Curve>
void expect_round_trip(const Curve& curve, const char* what) {
  std::mt19937_64 random(77);
  std::uniform_real_distribution<double> decade(-6.0, 6.0);
  std::uniform_real_distribution<double> angle(0.01, 1.56);
  // Measured radii may even shrink a little.
  std::vector<RadiusLaw> all{RadiusLaw::sampled(
      std::array{LoadSample{0.5, 0.0021}, LoadSample{2.0, 0.0029}, LoadSample{3.0, 0.0028}, LoadSample{9.0, 0.0035}})};
  for (const char* text : radius_laws) all.push_back(RadiusLaw::parse(text));
  for (const RadiusLaw& radius_law : all) {
    for (int i = 0; i < 100; ++i) {
      const double load = std::pow(10.0, decade(random));
      const LoadPoint point =
          load_point(curve, {mu, radius_law}, load, std::tan(angle(random)) * radius_law.radius(load));
      EXPECT_NEAR(load_to_hold(curve, {mu, radius_law}, point.force, point.moment) / load, 1.0, 1e-12)
          << what << ' ' << load << ' ' << point.cor;
    }
  }
}

TEST(LoadToHold, IsTheLoadOfThePCurveThroughTheWrench) {
  expect_round_trip(ExactCurve(hertz()), "hertz");
  expect_round_trip(ExactCurve(flat_punch()), "flat-punch");
  expect_round_trip(Ellipse(1.0, 0.6), "ellipse");
  expect_round_trip(box(1.0, 0.6), "box");
  expect_round_trip(diamond(1.0, 0.6), "diamond");
}

TEST(LoadToHold, NeedsNoRadiusWhereTheMomentCoefficientIsKnown) {
  const ExactCurve curve(uniform());
  for (const double gamma : {-0.5, -0.1, 0.0, 0.3, 1.0}) {
    const ContactFriction contact{.mu = mu, .mu_r = 0.003, .gamma = gamma};
    for (const double load : {1e-3, 0.5, 20.0}) {
      EXPECT_NEAR(load_point(curve, contact, load, 0.0).moment / (0.003 * std::pow(load, 1.0 + gamma)), 1.0, 1e-14);
      for (const LoadPoint& point : p_curve(curve, contact, load, 9)) {
        const double held = load_to_hold(curve, contact, point.force, point.moment);
        EXPECT_NEAR(held / load, 1.0, 1e-12) << gamma << ' ' << load;
        for (const double sign : {-1.0, 1.0})
          EXPECT_EQ(load_to_hold(curve, contact, -point.force, sign * point.moment), held);
      }
    }
    for (const LoadPoint& point : p_curve(curve, contact, 0.0, 5)) EXPECT_EQ(point.force + point.moment, 0.0);
    EXPECT_TRUE(std::isnan(load_to_hold(curve, contact, nan, 1.0)) &&
                std::isnan(load_to_hold(curve, contact, inf, nan)));
    EXPECT_EQ(load_to_hold(curve, contact, -inf, 1.0), inf);
  }
  EXPECT_EQ(load_to_hold(curve, {.mu = mu, .mu_r = 0.0}, 1.0, 1e-9), inf);
  EXPECT_NEAR(load_to_hold(curve, {.mu = mu, .mu_r = 0.0}, -1.0, 0.0), 1.0 / mu, 1e-12);
}

TEST(LoadToHold, OfOneComponentIsElementary) {
  const ExactCurve curve(hertz());
  const RadiusLaw radius_law = RadiusLaw::power(0.002, 0.25);
  EXPECT_NEAR(load_to_hold(curve, {0.5, radius_law}, 3.0, 0.0), 6.0, 1e-14);
  const double moment = moment_capacity(curve.moment_ratio(), radius_law, 0.5, 7.0);
  EXPECT_NEAR(load_to_hold(curve, {0.5, radius_law}, 0.0, moment), 7.0, 1e-13);
  EXPECT_EQ(load_to_hold(curve, {0.5, radius_law}, 0.0, 0.0), 0.0);
  EXPECT_EQ(load_to_hold(curve, {0.0, radius_law}, 0.0, 0.0), 0.0);
  EXPECT_EQ(load_to_hold(curve, {0.0, radius_law}, 1.0, 0.0), inf);
  EXPECT_EQ(load_to_hold(curve, {0.0, radius_law}, 0.0, 1.0), inf);
}

/// Never NaN, for any sizes.
TEST(LoadToHold, SurvivesExtremes) {
  const ExactCurve curve(hertz());
  for (const char* text : radius_laws) {
    for (const double force : {0.0, 5e-324, 1e-300, 1e-100, 1.0, 1e100, 1e308}) {
      for (const double moment : {0.0, 5e-324, 1e-300, 1e-100, 1.0, 1e100, 1e308}) {
        const double load = load_to_hold(curve, {1.0, RadiusLaw::parse(text)}, force, moment);
        EXPECT_GE(load, 0.0) << text << ' ' << force << ' ' << moment;
        EXPECT_GE(load, force * (1.0 - 1e-12)) << text << ' ' << force << ' ' << moment;
      }
    }
  }
}

TEST(LoadCurves, RefuseBadInput) {
  const Ellipse curve(1.0, 0.6);
  const RadiusLaw radius_law = RadiusLaw::constant(0.005);
  const auto refused = [](const char* told, auto&& call) { expect_mention(complaint(call), told); };
  for (const double bad : {-1.0, nan, inf}) {
    refused("mu = ", [&] { p_curve(curve, {bad, radius_law}, 1.0, 3); });
    refused("load = ", [&] { p_curve(curve, {mu, radius_law}, bad, 3); });
    refused("load = ", [&] { load_point(curve, {mu, radius_law}, bad, 1.0); });
    refused("mu = ", [&] { load_to_hold(curve, {bad, radius_law}, 1.0, 0.0); });
    refused("mu_r = ", [&] { load_to_hold(curve, {.mu = mu, .mu_r = bad}, 1.0, 0.0); });
    refused("gamma = ", [&] { load_to_hold(curve, {.mu = mu, .mu_r = 0.1, .gamma = 3.0 + bad}, 1.0, 0.0); });
    refused("moment_ratio = ", [&] { moment_capacity(bad, radius_law, mu, 1.0); });
  }
  refused("both", [&] { load_to_hold(curve, {.mu = mu, .radius_law = radius_law, .mu_r = 0.1}, 1.0, 0.0); });
  refused("give radius_law or mu_r", [&] { load_to_hold(curve, {.mu = mu}, 1.0, 0.0); });
  refused("0 where mu is 0", [&] { load_to_hold(curve, {.mu = 0.0, .mu_r = 0.1}, 1.0, 0.0); });
  refused("cor = -1 m", [&] { load_point(curve, {mu, radius_law}, 1.0, -1.0); });
  // Each finite, their product not: a pure twist's force would be 0·∞.
  const RadiusLaw large = RadiusLaw::constant(10.0);
  refused("load = 1e+308 N", [&] { p_curve(curve, {2.0, radius_law}, 1e308, 3); });
  refused("radius = 10 m", [&] { p_curve(curve, {1.0, large}, 1e308, 3); });
  refused("product", [&] { load_point(curve, {1.0, large}, 1e308, inf); });
  refused("product", [&] { moment_capacity(0.6, large, 1.0, 1e308); });
  refused("cor = nan m", [&] { c_curve(curve, {mu, radius_law}, nan, loads); });
}

}  // namespace

}  // namespace limitcurve::test::load_curves_test
