// SPDX-License-Identifier: MIT
#include "limitcurve/accuracy.hpp"
#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace limitcurve::godobject::test::steady_twist_test {
namespace {

constexpr double mu = 0.6;
constexpr double radius = 0.005;
constexpr double stiffness = 1000.0;
constexpr double depth = 0.002;
constexpr double load = stiffness * depth;
/// Unit wrench that a finger settles at when it is moved at a constant twist about a centre at s = c/a for long: ninety
/// times the give of the softer spring, which the length of the transient is counted in (docs/theory.md, "The step").
UnitWrench settled(const FingerCurve& curve, Projection projection, double s, double kappa) {
  const double m0 = curve.moment_ratio();
  const double twist_stiffness = kappa * stiffness * (m0 * radius) * (m0 * radius);
  SoftFinger finger(curve, parameters(mu, radius, stiffness, twist_stiffness), projection);
  const double give = std::max(mu * load / stiffness, mu * load * m0 * radius / twist_stiffness * radius);
  const double u = SlipTwist::about_cor(s).spin_fraction();
  // Two radians a step at most, or it would be taken for a wrapped angle.
  const double step = std::min(0.1 * give, 2.0 * radius / u);
  const int count = static_cast<int>(90.0 * give / step);
  for (int i = 0; i <= count; ++i) {
    finger.update(on_plane(i * step * (1.0 - u), 0.0, depth), i * step * u / radius);
  }
  EXPECT_EQ(finger.output().state, ContactState::slip);
  return unit_wrench(finger.state(), mu, radius);
}

/// Distance of two wrenches in the normalised plane x = f, y = m/m₀.
double distance(UnitWrench a, UnitWrench b, double m0) {
  return std::hypot(a.force - b.force, (a.moment - b.moment) / m0);
}

TEST(SteadyTwist, ClosestPointSettlesAtTheCurvesWrench) {
  for (const Law& law : {hertz(), uniform(), flat_punch()}) {
    const ExactCurve exact(law);
    const FingerCurve curve = exact_curve(law);
    for (const double kappa : {1e-3, 0.1, 1.0, 10.0, 1e3}) {
      for (const double s : {1e-3, 0.3, 1.0, 4.0, 1e3}) {
        const UnitWrench expected = exact.wrench(SlipTwist::about_cor(s));
        EXPECT_LT(distance(settled(curve, Projection::closest_point, s, kappa), expected, exact.moment_ratio()), 1e-9)
            << law->name() << " kappa " << kappa << " s " << s;
      }
    }
  }
}

TEST(SteadyTwist, ClosestPointOnATableSettlesAtEquation17) {
  const ExactCurve curve(hertz());
  const Table table = Table::build(hertz(), 1e-8);
  for (const double kappa : {1e-3, 0.1, 1.0, 10.0, 1e3}) {
    for (const double s : {1e-3, 0.3, 1.0, 4.0, 1e3}) {
      const UnitWrench expected = curve.wrench(SlipTwist::about_cor(s));
      const UnitWrench found = settled(table, Projection::closest_point, s, kappa);
      EXPECT_NEAR(found.force, expected.force, accuracy::steady_wrench) << "kappa " << kappa << " s " << s;
      EXPECT_NEAR(found.moment, expected.moment, accuracy::steady_wrench) << "kappa " << kappa << " s " << s;
    }
  }
}

TEST(SteadyTwist, RadialSettlesAtTheStiffnessRatio) {
  for (const double kappa : {0.1, 1.0, 10.0}) {
    const FingerCurve curve = exact_curve(hertz());
    const double m0 = curve.moment_ratio();
    // F/M = (k_l/k_r) c for any curve: f/m = s/(κ m₀²).
    const UnitWrench found = settled(curve, Projection::radial, 1.0, kappa);
    EXPECT_NEAR(found.force / found.moment * kappa * m0 * m0, 1.0, 1e-9);
  }
}

TEST(SteadyTwist, ClosestPointObeysALoadDependentRadius) {
  const ExactCurve curve(hertz());
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  const double a = soft.radius_law.radius(load);
  SoftFinger finger(exact_curve(hertz()), soft);
  const double c = 0.7 * a;
  for (int i = 0; i <= 2000; ++i) finger.update(on_plane(i * 1e-5, 0.0, depth), i * 1e-5 / c);
  const UnitWrench expected = curve.wrench(SlipTwist::about_cor(0.7));
  EXPECT_NEAR(finger.output().force.norm(), mu * load * expected.force, 1e-9);
  EXPECT_NEAR(std::fabs(finger.output().moment), mu * load * a * expected.moment, 1e-11);
  EXPECT_NEAR(finger.output().cor, c, 1e-6 * c);
}

/// Slip, in lengths max(μP/k_l, aΓ/k_r), after which a finger that starts from rest stays within accuracy::steady_wrench of eq. (17), under a
/// twist about s = c/a at the stiffness ratio κ, with a radius that grows with the load. Twice `longest` is looked at.
double settled_after(const Law& law, const Table& table, double kappa, double s, double pressed, double longest) {
  const double m0 = law->moment_ratio();
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  const double a = soft.radius_law.radius(stiffness * pressed);
  soft.twist_stiffness = kappa * stiffness * (m0 * a) * (m0 * a);
  SoftFinger finger(table, soft);
  const double limit = mu * stiffness * pressed;
  const double length = std::max(limit / stiffness, a * limit * m0 * a / soft.twist_stiffness);
  const double u = SlipTwist::about_cor(s).spin_fraction();
  const UnitWrench expected = law->evaluate(s).wrench;
  const double step = std::min(0.05 * length, 2.0 * a / u);
  double last = 0.0;
  for (int n = 0; n * step <= 2.0 * longest * length; ++n) {
    finger.update(on_plane(n * step * (1.0 - u), 0.0, pressed), n * step * u / a);
    const UnitWrench felt = unit_wrench(finger.state(), mu, a);
    if (std::hypot(felt.force - expected.force, felt.moment - expected.moment) > accuracy::steady_wrench) last = n * step;
  }
  return last / length;
}

// Stiffness ratios and centres of rotation over six decades each, every half decade, and where the transient is longest, at light and
// heavy loads: eq. (17) at once, and the transient no longer than docs/theory.md says.
TEST(SteadyTwist, ForgetsTheStartInTheLengthDocumented) {
  const auto forgets = [](const Law& law, double longest, double kappa, double s) {
    const Table table = Table::build(law, 1e-8);
    for (int i = -6; i <= 6; ++i) {
      for (int j = -6; j <= 6; ++j) {
        const double pressed = (i + j) % 2 == 0 ? 0.002 : 0.0002;
        EXPECT_LT(settled_after(law, table, std::pow(10.0, 0.5 * i), std::pow(10.0, 0.5 * j), pressed, longest), longest)
            << law->name() << ": kappa 10^" << 0.5 * i << " s 10^" << 0.5 * j;
      }
    }
    const double found = settled_after(law, table, kappa, s, 0.002, longest);
    EXPECT_LT(found, longest) << law->name();
    // And the bound is no idle one.
    EXPECT_GT(found, 0.8 * longest) << law->name();
  };
  forgets(hertz(), 40.0, 1.7, 0.74);
  forgets(flat_punch(), 60.0, 1.3, 0.99);
  // Where 24 lengths were said to be enough.
  EXPECT_GT(settled_after(hertz(), Table::build(hertz(), 1e-8), 1.88, 0.78, 0.002, 40.0), 24.0);
}

// The path of a finger that slides and turns through a bend: with half the time step it is at least twice as near to
// the path of very small steps.
TEST(SteadyTwist, HalvingTheTimeStepHalvesThePathError) {
  const FingerCurve curve = exact_curve(uniform());
  const auto run = [&](int steps) {
    SoftFinger finger(curve, parameters());
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      finger.update(on_plane(0.01 * t, 0.01 * t * t, depth), 2.0 * t * t * t);
    }
    const FingerOutput output = finger.output();
    return Eigen::Vector3d(output.proxy.x() / radius, output.proxy.y() / radius, output.angle);
  };
  const Eigen::Vector3d limit = run(1 << 17);
  double last = (run(64) - limit).norm();
  EXPECT_GT(last, 1e-5);
  for (int steps = 128; steps <= 2048; steps *= 2) {
    const double error = (run(steps) - limit).norm();
    EXPECT_LT(error, 0.55 * last) << steps;
    last = error;
  }
}

