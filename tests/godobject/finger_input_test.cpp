// SPDX-License-Identifier: MIT
// A finger with any input: the ends of each range, NaN, jumps, random steps, random bits.
#include "godobject/finger/sample.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test {
namespace {

/// With the default guard against jumps.
SoftFinger guarded_finger() {
  FingerParameters with = parameters();
  with.max_speed = FingerParameters{}.max_speed;
  return hertz_finger(with);
}

TEST(SoftFinger, TakesLimitsNotQuotients) {
  struct Case {
    const char* name;
    double mu, radius, depth, x, twist;
    double force, moment;
  };
  const double m0 = hertz()->moment_ratio();
  const Case cases[] = {
      {"no friction", 0.0, 0.005, 0.002, 0.001, 0.3, 0.0, 0.0},
      {"no sliding", 0.6, 0.005, 0.002, 0.0, 3.0, 0.0, 1.2 * 0.005 * m0},
      {"no twist", 0.6, 0.005, 0.002, 0.01, 0.0, 1.2, 0.0},
      {"hardly a load", 0.6, 0.005, 1e-300, 0.01, 3.0, 0.0, 0.0},
      {"the least load", 0.6, 0.005, 5e-324, 0.01, 3.0, 0.0, 0.0},
      {"a hair of sliding", 0.6, 0.005, 0.002, 1e-300, 3.0, 0.0, 1.2 * 0.005 * m0},
      {"a hair of twist", 0.6, 0.005, 0.002, 0.01, 1e-300, 1.2, 0.0},
      {"at rest", 0.6, 0.005, 0.002, 0.0, 0.0, 0.0, 0.0},
  };
  for (const Case& test : cases) {
    for_each_curve_and_projection(hertz(), [&](const FingerCurve& curve, Projection projection) {
      SoftFinger finger(curve, parameters(test.mu, test.radius), projection);
      finger.update(on_plane(0.0, 0.0, test.depth), 0.0);
      const FingerOutput output = finger.update(on_plane(test.x, 0.0, test.depth), test.twist);
      EXPECT_NEAR(output.force.norm(), test.force, 1e-12) << test.name;
      EXPECT_NEAR(std::fabs(output.moment), test.moment, 1e-14) << test.name;
      EXPECT_TRUE(output.proxy.allFinite() && std::isfinite(output.angle)) << test.name;
    });
  }
}

// A limit below 1e-125 N is below all rounding and counts as 1e-125 N.
TEST(SoftFinger, FeelsNextToNothingWhereFrictionVanishes) {
  FingerParameters with = parameters();
  // What such a trial deflects this spring by is more than some limits.
  with.stiffness = 1e15;
  for (const double depth : {1e-313, 1e-160, 1e-142}) {
    for_each_curve(hertz(), [&](const FingerCurve& curve) {
      SoftFinger finger(curve, with);
      finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
      const FingerOutput output = finger.update(on_plane(3e-163, 1e-165, depth), 1e-200);
      EXPECT_LE(output.force.norm(), 1e-124) << depth;
      EXPECT_LE(std::fabs(output.moment), 1e-124) << depth;
    });
  }
}

// Each kind of bad input is named, the next good sample has none; a pose is refused for its own reason, not for that of
// the contact.
TEST(SoftFinger, NamesTheReasonOfAFault) {
  auto finger = guarded_finger();
  const auto expect = [&](const FingerOutput& output, Fault fault) {
    EXPECT_EQ(to_string(output.fault), to_string(fault));
    EXPECT_EQ(output.state == ContactState::invalid, fault != Fault::none);
  };
  const auto on_good = [&] { expect(finger.update(on_plane(0.0, 0.0, 0.002), 0.0, 1e-3), Fault::none); };
  const auto on_contact = [&](const Contact& contact, double twist, double time_step, Fault fault) {
    expect(finger.update(contact, twist, time_step), fault);
    on_good();
  };
  on_good();
  for (const double none : {nan, infinity, -infinity}) {
    on_contact(on_plane(none, 0.0, 0.002), 0.0, 1e-3, Fault::not_finite);
    on_contact(on_plane(0.0, 0.0, none), 0.0, 1e-3, Fault::not_finite);
    on_contact(on_plane(0.0, 0.0, 0.002), none, 1e-3, Fault::not_finite);
    on_contact({Vector3d::Zero(), {0.0, none, 1.0}, 0.002}, 0.0, 1e-3, Fault::not_finite);
    on_contact(on_plane(0.0, 0.0, 0.002), 0.0, none, Fault::time_step);
  }
  on_contact(on_plane(1e300, 0.0, 0.002), 0.0, 1e-3, Fault::too_far);
  on_contact(on_plane(0.0, 0.0, 0.002), -2e6, 1e-3, Fault::too_far);
  on_contact({Vector3d::Zero(), {0.0, 0.0, 1.011}, 0.002}, 0.0, 1e-3, Fault::normal);
  on_contact({Vector3d::Zero(), Vector3d::Zero(), 0.002}, 0.0, 1e-3, Fault::normal);
  for (const double back : {-1e-9, -5e-324}) on_contact(on_plane(0.0, 0.0, 0.002), 0.0, back, Fault::time_step);
  on_contact(on_plane(0.6, 0.0, 0.002), 0.0, 1e-3, Fault::speed);
  const AnySurface plane(PlaneSurface{});
  const auto on_pose = [&](const DevicePose& device, Fault fault) {
    expect(finger.preview(plane, device, 1e-3), fault);
    expect(finger.update(plane, device, 1e-3), fault);
    on_good();
  };
  on_pose({{0.0, 0.0, -0.002}}, Fault::none);
  on_pose({{nan, 0.0, -0.002}}, Fault::not_finite);
  on_pose({{0.0, 0.0, -0.002}, Orientation(nan, 0.0, 0.0, 0.0)}, Fault::not_finite);
  on_pose({{0.0, 0.0, -0.002}, Orientation::Identity(), nan}, Fault::not_finite);
  on_pose({{2e6, 0.0, -0.002}}, Fault::too_far);
  on_pose({{0.0, 0.0, -0.002}, Orientation(1.1, 0.0, 0.0, 0.0)}, Fault::orientation);
  on_pose({{0.6, 0.0, -0.002}}, Fault::speed);
  expect(finger.mark_invalid(Fault::body), Fault::body);
}

// A direction within 1e-2 of unit length is the normalised one at every door, within 1e-6 with its own bits; beyond
// 1e-2 it is a fault.
TEST(SoftFinger, TakesDirectionsOfNearlyUnitLength) {
  const Vector3d normal = Vector3d(0.1, -0.2, 1.0).normalized();
  const Orientation turn(AngleAxisd(0.3, Vector3d(0.6, 0.0, 0.8)));
  const AnySurface plane(PlaneSurface{});
  for (const double length : {0.0, 0.98, 0.9901, 0.9995, 1.0 - 9e-7, 1.0 + 9e-7, 1.0001, 1.0099, 1.02, 1e3}) {
    const bool is_bad = std::fabs(length - 1.0) > 1e-2;
    const bool is_kept = std::fabs(length - 1.0) < 1e-6;
    const Vector3d long_normal = length * normal;
    const Orientation long_turn(length * turn.w(), length * turn.x(), length * turn.y(), length * turn.z());
    SoftFinger finger = hertz_finger();
    SoftFinger other = hertz_finger();
    for (const double x : {0.0, 1e-3}) {
      const Contact exact{{x, 0.0, 0.0}, normal, 0.002};
      const Contact near{{x, 0.0, 0.0}, long_normal, 0.002};
      const auto expect = [&](const FingerOutput& output, const FingerOutput& expected, Fault fault) {
        ASSERT_EQ(to_string(output.fault), to_string(is_bad ? fault : Fault::none)) << length;
        EXPECT_TRUE(is_bad || (output.whole_force() - expected.whole_force()).norm() <= 4e-6) << length;
        EXPECT_TRUE(is_bad || std::fabs(output.moment - expected.moment) <= 1e-9) << length;
      };
      const FingerOutput found = finger.update(near, 0.1);
      expect(found, other.update(exact, 0.1), Fault::normal);
      EXPECT_TRUE(is_bad || (is_kept ? found.normal == long_normal : (found.normal - normal).norm() < 1e-15)) << length;
      expect(finger.update(exact, long_turn), other.update(exact, turn), Fault::orientation);
      expect(finger.update(plane, {{x, 0.0, -0.002}, long_turn}), other.update(plane, {{x, 0.0, -0.002}, turn}),
             Fault::orientation);
      const BodyPose body{{0.1, 0.2, 0.3}, long_turn};
      expect(finger.update(to_body(body, near), to_body(body, long_turn)),
             other.update(to_body({body.position, turn}, exact), to_body({body.position, turn}, turn)),
             Fault::not_finite);
      const FingerOutput seen = to_world(body, finger.output());
      EXPECT_NEAR(seen.whole_force().norm(), is_bad ? 0.0 : finger.output().whole_force().norm(), 4e-6) << length;
      EXPECT_TRUE(!is_bad || seen.fault == Fault::body) << length;
      EXPECT_EQ(to_world({{std::nan(""), 0.0, 0.0}, turn}, finger.output()).whole_force().norm(), 0.0);
    }
  }
}

// One bad sample does not change the force; a device that stops sending positions must not keep its force forever.
TEST(SoftFinger, HoldsOnceThenLetsGoSoftly) {
  FingerParameters with = parameters();
  with.fault_decay = 0.5;
  auto finger = hertz_finger(with);
  finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
  finger.update(on_plane(0.0004, 0.0, 0.002), 0.01);
  const FingerOutput good = finger.output();
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    finger.update(on_plane(nan, 0.0, 0.002), 0.0);
    EXPECT_EQ(finger.output().force, Vector3d(good.force * share));
    EXPECT_EQ(finger.output().load, good.load * share);
    EXPECT_EQ(finger.output().moment, good.moment * share);
  }
  finger.update(on_plane(0.0004, 0.0, 0.002), 0.01);
  EXPECT_EQ(finger.output().force, good.force);
  EXPECT_EQ(finger.output().proxy, good.proxy);
}

