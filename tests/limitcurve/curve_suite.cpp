// SPDX-License-Identifier: MIT
// What every limit curve must satisfy (limit_curve.hpp), one test a requirement, instantiated for every kind.
#include "tests/limitcurve/shared.hpp"
#include "tests/superellipse.hpp"

namespace limitcurve::test::curve_suite {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A curve of any type, with the requirements on it.
struct Tested {
  std::string name;
  std::function<UnitWrench(SlipTwist)> wrench;
  std::function<SlopedPoint(SlipTwist)> point;
  std::function<RadialPoint(UnitWrench)> along;
  std::function<double(UnitWrench)> gauge;
  double moment_ratio = 0.0;
  /// Relative error of a point's distance along its normal.
  double support_error = 8 * epsilon;
  /// By how much its tangent is off the right angle to the twist, relative: 0 unless it interpolates.
  double normal_error = 1e-12;
  /// Has faces and corners: the same wrench for many twists.
  bool polygonal = false;
  /// An exponent p of f ∝ s^p as s → 0: 1 if the curve bends at its ends like an ellipse.
  double end_exponent = 1.0;
};

void PrintTo(const Tested& curve, std::ostream* stream) {
  *stream << curve.name;
}

template <LimitCurve Curve>
Tested tested(std::string name, const Curve& curve) {
  Tested result;
  result.name = std::move(name);
  result.wrench = [curve](SlipTwist twist) { return curve.wrench(twist); };
  result.point = [curve](SlipTwist twist) { return curve.point(twist); };
  result.along = [curve](UnitWrench wrench) { return curve.along(wrench); };
  result.gauge = [curve](UnitWrench wrench) { return curve.gauge(wrench); };
  result.moment_ratio = curve.moment_ratio();
  return result;
}

template <std::size_t count>
Tested polygonal(std::string name, const Polygon<count>& curve) {
  Tested result = tested(std::move(name), curve);
  result.polygonal = true;
  return result;
}

Tested superellipse(std::string name, double exponent) {
  Tested result = tested(std::move(name), Superellipse{1.1, 0.6, exponent});
  result.end_exponent = 1.0 / (exponent - 1.0);
  return result;
}

std::vector<Tested> all_curves() {
  return {
      tested("exact_hertz", ExactCurve(hertz())),
      tested("exact_uniform", ExactCurve(uniform())),
      tested("exact_flat_punch", ExactCurve(flat_punch())),
      tested("exact_cone", ExactCurve(cone())),
      tested("exact_gaussian", ExactCurve(gaussian(0.4))),
      tested("ellipse", Ellipse::through_intercepts(0.58)),
      tested("slender_ellipse", Ellipse(2.0, 1e-3)),
      superellipse("superellipse_1p05", 1.05),
      superellipse("superellipse_1p7", 1.7),
      superellipse("superellipse_2", 2.0),
      superellipse("superellipse_3", 3.0),
      superellipse("superellipse_50", 50.0),
      tested("table_hertz_1em3", Table::build(hertz(), 1e-3)),
      tested("table_uniform_1em6", Table::build(uniform(), 1e-6)),
      tested("table_flat_punch_1em9", Table::build(flat_punch(), 1e-9)),
      tested("table_power_1em11", Table::build(power(-0.9), 1e-11)),
      tested("table_gaussian_1em12", Table::build(gaussian(0.4), 1e-12)),
      tested("table_superellipse_1em8", Table::build(Superellipse{1.1, 0.6, 1.725}, 1e-8, {.name = "superellipse"})),
      polygonal("box", box(1.0, 0.6)),
      polygonal("diamond", diamond(1.2, 0.5)),
      polygonal("octagon",
                Polygon<4>({UnitWrench{1.0, 0.0}, UnitWrench{0.9, 0.3}, UnitWrench{0.4, 0.55}, UnitWrench{0.0, 0.6}}))};
}

/// Degenerate, nearly degenerate, generic and seeded random twists, from pure spin to pure sliding.
std::vector<SlipTwist> many_twists() {
  std::vector<double> cors{0.0,         1e-300, 1e-150, 1e-16, 1e-8,  1e-3,  1.0 - 1e-12, 1.0,
                           1.0 + 1e-12, 1e3,    1e8,    1e16,  1e150, 1e300, inf};
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> decade(-4.0, 4.0);
  for (int i = 0; i < 150; ++i) cors.push_back(std::pow(10.0, decade(random)));
  std::uniform_real_distribution<double> angle(0.0, 1.5707963);
  for (int i = 0; i < 150; ++i) cors.push_back(std::tan(angle(random)));
  std::sort(cors.begin(), cors.end());
  std::vector<SlipTwist> twists;
  for (const double cor : cors) twists.push_back(SlipTwist::about_cor(cor));
  return twists;
}

/// What a wrench takes from a twist, per μPaω: the distance along the normal.
double power_of(SlipTwist twist, UnitWrench wrench) {
  return twist.slide * wrench.force + twist.spin * wrench.moment;
}

class CurveSuite : public testing::TestWithParam<Tested> {
 protected:
  const Tested& curve() const { return GetParam(); }
  const std::vector<SlipTwist> twists_ = many_twists();
};

TEST_P(CurveSuite, EndsOnTheAxes) {
  const UnitWrench spin = curve().wrench({0.0, 1.0});
  const UnitWrench slide = curve().wrench({1.0, 0.0});
  EXPECT_EQ(spin.force, 0.0);
  EXPECT_EQ(slide.moment, 0.0);
  EXPECT_GT(slide.force, 0.0);
  EXPECT_NEAR(spin.moment / slide.force / curve().moment_ratio, 1.0, 2 * epsilon);
}

TEST_P(CurveSuite, NoSlipGivesNoWrench) {
  EXPECT_EQ(curve().wrench({0.0, 0.0}), UnitWrench{});
  EXPECT_EQ(curve().wrench({-0.0, 0.0}), UnitWrench{});
}

/// Twists and wrenches are magnitudes, whatever the senses of sliding and turning: every member gives the same bits.
TEST_P(CurveSuite, SignsAreIgnored) {
  for (const SlipTwist twist : twists_) {
    const UnitWrench wrench = curve().wrench(twist);
    const SlopedPoint point = curve().point(twist);
    const RadialPoint ray = curve().along(wrench);
    for (const auto& [x, y] : {std::pair{-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}) {
      SCOPED_TRACE(twist.cor());
      const SlipTwist signed_twist{x * twist.slide, y * twist.spin};
      const UnitWrench signed_wrench{x * wrench.force, y * wrench.moment};
      EXPECT_EQ(curve().wrench(signed_twist), wrench);
      const SlopedPoint signed_point = curve().point(signed_twist);
      EXPECT_TRUE(signed_point.wrench == point.wrench && signed_point.slope == point.slope);
      const auto [found, normal] = curve().along(signed_wrench);
      EXPECT_TRUE(found == ray.wrench && normal.slide == ray.normal.slide && normal.spin == ray.normal.spin);
      EXPECT_EQ(curve().gauge(signed_wrench), curve().gauge(wrench));
    }
  }
}

/// A slip of any size, and a ray by a vector of any length. The squares of 1e-200 are 0: the ellipse had an infinite
/// wrench.
TEST_P(CurveSuite, OnlyTheDirectionCounts) {
  for (const SlipTwist twist : twists_) {
    const UnitWrench wrench = curve().wrench(twist);
    const UnitWrench ray = curve().along(wrench).wrench;
    for (const double size : {0x1p-700, 0x1p700}) {
      if (std::min(twist.slide, twist.spin) * size < 1e-300 && !(twist.slide == 0.0 || twist.spin == 0.0))
        continue;  // it is another direction
      const UnitWrench scaled = curve().wrench({twist.slide * size, twist.spin * size});
      const UnitWrench scaled_ray = curve().along({wrench.force * size, wrench.moment * size}).wrench;
      EXPECT_LE(apart(scaled, wrench), 4 * epsilon) << twist.cor() << ' ' << size;
      EXPECT_LE(apart(scaled_ray, ray), 4 * epsilon) << twist.cor() << ' ' << size;
    }
  }
}

/// No curve point, by `along`, which is another piece of code, is further along the normal than the
/// one that `wrench` gives: maximum dissipation.
TEST_P(CurveSuite, WrenchSupportsAmongTheRays) {
  constexpr int rays = 400;
  std::vector<UnitWrench> points;
  for (int i = 0; i <= rays; ++i) {
    points.push_back(
        curve().along({static_cast<double>(rays - i), curve().moment_ratio * static_cast<double>(i)}).wrench);
  }
  for (const SlipTwist twist : twists_) {
    const double own = power_of(twist, curve().wrench(twist));
    double most = 0.0;
    for (const UnitWrench& point : points) most = std::max(most, power_of(twist, point));
    EXPECT_LE(most, own * (1.0 + curve().support_error)) << twist.cor();
    // The rays are dense enough that one of them comes near.
    EXPECT_GE(most, own * (1.0 - (curve().polygonal ? 5e-3 : 2e-3))) << twist.cor();
  }
}

/// Of degree one, and 1 on the curve.
TEST_P(CurveSuite, GaugeIsHomogeneous) {
  EXPECT_EQ(curve().gauge({0.0, 0.0}), 0.0);
  for (const SlipTwist twist : twists_) {
    const UnitWrench wrench = curve().wrench(twist);
    for (const double factor : {1e-120, 1e-9, 0.5, 1.0, 3.0, 1e9, 1e120}) {
      const double gauge = curve().gauge({factor * wrench.force, factor * wrench.moment});
      EXPECT_NEAR(gauge / factor, 1.0, 12 * epsilon) << twist.cor() << ' ' << factor;
    }
  }
}

/// A NaN never holds.
TEST_P(CurveSuite, GaugeKeepsNaNAndInfinity) {
  for (const double other : {0.0, 0.3, -0.3, inf, nan}) {
    for (const bool force_first : {true, false}) {
      const auto pair = [&](double value) { return force_first ? std::pair(value, other) : std::pair(other, value); };
      const auto [force, moment] = pair(nan);
      EXPECT_TRUE(std::isnan(curve().gauge({force, moment}))) << force << ' ' << moment;
      const UnitWrench wrench = curve().wrench({force, moment});
      EXPECT_TRUE(std::isnan(wrench.force) && std::isnan(wrench.moment)) << force << ' ' << moment;
      const auto [large_force, large_moment] = pair(-inf);
      if (std::isnan(other)) continue;
      EXPECT_EQ(curve().gauge({large_force, large_moment}), inf);
      if (std::isinf(other)) continue;
      EXPECT_EQ(curve().wrench({large_force, large_moment}),
                curve().wrench(force_first ? SlipTwist{1, 0} : SlipTwist{0, 1}));
    }
  }
}

/// The ray through a curve point meets the curve there.
TEST_P(CurveSuite, AlongFindsThePointAgain) {
  for (const SlipTwist twist : twists_) {
    const UnitWrench wrench = curve().wrench(twist);
    for (const double factor : {1e-3, 1.0, 1e3}) {
      const UnitWrench again = curve().along({factor * wrench.force, factor * wrench.moment}).wrench;
      // Absolute at the ends: another curve's search may resolve 1e-16 of the spin fraction.
      EXPECT_TRUE(are_near(again, wrench,
                           {2e-15 * curve().wrench({1.0, 0.0}).force, 2e-15 * curve().wrench({0.0, 1.0}).moment}))
          << twist.cor();
    }
  }
}

/// A search that resolves 1e-16 of the spin fraction is off by 2e-4 here: half of the load lies within 1e-9 of the
/// radius.
TEST(ExactCurve, FindsSlipsBesideTheCentreOfASharpPeak) {
  const ExactCurve curve(xydas_kao(0.02));
  for (double s = 1.0; s > 1e-60; s /= 30.0) {
    const UnitWrench wrench = curve.wrench(SlipTwist::about_cor(s));
    const auto [found, normal] = curve.along(wrench);
    EXPECT_TRUE(are_near_in_relative_terms(found, wrench, 1e-13)) << s;
    EXPECT_NEAR(normal.cor() / s, 1.0, 1e-11) << s;
  }
}

/// The normal that `along` gives supports the point that it gives.
TEST_P(CurveSuite, NormalAlongARaySupportsItsPoint) {
  for (const SlipTwist twist : twists_) {
    const auto [wrench, normal] = curve().along(curve().wrench(twist));
    EXPECT_GE(normal.slide, 0.0);
    EXPECT_GE(normal.spin, 0.0);
    const double own = power_of(normal, wrench);
    EXPECT_GT(own, 0.0);
    EXPECT_NEAR(power_of(normal, curve().wrench(normal)) / own, 1.0, 2 * curve().support_error) << twist.cor();
  }
}

/// … and where the curve is smooth it is the twist itself.
TEST_P(CurveSuite, NormalAlongARayIsTheTwist) {
  if (curve().polygonal) return;  // faces have one normal, corners many
  for (const SlipTwist twist : twists_) {
    const double u = twist.spin_fraction();
    const SlopedPoint point = curve().point(twist);
    const double turning = std::hypot(point.slope.force, point.slope.moment);
    // Near a corner the curve hardly changes with the twist, so the wrench does not determine the twist.
    if (turning < 1e-3) continue;
    EXPECT_NEAR(curve().along(point.wrench).normal.spin_fraction(), u, 1e-15 + 8 * epsilon / turning) << twist.cor();
  }
}

TEST_P(CurveSuite, PointIsTheWrench) {
  for (const SlipTwist twist : twists_) {
    const UnitWrench wrench = curve().wrench(twist);
    // The exact curve's point stops at u = 1e-80, where the slope still has a finite square.
    EXPECT_TRUE(
        are_near(curve().point(twist).wrench, wrench, {1e-13 * wrench.force + 1e-79, 1e-13 * wrench.moment + 1e-79}))
        << twist.cor();
  }
}

/// The slope against central differences in u, and its signs.
TEST_P(CurveSuite, SlopeIsThatOfTheWrench) {
  for (const SlipTwist twist : twists_) {
    const UnitWrench slope = curve().point(twist).slope;
    EXPECT_LE(slope.force, 0.0) << twist.cor();
    EXPECT_GE(slope.moment, 0.0) << twist.cor();
    EXPECT_TRUE(std::isfinite(slope.force) && std::isfinite(slope.moment)) << twist.cor();
    const double u = twist.spin_fraction();
    const double step = 1e-5 * u * (1.0 - u);
    // At corners, at the rim (s = 1) and at the ends a difference says nothing.
    if (curve().polygonal || step < 1e-9 || std::fabs(u - 0.5) < 1e-3) continue;
    const UnitWrench before = curve().wrench(SlipTwist::of_spin_fraction(u - step));
    const UnitWrench after = curve().wrench(SlipTwist::of_spin_fraction(u + step));
    const UnitWrench found{(after.force - before.force) / (2 * step), (after.moment - before.moment) / (2 * step)};
    const double rounding = 4 * epsilon / step;
    EXPECT_TRUE(are_near(found, slope, {-1e-5 * slope.force + rounding, 1e-5 * slope.moment + rounding}))
        << twist.cor();
  }
}

/// The twist is the normal: it is at right angles with the slope.
TEST_P(CurveSuite, SlopeIsAtRightAnglesToTheTwist) {
  for (const SlipTwist twist : twists_) {
    // Where u or 1 − u is below 1e-80 the slope is that of 1e-80.
    if (!(twist.cor() > 1e-60 && twist.cor() < 1e60)) continue;
    const UnitWrench slope = curve().point(twist).slope;
    const double along_force = -twist.slide * slope.force;
    const double along_moment = twist.spin * slope.moment;
    EXPECT_NEAR(along_force, along_moment, curve().normal_error * std::max(along_force, along_moment) + 1e-300)
        << twist.cor();
  }
}

/// From pure spin to pure sliding the force never falls, the moment never rises, and every chord lies between the
/// normals at its ends, s₁ ≤ −Δm/Δf ≤ s₂: convexity without a step size.
TEST_P(CurveSuite, IsMonotoneAndConvex) {
  for (std::size_t i = 1; i < twists_.size(); ++i) {
    const UnitWrench from = curve().wrench(twists_[i - 1]);
    const UnitWrench to = curve().wrench(twists_[i]);
    const double rise = to.force - from.force;
    const double fall = from.moment - to.moment;
    const double forgiven = curve().support_error;
    EXPECT_GE(rise, -forgiven * to.force);
    EXPECT_GE(fall, -forgiven * from.moment);
    const auto excess = [&](SlipTwist normal) { return normal.spin * fall - normal.slide * rise; };
    EXPECT_GE(excess(twists_[i - 1]), -forgiven * power_of(twists_[i - 1], from)) << twists_[i].cor();
    EXPECT_LE(excess(twists_[i]), forgiven * power_of(twists_[i], to)) << twists_[i].cor();
  }
}

/// Both components keep their digits towards the ends: f ∝ s^p as s → 0, m ∝ s^−p as s → ∞, over a hundred decades.
TEST_P(CurveSuite, KeepsItsDigitsTowardsTheEnds) {
  // A polygon's ends are vertices; the powers of a near-diamond leave the range of doubles.
  if (curve().polygonal || curve().end_exponent > 5.0) return;
  for (const double decade : {30.0, 60.0, 130.0}) {
    const double expected = std::pow(10.0, -10.0 * curve().end_exponent);
    const double near_spin = curve().wrench(SlipTwist::about_cor(std::pow(10.0, -decade - 10.0))).force /
                             curve().wrench(SlipTwist::about_cor(std::pow(10.0, -decade))).force;
    const double near_slide = curve().wrench(SlipTwist::about_cor(std::pow(10.0, decade + 10.0))).moment /
                              curve().wrench(SlipTwist::about_cor(std::pow(10.0, decade))).moment;
    EXPECT_NEAR(near_spin / expected, 1.0, 1e-13) << decade;
    EXPECT_NEAR(near_slide / expected, 1.0, 1e-13) << decade;
  }
}

INSTANTIATE_TEST_SUITE_P(EveryCurve, CurveSuite, testing::ValuesIn(all_curves()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace

}  // namespace limitcurve::test::curve_suite
