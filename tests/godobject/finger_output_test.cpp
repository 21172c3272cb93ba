// SPDX-License-Identifier: MIT
// Outputs of a finger beside force and moment: margin, load to hold, position of the COR; and its state as a value.
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test {
namespace {

TEST(SoftFinger, StateIsAValue) {
  auto finger = exact_hertz_finger();
  auto other = exact_hertz_finger();
  for (int i = 0; i < 100; ++i) finger.update(on_plane(i * 1e-4, 0.0, 0.002), i * 0.01);
  other.restore(finger.state());
  for (int i = 100; i < 200; ++i) {
    finger.update(on_plane(i * 1e-4, 0.0, 0.002), i * 0.01);
    other.update(on_plane(i * 1e-4, 0.0, 0.002), i * 0.01);
    expect_same(finger.output(), other.output());
  }
}

TEST(SoftFinger, TellsTheLoadThatHolds) {
  for (const RadiusLaw& law : {RadiusLaw::constant(0.005), RadiusLaw::power(0.00207, 0.259)}) {
    FingerParameters with = parameters();
    with.radius_law = law;
    auto finger = exact_hertz_finger(with);
    finger.update(on_plane(0.0, 0.0, 0.004), 0.0);
    finger.update(on_plane(0.0005, 0.0, 0.004), 0.02);
    ASSERT_EQ(finger.output().state, ContactState::stick);
    const double load = finger.load_to_hold();
    // At that load the same offsets are on the limit: a billionth less and it slips.
    for (const double share : {1.0 - 1e-9, 1.0 + 1e-9}) {
      auto other = exact_hertz_finger(with);
      other.restore(finger.state());
      other.update(on_plane(0.0005, 0.0, share * load / with.stiffness), 0.02);
      EXPECT_EQ(other.output().state, share < 1.0 ? ContactState::slip : ContactState::stick);
    }
  }
}

// It is in the unit of the load that is reported: also on a ball, whose push is part of that, it sticks if and only if
// the load is at least the one that holds.
TEST(SoftFinger, TellsTheLoadThatHoldsInTheUnitOfTheLoad) {
  Random random(5);
  int pushes = 0;
  for (int scene = 0; scene < 300; ++scene) {
    const double radius = random.logarithmic(0.002, 0.1);
    const AnySurface ball(Ball{radius});
    auto finger = exact_hertz_finger(parameters(random.logarithmic(0.1, 1.5), 0.005, 1000.0, 0.025));
    Vector3d way(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 0.0);
    for (int i = 0; i < 60; ++i) {
      const double depth = radius * random.uniform(0.05, 0.3);
      const Vector3d at = (Vector3d::UnitZ() + 0.01 * i * way).normalized() * (radius - depth);
      const FingerOutput output = finger.update(ball, {at, Orientation::Identity(), 0.01 * i}, 1e-3);
      ASSERT_NE(output.state, ContactState::invalid);
      ASSERT_LE(finger.load_to_hold(), output.load * (1.0 + 1e-9)) << scene << ' ' << i;
      if (output.state == ContactState::slip && finger.load_to_hold() > 0.0) {
        ASSERT_GE(finger.load_to_hold(), output.load - 1e-9) << scene << ' ' << i;
        pushes += output.load < 0.99 * finger.state().limit_load;
      }
    }
  }
  EXPECT_GT(pushes, 300);
}

// Without a sliding force the moment keeps its limit and the slip its centre; without a limit of the moment, or of
// both, the proxy turns with the finger: the COR is what the proxy turns about, by its slide and its turn.
TEST(SoftFinger, TurnsAboutACentreWithoutASlidingForceOrAMoment) {
  struct Case {
    double mu, mu_dynamic, mu_r, mu_r_dynamic;
  };
  for (const Case& one : {Case{0.6, 0.0, 0.002, 0.001}, {0.6, 0.0, 0.002, 1e-5}, {0.7, 0.7, 0.0, 0.0}, {}}) {
    FingerParameters with = parameters(one.mu);
    with.mu_dynamic = one.mu_dynamic;
    with.mu_r = one.mu_r;
    with.mu_r_dynamic = one.mu_r_dynamic;
    for_each_curve(hertz(), [&](const FingerCurve& curve) {
      SoftFinger finger(curve, with);
      FingerOutput last = finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
      for (int i = 1; i < 40; ++i) {
        const FingerOutput output = finger.update(on_plane(1e-3 * i, 0.0, 0.002), 0.2 * i);
        if (i >= 10 && output.state == ContactState::slip) {
          EXPECT_NEAR(std::fabs(output.moment), 2.0 * one.mu_r_dynamic, 1e-9);
          EXPECT_NEAR(output.force.norm(), 2.0 * one.mu_dynamic, 1e-12);
          const double turn = std::fabs(output.angle - last.angle);
          EXPECT_NEAR(output.cor, (output.proxy - last.proxy).norm() / turn, 1e-9);
          if (one.mu > 0.0) {
            EXPECT_NEAR((finger.centre_of_rotation() - output.proxy).norm(), output.cor, 1e-9);
          }
        }
        last = output;
      }
      EXPECT_EQ(last.state, ContactState::slip);
      if (one.mu_r > 0.0) return;
      finger.update(on_plane(0.04, 0.0, 0.002), 0.2 * 39);
      EXPECT_TRUE((finger.centre_of_rotation().array() == infinity).all());
    });
  }
}

// A finger turns about a fixed point: that point is the centre of rotation of its slip, however far the springs give
// (0.3 to 1.5 mm under 1.5 N).
TEST(SoftFinger, TellsWhereTheCentreOfRotationIs) {
  EXPECT_TRUE(std::isnan(hertz_finger().centre_of_rotation().x()));
  const Vector3d centre{0.02, 0.01, 0.0};
  for (const double stiffness : {3000.0, 1000.0, 300.0}) {
    for (const double sense : {1.0, -1.0}) {
      FingerParameters with = parameters();
      with.stiffness = stiffness;
      auto finger = exact_hertz_finger(with);
      for (int i = 0; i <= 2000; ++i) {
        const double angle = 3e-3 * i * sense;
        const Vector3d at = centre + AngleAxisd(angle, Vector3d::UnitZ()) * Vector3d(0.004, -0.0045, 0.0);
        finger.update(on_plane(at.x(), at.y(), 1.5 / stiffness), angle, 1e-3);
      }
      ASSERT_EQ(finger.output().state, ContactState::slip);
      EXPECT_LT((finger.centre_of_rotation() - centre).norm(), 5e-5) << stiffness;
    }
  }
}

TEST(SoftFinger, HasNoCentreOfRotationInASampleThatIsInvalid) {
  auto finger = hertz_finger();
  for (int i = 0; i < 10; ++i) finger.update(on_plane(1e-3 * i, 0.0, 0.002), 0.1 * i);
  ASSERT_EQ(finger.output().state, ContactState::slip);
  finger.update(on_plane(nan, 0.0, 0.002), 1.0);
  ASSERT_EQ(finger.output().state, ContactState::invalid);
  EXPECT_TRUE(std::isnan(finger.output().cor));
  EXPECT_TRUE(std::isnan(finger.centre_of_rotation().x()));
}

TEST(SoftFinger, IsNotDampedWhereNoVelocityIsKnown) {
  FingerParameters with = parameters();
  with.damping = 5.0;
  auto finger = exact_hertz_finger(with);
  const auto load_at = [&](double depth) { return finger.update(on_plane(0.0, 0.0, depth), 0.0, 1e-3).load; };
  EXPECT_NEAR(load_at(0.002), 0.002 * with.stiffness, 1e-12);
  finger.reset();
  EXPECT_NEAR(load_at(0.002), 0.002 * with.stiffness, 1e-12);
  // 0.1 s without a sample, in which the finger goes 1 mm deeper.
  for (int i = 0; i < 100; ++i) load_at(nan);
  EXPECT_NEAR(load_at(0.003), 0.003 * with.stiffness, 1e-12);
  // From there on it is damped again.
  EXPECT_NEAR(load_at(0.0031), 0.0031 * with.stiffness + 5.0 * 1e-4 / 1e-3, 1e-9);
}

}  // namespace
}  // namespace limitcurve::godobject::test
