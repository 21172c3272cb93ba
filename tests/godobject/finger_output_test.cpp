// SPDX-License-Identifier: MIT
// What a finger tells besides force and moment: margin, load that holds, place of the COR; and its state as a value.
#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

namespace limitcurve::godobject::test {
namespace {

TEST(SoftFinger, MarginIsTheShareThatIsLeft) {
  auto finger = hertz_finger();
  EXPECT_EQ(finger.margin(), 1.0);
  finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
  EXPECT_EQ(finger.margin(), 1.0);
  finger.update(on_plane(0.0003, 0.0, 0.002), 0.0);
  EXPECT_NEAR(finger.margin(), 0.75, 1e-12);
  finger.update(on_plane(0.003, 0.0, 0.002), 0.0);
  EXPECT_EQ(finger.margin(), 0.0);
}

TEST(SoftFinger, StateIsAValue) {
  auto finger = exact_hertz_finger();
  auto other = exact_hertz_finger();
  for (int i = 0; i < 100; ++i) finger.update(on_plane(i * 1e-4, 0.0, 0.002), i * 0.01);
  other.restore(finger.state());
  for (int i = 100; i < 200; ++i) {
    finger.update(on_plane(i * 1e-4, 0.0, 0.002), i * 0.01);
    other.update(on_plane(i * 1e-4, 0.0, 0.002), i * 0.01);
    ASSERT_TRUE(same_bits(finger.output().force, other.output().force));
    ASSERT_EQ(finger.output().moment, other.output().moment);
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

// A finger that is turned about a fixed place: that place is the centre of rotation of its slip.
TEST(SoftFinger, TellsWhereTheCentreOfRotationIs) {
  for (const double sense : {1.0, -1.0}) {
    auto finger = exact_hertz_finger();
    const Eigen::Vector3d centre{0.02, 0.01, 0.0};
    for (int i = 0; i <= 4000; ++i) {
      const double angle = 1e-4 * i * sense;
      const Eigen::Vector3d at = centre + Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0.004, -0.003, 0.0);
      finger.update(on_plane(at.x(), at.y(), 0.0002), angle);
    }
    ASSERT_EQ(finger.output().state, ContactState::slip);
    // The springs trail behind a turning direction by what they give, 0.1 mm in 5 mm.
    EXPECT_LT((finger.centre_of_rotation() - centre).norm(), 2e-4);
  }
  auto finger = hertz_finger();
  EXPECT_TRUE(std::isnan(finger.centre_of_rotation().x()));
}

TEST(SoftFinger, TakesAMeasuredRadius) {
  const std::array<LoadSample, 3> samples{{{0.5, 0.002}, {1.0, 0.0026}, {4.0, 0.0034}}};
  FingerParameters with = parameters();
  with.radius_law = RadiusLaw::sampled(samples);
  for (const Projection projection : projections) {
    SoftFinger finger(exact_curve(hertz()), with, projection);
    for (const double depth : {0.0005, 0.001, 0.004}) {
      finger.reset();
      finger.update(on_plane(0.0, 0.0, depth), 0.0);
      finger.update(on_plane(0.0, 0.0, depth), 3.0);
      const double load = 1000.0 * depth;
      EXPECT_NEAR(-finger.output().moment, 0.6 * load * with.radius_law.radius(load) * hertz()->moment_ratio(), 1e-15);
      finger.update(on_plane(0.003, 0.0, depth), 3.2);
      EXPECT_NEAR(ExactCurve(hertz()).gauge(unit_wrench(finger.output(), 0.6, with.radius_law.radius(load))), 1.0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
