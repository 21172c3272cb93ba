// SPDX-License-Identifier: MIT
// A finger whose load a physics engine gives: a stick is a function of the pose, and friction reaches its limit on a
// ball of any radius.
#include "limitcurve/patch/patch.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test {
namespace {

/// The place on a ball of this radius [m] after a way along a great circle; the force there, along and across it.
struct GreatCircle {
  double radius;

  [[nodiscard]] Vector3d normal(double way) const { return {std::sin(way / radius), 0.0, std::cos(way / radius)}; }
  [[nodiscard]] Vector3d point(double way) const {
    return std::isinf(radius) ? Vector3d(way, 0.0, 0.0) : Vector3d(radius * normal(way));
  }
  [[nodiscard]] Vector3d along(double way) const { return {std::cos(way / radius), 0.0, -std::sin(way / radius)}; }
};

std::vector<SoftFinger> fingers(std::optional<double> mu_dynamic = {}) {
  FingerParameters with = parameters(0.8, 0.005, 144.0, 0.01);
  FingerParameters damped = with;
  damped.damping = 1.44;
  damped.twist_damping = 1e-4;
  damped.mu_dynamic = mu_dynamic;
  damped.radius_law = RadiusLaw::hertz(0.008, 2e5);
  return {
      hertz_finger(with), exact_hertz_finger(damped), {box(1.0, 0.5), damped}, {Patch::rectangle(0.01, 0.005), damped}};
}

// To and fro, with a twist, under loads that ease and press. On a ball a deflection counts by its sine; on a smaller
// one than 4 μP/k_l the proxy is carried along.
TEST(GivenLoad, FrictionOnABallIsNearlyThePlanes) {
  constexpr double longest = 0.8 * 3.4 / 144.0;  // μP/k_l
  for (const SoftFinger& finger : fingers()) {
    for (const auto& [radius, within] :
         {std::pair{0.05 * longest, 0.3}, {0.2 * longest, 0.3}, {4.0 * longest, 0.04}, {1e3, 2e-4}}) {
      const GreatCircle ball{radius};
      const GreatCircle plane{infinity};
      SoftFinger round = finger;
      SoftFinger flat = finger;
      int slips = 0;
      int sticks = 0;
      for (int i = 0; i < 4000; ++i) {
        const double way = 0.02 * std::sin(0.0015 * i);
        const double load = 1.9 + 1.5 * std::sin(0.007 * i);
        const double twist = 0.3 * std::sin(0.002 * i);
        const FingerOutput out = round.update_under_load(ball.point(way), ball.normal(way), load, twist, 1e-3);
        const FingerOutput expected = flat.update_under_load(plane.point(way), plane.normal(way), load, twist, 1e-3);
        const double unit = 0.8 * load;
        ASSERT_EQ(out.load, load);
        ASSERT_TRUE(std::isnan(out.depth));
        ASSERT_NEAR(out.force.dot(ball.along(way)), expected.force.x(), within * unit) << radius << ' ' << i;
        ASSERT_NEAR(out.force.y(), expected.force.y(), within * unit) << radius << ' ' << i;
        ASSERT_NEAR(out.force.dot(out.normal), 0.0, 1e-14) << radius << ' ' << i;
        ASSERT_NEAR(out.moment, expected.moment, within * unit * 0.005) << radius << ' ' << i;
        ASSERT_GE(out.slip_work, 0.0);
        ASSERT_NEAR(round.spring_energy(), flat.spring_energy(), 2.5 * within * unit * unit / 144.0)
            << radius << ' ' << i;
        slips += out.state == ContactState::slip;
        sticks += out.state == ContactState::stick;
      }
      EXPECT_GT(slips, 500);
      EXPECT_GT(sticks, 500);
    }
  }
}

// Loops of point and normal within a cone of 0.25 rad leave a stick's force, to the bit, and it is that of `update`.
TEST(GivenLoad, AStickDoesNotKnowItsPath) {
  Random random(6);
  for (int loop = 0; loop < 200; ++loop) {
    SoftFinger loaded = hertz_finger(parameters(100.0));
    SoftFinger deep = loaded;
    const Vector3d middle = random.vector(1.0).normalized();
    const auto pose = [&] {  // two of them are by less than 0.25 rad apart
      const Contact at{random.vector(1e-3), (middle + random.vector(0.07)).normalized(), 0.0};
      return Contact{at.point, at.normal, 0.005};
    };
    const auto go = [&](const Contact& to) {
      const FingerOutput out = loaded.update_under_load(to.point, to.normal, 5.0, 0.0);
      EXPECT_TRUE(same_bits(out.force, deep.update(to, 0.0).force)) << loop;
      EXPECT_EQ(out.state, ContactState::stick);
      return out.force;
    };
    go(pose());
    const Contact begin = pose();
    const Vector3d force = go(begin);
    EXPECT_GT(force.norm(), 0.0);
    for (int i = 0; i < 100; ++i) go(pose());
    EXPECT_TRUE(same_bits(go(begin), force)) << loop;
  }
}

// To the limit, and nearly to the opposite one and back, again and again: from a radius of 4 μP/k_l on a stick stays
// one, and keeps its force. On a smaller ball the proxy is carried along, so that a slip begins before the force is
// what it was.
TEST(GivenLoad, ABallIsAFunctionOfThePoseFromARadius) {
  for (const double radius : {1.0, 3.7, 4.0, 8.0}) {  // in units of μP/k_l
    SoftFinger finger = hertz_finger(parameters(0.8, 0.005, 144.0, 0.01));
    constexpr double longest = 0.8 * 2.0 / 144.0;
    const GreatCircle ball{radius * longest};
    const auto at = [&](double way) { return finger.update_under_load(ball.point(way), ball.normal(way), 2.0, 0.0); };
    for (int i = 0; i <= 3000; ++i) at(1e-3 * i * longest);
    const double back = 2.99 * longest;
    const Vector3d force = at(back).force;
    const double between = 2.0 * std::atan(1.0 / radius) * ball.radius - 0.03 * longest;
    int slips = 0;
    for (int i = 0; i <= 2000; ++i)
      slips += at(back - 0.5 * between * (1.0 - std::cos(0.002 * std::numbers::pi * i))).state == ContactState::slip;
    EXPECT_EQ(slips == 0, radius >= 4.0) << radius;
    EXPECT_EQ(same_bits(at(back).force, force), radius >= 4.0) << radius;
  }
}

// Beyond the cone a circle of the normal turns the deflection of a finger at rest, by what soft_finger.hpp says.
TEST(GivenLoad, AWiderConeCreepsAsIsSaid) {
  for (const auto& [tilt, said] : {std::pair{0.25, 0.0}, {0.3, 0.09}, {0.5, 0.6}}) {
    SoftFinger finger = hertz_finger(parameters(100.0));
    const Vector3d point(3e-4, 0.0, 0.0);
    finger.update_under_load(Vector3d::Zero(), Vector3d::UnitZ(), 1.0, 0.0);
    Vector3d last = Vector3d::Zero();
    for (int i = 0; i <= 20 * 400; ++i) {
      const AngleAxisd round(2.0 * std::numbers::pi * i / 400.0, Vector3d::UnitZ());
      finger.update_under_load(point, round * Vector3d(std::sin(tilt), 0.0, std::cos(tilt)), 1.0, 0.0);
      if (i % 400 != 0) continue;
      const Vector3d deflection = finger.output().proxy - point;
      const double turn = std::atan2(last.cross(deflection).norm(), last.dot(deflection));
      EXPECT_TRUE(i < 4000 || std::fabs(turn - 0.95 * said) <= 0.05 * said + 1e-15) << tilt << ' ' << i << ' ' << turn;
      EXPECT_NEAR(deflection.norm(), 3e-4, 1e-12);
      last = deflection;
    }
  }
}

// Whatever contacts a host gives one after the other, the held force gains at most ½ k_l |Δx|² in a sample, as every
// sampled spring (passivity.hpp). A load that the depth gives is at most k_l d (1 + μ), which friction holds.
TEST(GivenLoad, NoTiltWinsEnergyNorDoesADepth) {
  Random random(7);
  for (int run = 0; run < 600; ++run) {
    const bool by_depth = run % 2 == 0;
    const double mu = random.logarithmic(0.01, by_depth ? 3.0 : 100.0);
    SoftFinger finger = hertz_finger(parameters(mu));
    const double size = random.logarithmic(1e-6, by_depth ? 1e-2 : 1e-3);
    const double tilt = random.logarithmic(1e-4, 3.0);
    Vector3d at = Vector3d::Zero();
    FingerOutput held;
    for (int i = 0; i < 300; ++i) {
      Vector3d way = random.vector(size);
      if (!by_depth) way -= held.normal * held.normal.dot(way);
      const double before = finger.spring_energy();
      at += way;
      const Vector3d normal = (held.normal + random.vector(tilt)).normalized();
      const double depth = random.logarithmic(1e-6, 5e-3);
      const FingerOutput out = by_depth ? finger.update({at + normal * depth, normal, depth}, 0.0)
                                        : finger.update_under_load(at, normal, 1000.0 * depth, 0.0);
      const double after = finger.spring_energy();
      EXPECT_LE(out.load, 1000.0 * depth * (1.0 + (by_depth ? mu : 0.0)) * (1.0 + 1e-9)) << run;
      const double won = (by_depth ? held.whole_force() : held.force).dot(way) + after - before;
      const double allowed = 500.0 * way.squaredNorm() + 1e-12 * std::max(before, after) + (by_depth ? 1e-18 : 0.0);
      EXPECT_TRUE(i == 0 || won <= allowed) << run << ' ' << i << ' ' << won << ' ' << allowed;
      held = out;
    }
  }
}

// 3.4 N on a ball of 4 mm at 1 cm/s: where a depth of 24 mm carries the device through the middle of the ball, the
// damper pushed it on.
TEST(GivenLoad, ADamperBrakesOnABallSmallerThanTheDeflection) {
  FingerParameters with = parameters(0.8, 0.005, 144.0, 0.01);
  with.damping = 1.44;
  for (const double radius : {4e-3, 0.03, 0.1, infinity}) {
    SoftFinger finger = hertz_finger(with);
    const GreatCircle ball{radius};
    for (int i = 0; i < 20; ++i) finger.update_under_load(ball.point(1e-5 * i), ball.normal(1e-5 * i), 3.4, 0.0, 1e-3);
    EXPECT_EQ(finger.output().state, ContactState::stick);
    const auto chord = [&](double way) { return std::isinf(radius) ? way : radius * std::sin(way / radius); };
    EXPECT_NEAR(finger.output().force.dot(ball.along(1.9e-4)), -(144.0 * chord(1.9e-4) + 1440.0 * chord(1e-5)), 1e-12)
        << radius;
  }
}

// On the plane it is `update` with the depth at which springs and dampers give that load, to the bit.
TEST(GivenLoad, OnThePlaneItIsUpdate) {
  for (const SoftFinger& finger : fingers(0.5)) {
    SoftFinger deep = finger;
    SoftFinger loaded = finger;
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
      const Contact contact =
          on_plane(0.03 * std::sin(0.01 * i), 0.01 * std::sin(0.013 * i), 0.02 * std::sin(0.02 * i) + 0.01);
      const double twist = 3.0 * std::sin(0.003 * i);
      const FingerOutput expected = deep.update(contact, twist, 1e-3);
      const bool touches = expected.state != ContactState::free;
      // The least load, where a damper that lifts off takes all of it.
      const double load = touches ? std::max(deep.state().limit_load, 5e-324) : random.uniform(-1.0, 0.0);
      const FingerOutput out = loaded.update_under_load(contact.point, contact.normal, load, twist, 1e-3);
      ASSERT_EQ(out.state, expected.state) << i;
      ASSERT_TRUE(same_bits(out.force, expected.force) && out.moment == expected.moment &&
                  out.slip_work == expected.slip_work)
          << i;
      ASSERT_TRUE(!touches || (same_bits(out.proxy, expected.proxy) && out.angle == expected.angle)) << i;
      ASSERT_EQ(loaded.margin(), deep.margin());
    }
  }
}

