// SPDX-License-Identifier: MIT
// What each approximation is, beyond being a limit curve (curve_suite.cpp).
#include "limitcurve/approximations.hpp"
#include "twists.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::test {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

TEST(Superellipse, SupportFunctionIsTheDualNorm) {
  const double exponent = 1.7;
  const double dual = exponent / (exponent - 1.0);
  const Superellipse curve(1.1, 0.6, exponent);
  for (const SlipTwist twist : many_twists()) {
    const double p = 1.1 * twist.slide;
    const double q = 0.6 * twist.spin;
    EXPECT_NEAR(power_of(twist, curve.wrench(twist)) / std::pow(std::pow(p, dual) + std::pow(q, dual), 1.0 / dual), 1.0, 1e-14);
  }
}

TEST(Approximations, OfExponentOrKappaTwoAreTheEllipse) {
  const Ellipse ellipse(0.9, 0.6);
  const Superellipse superellipse_two(0.9, 0.6, 2.0);
  const Quartic quartic_two(0.9, 0.6, 2.0);
  for (const SlipTwist twist : many_twists()) {
    const UnitWrench wrench = ellipse.wrench(twist);
    EXPECT_NEAR(superellipse_two.wrench(twist).force, wrench.force, 1e-15 * wrench.force);
    EXPECT_NEAR(superellipse_two.wrench(twist).moment, wrench.moment, 1e-15 * wrench.moment);
    EXPECT_NEAR(quartic_two.wrench(twist).force, wrench.force, 2e-15 * wrench.force);
    EXPECT_NEAR(quartic_two.wrench(twist).moment, wrench.moment, 2e-15 * wrench.moment);
  }
}

/// κ = 6 is the superellipse of exponent 4 turned by 45°: (x + y)⁴ + (x − y)⁴ = 2.
TEST(Quartic, OfKappaSixIsATurnedSuperellipse) {
  const Quartic curve(1.0, 1.0, 6.0);
  for (const SlipTwist twist : many_twists()) {
    const auto [x, y] = curve.wrench(twist);
    EXPECT_NEAR(std::pow(x + y, 4) + std::pow(x - y, 4), 2.0, 1e-14) << twist.cor();
    const double slope_x = std::pow(x + y, 3) + std::pow(x - y, 3);
    const double slope_y = std::pow(x + y, 3) - std::pow(x - y, 3);
    EXPECT_NEAR(slope_x * twist.spin, slope_y * twist.slide, 1e-14) << twist.cor();
  }
}

TEST(Polygon, CornerOfTheBoxServesEveryTwistThatSlidesAndSpins) {
  const Box curve = box(1.0, 0.6);
  const UnitWrench corner{1.0, 0.6};
  for (const double s : {5e-324, 1e-300, 1e-3, 1.0, 1e3, 1e300, 1.7e308}) EXPECT_EQ(curve.wrench({s, 1.0}), corner) << s;
  EXPECT_EQ(curve.wrench({1.0, 5e-324}), corner);
  EXPECT_EQ(curve.wrench({1.0, 0.0}), (UnitWrench{1.0, 0.0}));
  EXPECT_EQ(curve.wrench({0.0, 1.0}), (UnitWrench{0.0, 0.6}));
  EXPECT_EQ(curve.gauge({0.5, 0.6}), 1.0);
  EXPECT_EQ(curve.gauge({2.0, 0.3}), 2.0);
  EXPECT_EQ(curve.along({2.0, 0.3}).normal.spin, 0.0);
  EXPECT_EQ(curve.along({0.2, 3.0}).normal.slide, 0.0);
}

TEST(Polygon, DiamondHasTwoVertices) {
  const Diamond curve = diamond(1.0, 0.6);
  EXPECT_EQ(curve.wrench(SlipTwist::about_cor(0.59)), (UnitWrench{0.0, 0.6}));
  EXPECT_EQ(curve.wrench(SlipTwist::about_cor(0.61)), (UnitWrench{1.0, 0.0}));
  EXPECT_DOUBLE_EQ(curve.gauge({0.5, 0.3}), 1.0);
}

TEST(Approximations, RefuseBadParameters) {
  const double nan = std::nan("");
  // The square of 1e-200 is 0: its ellipse had no wrench.
  for (const double bad : {0.0, -1.0, nan, inf, 1e-200, 1e200}) {
    EXPECT_THROW(Ellipse(bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(Ellipse(1.0, bad), std::invalid_argument) << bad;
    EXPECT_THROW(Superellipse(bad, 1.0, 2.0), std::invalid_argument) << bad;
    EXPECT_THROW(Superellipse(1.0, bad, 2.0), std::invalid_argument) << bad;
    if (bad != 1e200) {
      EXPECT_THROW(Superellipse(1.0, 1.0, bad), std::invalid_argument) << bad;
    }
    EXPECT_THROW(Quartic(bad, 1.0, 2.0), std::invalid_argument) << bad;
    EXPECT_THROW(Quartic(1.0, bad, 2.0), std::invalid_argument) << bad;
    EXPECT_THROW(box(bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(box(1.0, bad), std::invalid_argument) << bad;
    EXPECT_THROW(diamond(bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(diamond(1.0, bad), std::invalid_argument) << bad;
  }
  EXPECT_THROW(Superellipse(1.0, 1.0, 1.0), std::invalid_argument);
  EXPECT_THROW(Quartic(1.0, 1.0, -1e-9), std::invalid_argument);
  EXPECT_THROW(Quartic(1.0, 1.0, 6.0 + 1e-9), std::invalid_argument);
  EXPECT_THROW(Quartic(1.0, 1.0, nan), std::invalid_argument);
  EXPECT_THROW(Polygon<3>({UnitWrench{1.0, 0.0}, UnitWrench{0.4, 0.4}, UnitWrench{0.0, 1.0}}), std::invalid_argument) << "concave";
  EXPECT_THROW(Polygon<3>({UnitWrench{1.0, 0.0}, UnitWrench{1.1, 0.4}, UnitWrench{0.0, 1.0}}), std::invalid_argument) << "overhang";
  EXPECT_THROW(Polygon<2>({UnitWrench{1.0, 0.1}, UnitWrench{0.0, 1.0}}), std::invalid_argument) << "not on the axis";
  EXPECT_THROW(Polygon<2>({UnitWrench{1.0, 0.0}, UnitWrench{0.1, 1.0}}), std::invalid_argument) << "not on the axis";
  EXPECT_THROW(Polygon<3>({UnitWrench{1.0, 0.0}, UnitWrench{nan, 0.4}, UnitWrench{0.0, 1.0}}), std::invalid_argument);
}

}  // namespace

}  // namespace limitcurve::test
