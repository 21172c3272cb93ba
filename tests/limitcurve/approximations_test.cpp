// SPDX-License-Identifier: MIT
// What each approximation is, beyond being a limit curve (curve_suite.cpp).

#include "tests/limitcurve/shared.hpp"

namespace limitcurve::test {

namespace {

TEST(Polygon, CornerOfTheBoxServesEveryTwistThatSlidesAndSpins) {
  const Box curve = box(1.0, 0.6);
  const UnitWrench corner{1.0, 0.6};
  for (const double s : {5e-324, 1e-300, 1e-3, 1.0, 1e3, 1e300, 1.7e308})
    EXPECT_EQ(curve.wrench({s, 1.0}), corner) << s;
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
  // The square of 1e-200 is 0.
  for (const double bad : {0.0, -1.0, nan, inf, 1e-200, 1e200}) {
    EXPECT_THROW(Ellipse(bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(Ellipse(1.0, bad), std::invalid_argument) << bad;
    EXPECT_THROW(box(bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(box(1.0, bad), std::invalid_argument) << bad;
    EXPECT_THROW(diamond(bad, 1.0), std::invalid_argument) << bad;
    EXPECT_THROW(diamond(1.0, bad), std::invalid_argument) << bad;
  }
  using Three = std::array<UnitWrench, 3>;
  for (const auto& [vertices, what] : {std::pair{Three{{{1.0, 0.0}, {0.4, 0.4}, {0.0, 1.0}}}, "concave"},
                                       {Three{{{1.0, 0.0}, {1.1, 0.4}, {0.0, 1.0}}}, "overhang"},
                                       {Three{{{1.0, 0.1}, {0.8, 0.8}, {0.0, 1.0}}}, "not on the axis"},
                                       {Three{{{1.0, 0.0}, {0.8, 0.8}, {0.1, 1.0}}}, "not on the axis"},
                                       {Three{{{1.0, 0.0}, {nan, 0.4}, {0.0, 1.0}}}, "not a number"}})
    EXPECT_THROW(Polygon<3>{vertices}, std::invalid_argument) << what;
}

}  // namespace

}  // namespace limitcurve::test