// Its user never has more than was put in, on any path over a small ball under any loads: friction's work and the
// springs' energy.
TEST(GivenLoad, NoPathWinsEnergy) {
  Random random(4);
  for (const double mu : {0.0, 0.3, 100.0}) {
    FingerParameters with = parameters(mu, 0.005, 144.0, 0.01);
    with.damping = 0.5;
    SoftFinger finger = exact_hertz_finger(with);
    Vector3d normal = Vector3d::UnitZ();
    Vector3d step = Vector3d::Zero();
    Vector3d last = 0.004 * normal;
    double won = 0.0;
    double passed = 0.0;
    for (int i = 0; i < 20000; ++i) {
      step = 0.99 * step + random.vector(1e-4);
      normal = (normal + step).normalized();
      const Vector3d point = 0.004 * normal;
      const double before = finger.spring_energy();
      const FingerOutput out = finger.update_under_load(point, normal, random.uniform(0.01, 5.0), 0.0, 1e-3);
      if (i > 0) won += out.force.dot(point - last) + finger.spring_energy() - before;
      passed += out.force.norm() * (point - last).norm();
      EXPECT_LE(won, 1e-6 * passed + 1e-20) << mu << ' ' << i;
      last = point;
    }
    EXPECT_GT(passed, mu == 0.0 ? -1.0 : 0.001);
  }
}