// A jump is a speed since the last good sample, whatever the steps; less than a millisecond counts as one.
TEST(SoftFinger, MeasuresAJumpByTheTimeSinceTheLastGoodSample) {
  const double far = 0.0499;  // in 10 ms at 5 m/s
  auto finger = guarded_finger();
  const auto faults = [&](double x, double time_step, bool landed = false) {
    return finger.update({{x, 0.0, 0.0}, Vector3d::UnitZ(), 0.002, {}, landed}, 0.0, time_step).fault;
  };
  for (const int steps : {1, 4, 20}) {
    for (const double x : {far, 0.0501}) {
      faults(0.0, 1.0);
      const double step = 0.01 / (2 * steps - 1);  // two bad ones each time, and the good one
      for (int i = 1; i < steps; ++i) {
        faults(nan, step);
        finger.mark_invalid(Fault::body, step);
      }
      EXPECT_EQ(faults(x, step), x == far ? Fault::none : Fault::speed) << x << ' ' << steps;
    }
  }
  for (const double time_step : {0.0, 1e-6, 1e-3}) {
    faults(0.0, 1.0);
    EXPECT_EQ(faults(0.0049, time_step), Fault::none);
    EXPECT_EQ(faults(0.0101, time_step), Fault::speed);
    EXPECT_EQ(faults(0.2, time_step), Fault::speed) << "not where it was refused";
    EXPECT_EQ(faults(0.2049, time_step), Fault::none) << "it stays there";
    EXPECT_EQ(faults(0.9, time_step, true), Fault::none) << "landed anew";
    finger.reset();
    EXPECT_EQ(faults(0.1, time_step), Fault::none);
  }
}