// What docs/paper.md says of eq. (23) and of the c-curve where the radius grows with the load: 0.255 N, and 0.438, 0.416, 0.4135 N in steps of
// 100, 10, 1 µm, where eq. (17) has 0.487 N.
TEST(SteadyTwist, GrowingRadius) {
  const Table table = Table::build(hertz(), 1e-8);
  const auto force = [&](Projection projection, double step) {
    FingerParameters with = parameters(0.6, 0.006, 1000.0, 0.036);
    with.radius_law = RadiusLaw::power(0.006, 1.0 / 3.0);
    SoftFinger finger(table, with, projection);
    const int count = static_cast<int>(std::lround(0.04 / step));
    for (int i = 0; i <= count; ++i) finger.update(on_plane(step * i, 0.0, 0.001), step * i / 0.005);
    return finger.output().force.norm();
  };
  EXPECT_NEAR(force(Projection::radial, 1e-5), 0.255, 0.0005);
  EXPECT_NEAR(force(Projection::c_curve, 1e-4), 0.438, 0.0005);
  EXPECT_NEAR(force(Projection::c_curve, 1e-5), 0.416, 0.0005);
  EXPECT_NEAR(force(Projection::c_curve, 1e-6), 0.4135, 0.0005);
  // (3π/8)s(1 − s²/4), s = 5/6.
  const double s = 5.0 / 6.0;
  EXPECT_NEAR(force(Projection::closest_point, 1e-5), 0.6 * 3.0 * std::numbers::pi / 8.0 * s * (1.0 - 0.25 * s * s), 1e-7);
}

}  // namespace
}  // namespace limitcurve::godobject::test::steady_twist_test