TEST(GivenLoad, NoLoadIsFreeAndABadOneIsAFault) {
  SoftFinger finger = hertz_finger();
  const Vector3d up = Vector3d::UnitZ();
  const auto at = [&](double x, double load, double time_step = 1e-3) {
    return finger.update_under_load({x, 0.0, 0.0}, up, load, 0.0, time_step);
  };
  for (const double none : {0.0, -0.0, -1.0, -1e300}) {
    EXPECT_EQ(at(0.0, none).state, ContactState::free) << none;
    EXPECT_EQ(finger.output().load, 0.0);
    EXPECT_TRUE(std::isnan(finger.output().depth));
  }
  at(0.0, 2.0);
  EXPECT_EQ(at(1e-3, 2.0).force.x(), -1.0);
  for (const double bad : {nan, infinity, -infinity}) {
    at(1e-3, 2.0);
    EXPECT_EQ(at(1e-3, bad).fault, Fault::not_finite) << bad;
    EXPECT_EQ(finger.output().state, ContactState::invalid);
    EXPECT_EQ(finger.output().force.x(), -1.0) << "the last good output is held";
  }
  EXPECT_EQ(at(nan, 2.0).fault, Fault::not_finite);
  EXPECT_EQ(at(1e-3, 2.0, -1.0).fault, Fault::time_step);
  EXPECT_EQ(finger.update_under_load({1e-3, 0.0, 0.0}, 1.1 * up, 2.0, 0.0).fault, Fault::normal);
  EXPECT_EQ(finger.update_under_load({1e-3, 0.0, 0.0}, up, 2.0, Orientation(1.1, 0.0, 0.0, 0.0)).fault,
            Fault::orientation);
  EXPECT_EQ(at(1e-3, 2.0).force.x(), -1.0) << "and goes on";
  EXPECT_EQ(finger.update_under_load({1e-3, 0.0, 0.0}, up, 2.0, 0.0, 1e-3, true).force.x(), -0.0)
      << "landed: the springs are relaxed";
  // An engine without a contact has no place: whatever it passes, nothing is felt, and the last good place counts.
  FingerParameters guarded = parameters();
  guarded.max_speed = FingerParameters().max_speed;
  for (SoftFinger each : {hertz_finger(guarded), SoftFinger(Patch::rectangle(0.01, 0.005), guarded)}) {
    for (const bool by_depth : {false, true}) {
      for (const Vector3d& normal : {Vector3d(0.0, 0.0, 0.0), Vector3d(nan, 0.0, 0.0), Vector3d(0.0, 0.0, 1.0)}) {
        if (by_depth && !normal.isZero()) continue;
        each.reset();
        for (const double x : {1.0, 1.001}) each.update_under_load({x, 0.0, 0.0}, up, 2.0, 0.0, 1e-3);
        EXPECT_NEAR(each.output().force.x(), -1.0, 1e-12);
        const Contact none{Vector3d::Zero(), normal, -0.0};
        const FingerOutput out =
            by_depth ? each.update(none, 0.0, 1e-3) : each.update_under_load(none.point, normal, 0.0, 0.0, 1e-3);
        EXPECT_EQ(out.state, ContactState::free);
        EXPECT_EQ(out.force.norm() + out.load + std::fabs(out.moment), 0.0);
        EXPECT_EQ(out.proxy.x(), 1.001);
        EXPECT_EQ(each.update_under_load({1.02, 0.0, 0.0}, up, 2.0, 0.0, 1e-3).fault, Fault::speed);
        EXPECT_EQ(each.update_under_load({1.005, 0.0, 0.0}, up, 2.0, 0.0, 1e-3).state, ContactState::stick);
      }
    }
    // A depth of NaN is a fault, and a jump into the air may be the device's: what is felt is held.
    each.update_under_load({1.007, 0.0, 0.0}, up, 2.0, 0.0, 1e-3);
    for (const Contact& bad : {Contact{{1.0, 0.0, 0.0}, Vector3d::Zero(), nan}, on_plane(0.0, 0.0, -0.1)}) {
      EXPECT_EQ(each.preview(bad, 0.0, 1e-3).state, ContactState::invalid);
      EXPECT_NE(each.preview(bad, 0.0, 1e-3).force.x(), 0.0);
    }
  }
  for (const double load : {5e-324, 1e-200, 1e20, 1e300}) {
    const FingerOutput out = at(2e-3, load);
    EXPECT_TRUE(out.force.allFinite() && std::isfinite(out.moment) && out.slip_work >= 0.0) << load;
    EXPECT_TRUE(finger.margin() >= 0.0 && finger.load_to_hold() < infinity) << load;
  }
}

// From a depth to a load and back in one contact: the springs stay, and dampers, which know no velocity there, do not
// act.
TEST(GivenLoad, AFingerMayChangeBetweenBoth) {
  FingerParameters with = parameters();
  with.damping = 5.0;
  SoftFinger finger = hertz_finger(with);
  for (int i = 0; i < 3; ++i) finger.update(on_plane(5e-4, 0.0, 0.002), 0.0, 1e-3);
  finger.update(on_plane(1e-3, 0.0, 0.002), 0.0, 1e-3);
  for (int i = 0; i < 4; ++i) {
    const double x = 1e-3 + 1e-5 * i;
    const FingerOutput out = i % 2 == 0 ? finger.update_under_load({x, 0.0, 0.0}, Vector3d::UnitZ(), 2.0, 0.0, 1e-3)
                                        : finger.update(on_plane(x, 0.0, 0.002), 0.0, 1e-3);
    EXPECT_NEAR(out.force.x(), 1000.0 * (out.proxy.x() - x), 1e-12) << i;
    EXPECT_EQ(out.load, 2.0) << i;
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