// Not in one step, but by many small ones.
TEST(SoftFinger, RefusesWhatIsBeyondTheFarthest) {
  SoftFinger finger = hertz_finger();
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x = farthest - 20.0 + 0.04 * i;
    const Contact contact = on_plane(x, 0.0, 0.002);
    const bool is_far = x * x + contact.depth * contact.depth > farthest * farthest;
    EXPECT_EQ(finger.update(contact, 0.0).state == ContactState::invalid, is_far) << x;
    refused += is_far;
  }
  EXPECT_GT(refused, 400);
}

// A normal may be off its length by half a millionth, and the proxy off the tangent plane by what the normal turned:
// the limit holds for what is felt, whichever way the length of the pull was found.
TEST(SoftFinger, StaysWithinTheCurveUnderNormalsOfNearlyUnitLength) {
  const double m0 = hertz()->moment_ratio();
  const Ellipse ellipse = Ellipse::through_intercepts(m0);
  const FingerParameters with{.mu = 0.6,
                              .radius_law = RadiusLaw::constant(0.005),
                              .stiffness = 1000.0,
                              .twist_stiffness = 0.036,
                              .max_speed = infinity};
  for (const double length : {1.0 - 4e-7, 1.0, 1.0 + 4e-7}) {
    for (const double tilt : {0.0, 1e-3, 0.1, 0.24, 0.26, 1.0}) {
      SoftFinger finger(ellipse, with, Projection::radial);
      finger.update({{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.002}, 0.0);
      const Vector3d normal = length * Vector3d(std::sin(tilt), 0.0, std::cos(tilt));
      const FingerOutput output = finger.update({{0.01, 0.003, 0.0}, normal, 0.002}, 0.2);
      ASSERT_EQ(output.state, ContactState::slip);
      EXPECT_NEAR(ellipse.gauge(unit_wrench(finger.state(), with.mu, 0.005)), 1.0,
                  4.0 * std::numeric_limits<double>::epsilon())
          << "length " << length << " tilt " << tilt;
    }
  }
}

TEST(FingerParameters, ABoxGoesWithTheClosestPointOnly) {
  const Box limits = box(1.0, 0.6);
  EXPECT_NO_THROW(SoftFinger(limits, parameters(), Projection::closest_point));
  for (const Projection projection : {Projection::radial, Projection::c_curve}) {
    expect_mention(complaint([&] { SoftFinger(limits, parameters(), projection); }),
                   "a box goes with closest-point only");
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
