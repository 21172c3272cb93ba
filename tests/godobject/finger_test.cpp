// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::finger_test {
namespace {

constexpr double pi = std::numbers::pi;

TEST(SoftFinger, IsFreeUntilItTouches) {
  auto finger = hertz_finger();
  const FingerOutput output = finger.update(on_plane(0.01, -0.02, -0.001), 0.3);
  EXPECT_EQ(output.state, ContactState::free);
  EXPECT_EQ(output.proxy, Vector3d(0.01, -0.02, 0.001));
  EXPECT_EQ(output.angle, 0.3);
  EXPECT_EQ(output.load, 0.0);
  EXPECT_EQ(output.depth, -0.001);
  EXPECT_TRUE(std::isnan(output.cor));
  EXPECT_EQ(finger.update(on_plane(0.01, -0.02, 0.0), 0.3).state, ContactState::free);
}

TEST(SoftFinger, TouchesDownWithoutFriction) {
  auto finger = hertz_finger();
  finger.update(on_plane(0.0, 0.0, -0.001), 5.0);
  const FingerOutput output = finger.update(on_plane(0.001, 0.002, 0.003), 7.0);
  EXPECT_EQ(output.state, ContactState::stick);
  EXPECT_EQ(output.proxy, Vector3d(0.001, 0.002, 0.0));
  EXPECT_EQ(output.angle, 7.0);
  EXPECT_EQ(output.force, Vector3d::Zero());
  EXPECT_EQ(output.moment, 0.0);
  EXPECT_DOUBLE_EQ(output.load, 3.0);
}

TEST(SoftFinger, PullsBackTowardsTheProxy) {
  auto finger = hertz_finger();
  finger.update(on_plane(0.0, 0.0, 0.002), 1.0);
  const FingerOutput output = finger.update(on_plane(0.0003, -0.0004, 0.002), 1.01);
  EXPECT_EQ(output.state, ContactState::stick);
  EXPECT_DOUBLE_EQ(output.force.x(), -0.3);
  EXPECT_DOUBLE_EQ(output.force.y(), 0.4);
  EXPECT_EQ(output.force.z(), 0.0);
  EXPECT_NEAR(output.moment, -0.0004, 1e-16);
}

// In 360 directions of force and moment, sense included: it sticks 1e-12 inside the curve and slips 2e-12 outside,
// for any projection, with a constant, a load-dependent and a measured radius; and both components pull back to the
// proxy.
TEST(SoftFinger, SlipBeginsOnTheCurve) {
  constexpr double inside = 1.0 - 1e-12;
  constexpr double outside = 1.0 + 2e-12;
  const std::array<LoadSample, 3> samples{{{0.5, 0.002}, {1.0, 0.0026}, {4.0, 0.0034}}};
  for_each_curve_and_projection(hertz(), [&](const FingerCurve& curve, Projection projection) {
    for (const RadiusLaw& law :
         {RadiusLaw::constant(0.005), RadiusLaw::power(0.00207, 0.259), RadiusLaw::sampled(samples)}) {
      FingerParameters with = parameters();
      with.radius_law = law;
      const double load = 2.0;
      SoftFinger finger(curve, with, projection);
      for (int i = 0; i < 360; ++i) {
        const double angle = 2.0 * pi * (i + 0.5) / 360.0;
        const UnitWrench direction{std::fabs(std::cos(angle)), curve.moment_ratio() * std::fabs(std::sin(angle))};
        const UnitWrench limit = curve.along(direction).wrench;
        for (const double share : {inside, outside}) {
          finger.reset();
          finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
          const double r = share * limit.force * with.mu * load / with.stiffness;
          const double rho = share * limit.moment * with.mu * load * law.radius(load) / with.twist_stiffness;
          // The direction of the trial deflection turns as well.
          const FingerOutput output =
              finger.update(on_plane(r * std::cos(3.0 * angle), r * std::sin(3.0 * angle), 0.002),
                            std::copysign(rho, std::sin(angle)));
          EXPECT_EQ(output.state, share < 1.0 ? ContactState::stick : ContactState::slip) << i;
          EXPECT_LE(output.force.x() * std::cos(3.0 * angle), 0.0);
          EXPECT_LE(output.force.y() * std::sin(3.0 * angle), 0.0);
          EXPECT_LE(output.moment * std::sin(angle), 0.0);
        }
      }
    }
  });
}

TEST(FingerCurve, OfABoxBearsWhatItsTwistSlips) {
  const FingerCurve curve = box(0.5, 3.0);
  EXPECT_EQ(curve.wrench({2.0, 0.0}), (UnitWrench{0.5, 0.0}));
  EXPECT_EQ(curve.wrench({0.0, 2.0}), (UnitWrench{0.0, 3.0}));
  EXPECT_EQ(curve.wrench({2.0, 1e-9}), (UnitWrench{0.5, 3.0}));
}

TEST(FingerCurve, OfAViewKeepsItsOwner) {
  auto table = std::make_shared<const Table>(Table::build(hertz(), 1e-6));
  const std::weak_ptr<const Table> watch = table;
  const UnitWrench wrench = table->wrench({1.0, 2.0});
  {
    const CurveView<double> view = table->view();
    const FingerCurve copy = FingerCurve(view, std::move(table));
    EXPECT_EQ(copy.wrench({1.0, 2.0}), wrench);
    EXPECT_FALSE(watch.expired());
  }
  EXPECT_TRUE(watch.expired());
}

/// Γ is what the parameters say, what a fit of a growing contact gives among them: whatever the radius law, in any unit
/// of the curve's force, at rest the static one.
TEST(SoftFinger, MomentCoefficientSetsTheLimit) {
  for (const FingerCurve& curve : {exact_curve(hertz()), FingerCurve(Ellipse(2.0, 0.6)), FingerCurve(box(0.5, 3.0))}) {
    for (const RadiusLaw& law :
         {RadiusLaw::constant(0.001), RadiusLaw::hertz(0.008, 2e5), RadiusLaw::power(0.00207, 0.259)}) {
      for (const double exponent : {-0.5, -0.1, 0.0, 0.257, 1.0}) {
        for (const double mu_dynamic : {0.6, 0.4}) {
          FingerParameters with = parameters();
          with.radius_law = law;
          with.mu_dynamic = mu_dynamic;
          with.mu_r = 0.00384;
          with.mu_r_dynamic = 0.0028;
          with.gamma = exponent;
          for (const Projection projection : projections) {
            if (curve.is_box() && projection != Projection::closest_point) continue;
            SoftFinger finger(curve, with, projection);
            for (const double depth : {0.0001, 0.0005, 0.004}) {
              finger.reset();
              finger.update(on_plane(0.0, 0.0, depth), 0.0);
              const double power = std::pow(with.stiffness * depth, 1.0 + exponent);
              finger.update(on_plane(0.0, 0.0, depth), 0.99 * 0.00384 * power / with.twist_stiffness);
              EXPECT_EQ(finger.output().state, ContactState::stick) << exponent;
              finger.update(on_plane(0.0, 0.0, depth), 3.0);
              EXPECT_NEAR(finger.output().moment / (-0.0028 * power), 1.0, 1e-12) << exponent << ' ' << depth;
            }
          }
        }
      }
    }
  }
}

TEST(SoftFinger, DynamicLimitActsWhileItSlips) {
  FingerParameters with = parameters();
  with.mu_dynamic = 0.4;
  auto finger = hertz_finger(with);
  const double depth = 0.002;  // sticking limit 1.2 N, dynamic 0.8 N
  finger.update(on_plane(0.0, 0.0, depth), 0.0);
  finger.update(on_plane(0.00119, 0.0, depth), 0.0);
  EXPECT_EQ(finger.output().state, ContactState::stick);
  finger.update(on_plane(0.00121, 0.0, depth), 0.0);
  EXPECT_EQ(finger.output().state, ContactState::slip);
  EXPECT_DOUBLE_EQ(finger.output().force.x(), -0.8);
  finger.update(on_plane(0.00122, 0.0, depth), 0.0);
  EXPECT_EQ(finger.output().state, ContactState::slip);
  EXPECT_DOUBLE_EQ(finger.output().force.x(), -0.8);
  // A step back is within the sliding limit, but by less than 0.4 of the gap: it still slides.
  finger.update(on_plane(0.00121, 0.0, depth), 0.0);
  EXPECT_EQ(finger.output().state, ContactState::stick);
  finger.update(on_plane(0.00123, 0.0, depth), 0.0);
  EXPECT_EQ(finger.output().state, ContactState::slip);
  EXPECT_DOUBLE_EQ(finger.output().force.x(), -0.8);
  // Within 0.8 N/(1 + 0.4 · (0.6/0.4 − 1)) it rests, and then holds up to the sticking limit.
  finger.update(on_plane(0.00123 - 0.000134, 0.0, depth), 0.0);
  EXPECT_NEAR(finger.output().force.x(), -0.666, 1e-12);
  EXPECT_EQ(finger.output().state, ContactState::stick);
  finger.update(on_plane(0.00156, 0.0, depth), 0.0);
  EXPECT_EQ(finger.output().state, ContactState::stick);
  EXPECT_NEAR(finger.output().force.x(), -1.13, 1e-12);
}

// 1e4 turns of an angle that wraps, forwards and backwards: 2e-8 is a few roundings of the angle.
TEST(SoftFinger, TenThousandTurnsLoseNoAngle) {
  for (const int sense : {1, -1}) {
    auto finger = hertz_finger();
    for (int i = 0; i <= 100000; ++i) {
      const long double angle = 0.2L * std::numbers::pi_v<long double> * sense * i;
      finger.update(on_plane(0.0, 0.0, 0.002),
                    static_cast<double>(std::remainder(angle, 2.0L * std::numbers::pi_v<long double>)));
      ASSERT_NEAR(finger.state().sample.angle, static_cast<double>(angle), 2e-8) << i;
    }
    EXPECT_GT(-sense * finger.output().moment, 0.0);
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test::finger_test
