// SPDX-License-Identifier: MIT
// What a host with collisions of its own needs: orientations, a body that moves, materials of the touched object.
#include "godobject/surfaces/surfaces.hpp"
#include "tests/godobject/random_scene.hpp"

namespace limitcurve::godobject::test {
namespace {

TEST(Host, AContactWithAnOrientationIsThePoseOnTheSurface) {
  const AnySurface ball{Ball{0.03}};
  FingerParameters with = parameters();
  with.damping = 1.0;
  auto of_pose = exact_hertz_finger(with);
  auto of_contact = exact_hertz_finger(with);
  std::array<int, 4> seen{};
  for (int i = 0; i < 2000; ++i) {
    const double angle = 2e-3 * i + 0.3 * std::sin(0.05 * i);
    const Vector3d outward(std::sin(angle), 0.3, std::cos(angle));
    DevicePose device{outward.normalized() * (0.029 + 0.0015 * std::sin(0.01 * i)),
                      Orientation(AngleAxisd(0.01 * i, Vector3d(0.6, 0.0, 0.8)) *
                                  AngleAxisd(0.2 * std::sin(0.1 * i), Vector3d::UnitY()))};
    if (i % 100 == 99) device.orientation.w() = i % 200 == 99 ? nan : 3.0;
    const Contact contact = ball.contact(device.position, of_contact.state().contact);
    expect_same(of_pose.preview(ball, device, 1e-3), of_contact.preview(contact, device.orientation, 1e-3));
    const FingerOutput expected = of_pose.update(ball, device, 1e-3);
    expect_same(expected, of_contact.update(contact, device.orientation, 1e-3));
    ++seen[static_cast<std::size_t>(expected.state)];
    ASSERT_FALSE(testing::Test::HasFailure()) << "step " << i;
  }
  for (const int times : seen) EXPECT_GE(times, 20);
}

/// A finger slides and turns on a ball that tumbles through the world. Pose, position and contact in the world are made
/// by matrices.
TEST(Host, ABodyThatMovesIsFeltAsTheSameMotionSeenFromIt) {
  auto seen_from_body = exact_hertz_finger();
  auto in_world = exact_hertz_finger();
  const AnySurface ball{Ball{0.03}};
  Random random(71);
  std::array<int, 4> seen{};
  for (int i = 0; i < 3000; ++i) {
    const double angle = 0.4 * std::sin(0.02 * i);
    const Vector3d position = Vector3d(std::sin(angle), 0.1 * std::cos(0.013 * i), std::cos(angle)) * 0.0285;
    const Orientation orientation(AngleAxisd(0.3 * std::sin(0.017 * i), Vector3d(0.0, 0.6, 0.8)));
    const Contact contact = ball.contact(position, {});
    const Eigen::Matrix3d turn =
        (AngleAxisd(0.004 * i, Vector3d(0.48, 0.6, 0.64)) * AngleAxisd(0.7, Vector3d::UnitX())).matrix();
    const BodyPose body{Vector3d(0.2 * std::sin(0.003 * i), -1e-4 * i, 0.1), Orientation(turn)};
    const auto to_world_by_matrix = [&](const Vector3d& point) { return Vector3d(turn * point + body.position); };
    const Contact found{to_world_by_matrix(contact.point), turn * contact.normal, contact.depth};
    const Orientation held(Eigen::Matrix3d(turn * orientation.matrix()));

    const FingerOutput expected = seen_from_body.update(contact, orientation, 1e-3);
    const FingerOutput output = to_world(body, in_world.update(to_body(body, found), to_body(body, held), 1e-3));
    ASSERT_EQ(output.state, expected.state) << i;
    ++seen[static_cast<std::size_t>(output.state)];
    EXPECT_LT((output.proxy - to_world_by_matrix(expected.proxy)).norm(), 1e-12);
    EXPECT_LT((output.whole_force() - turn * expected.whole_force()).norm(), 1e-12 * expected.load);
    EXPECT_LT((output.moment_vector() - turn * expected.moment_vector()).norm(), 1e-12 * expected.load * 0.005);
    EXPECT_LT((to_body(body, DevicePose{to_world_by_matrix(position), held, 0.1}).position - position).norm(), 1e-15);
  }
  EXPECT_GT(seen[1], 100);
  EXPECT_GT(seen[2], 100);
}

TEST(Host, OtherParametersLeaveProxyAndOutput) {
  for_each_curve_and_projection(hertz(), [&](const FingerCurve& curve, Projection projection) {
    SoftFinger finger(curve, parameters(), projection);
    finger.update(on_plane(0, 0, 0.002), 0.0);
    finger.update(on_plane(6e-4, 0, 0.002), 0.02, 1e-3);
    ASSERT_EQ(finger.output().state, ContactState::stick);
    const FingerState before = finger.state();
    SoftFinger other = finger;
    // The same ones: every number of this step and of the next ones.
    ASSERT_TRUE(other.change(finger.parameters()));
    for (int i = 0; i < 50; ++i) {
      expect_same(finger.output(), other.output());
      finger.update(on_plane(6e-4 + 2e-5 * i, 1e-5 * i, 0.002), 0.02 + 0.003 * i, 1e-3);
      other.update(on_plane(6e-4 + 2e-5 * i, 1e-5 * i, 0.002), 0.02 + 0.003 * i, 1e-3);
    }
    // Springs thrice as stiff: load and force of the next step are thrice as large, and so is the energy at once.
    finger.restore(before);
    const double energy = finger.spring_energy();
    FingerParameters stiffer = parameters(0.6, 0.005, 3000.0, 0.12);
    ASSERT_TRUE(finger.change(stiffer));
    expect_same(finger.output(), before.output);
    EXPECT_NEAR(finger.spring_energy(), 3.0 * energy, 1e-15 * energy);
    FingerOutput next = finger.update(on_plane(6e-4, 0, 0.002), 0.02, 1e-3);
    EXPECT_EQ(next.state, ContactState::stick);
    EXPECT_TRUE(same_bits(next.proxy, before.output.proxy));
    EXPECT_NEAR(next.load, 3.0 * before.output.load, 1e-14);
    EXPECT_NEAR(next.force.x(), 3.0 * before.output.force.x(), 1e-14);
    EXPECT_NEAR(next.moment, 3.0 * before.output.moment, 1e-16);
    // Less friction: the margin is gone at once, and the next step slips to the smaller limit. A pure slide, so that it
    // is μP.
    finger.reset();
    ASSERT_TRUE(finger.change(parameters()));
    finger.update(on_plane(0, 0, 0.002), 0.0);
    finger.update(on_plane(6e-4, 0, 0.002), 0.0);
    EXPECT_NEAR(finger.margin(), 0.5, 1e-9);
    EXPECT_NEAR(finger.load_to_hold(), 1.0, 1e-9);
    ASSERT_TRUE(finger.change(parameters(0.2)));
    EXPECT_EQ(finger.margin(), 0.0);
    EXPECT_NEAR(finger.load_to_hold(), 3.0, 1e-9);
    next = finger.update(on_plane(6e-4, 0, 0.002), 0.0);
    EXPECT_EQ(next.state, ContactState::slip);
    EXPECT_NEAR(next.force.x(), -0.4, 1e-9);
    EXPECT_NEAR(next.slip_work, 0.4 * 2e-4, 1e-9);
  });
}

/// What other engines allow: a coefficient of slip above that of rest, and no stiffness.
TEST(Host, BadParametersChangeNothing) {
  auto finger = hertz_finger();
  finger.update(on_plane(0, 0, 0.002), 0.0);
  const auto refuses = [&](auto edit, std::string_view name) {
    FingerParameters bad = parameters(0.3);
    edit(bad);
    EXPECT_FALSE(finger.change(bad)) << name;
    EXPECT_EQ(finger.refusal(bad)->name, name);
    EXPECT_EQ(finger.parameters().mu, 0.6);
    EXPECT_THROW(SoftFinger(*finger.curve(), bad), std::invalid_argument) << name;
  };
  refuses([](FingerParameters& bad) { bad.mu_dynamic = 0.7; }, "mu_dynamic");
  refuses([](FingerParameters& bad) { bad.stiffness = 0.0; }, "stiffness");
  refuses([](FingerParameters& bad) { bad.twist_stiffness = 0.0; }, "twist_stiffness");
  for (const double number : {-1.0, nan, infinity}) {
    refuses([&](FingerParameters& bad) { bad.mu = number; }, "mu");
    refuses([&](FingerParameters& bad) { bad.mu_dynamic = number; }, "mu_dynamic");
    refuses([&](FingerParameters& bad) { bad.mu_r = number; }, "mu_r");
    refuses([&](FingerParameters& bad) { bad.mu_r = 0.004, bad.gamma = 2.1 + number; }, "gamma");
    refuses([&](FingerParameters& bad) { bad.stiffness = number; }, "stiffness");
    refuses([&](FingerParameters& bad) { bad.twist_stiffness = number; }, "twist_stiffness");
  }
  refuses([](FingerParameters& bad) { bad.gamma = 0.1; }, "gamma");
  refuses([](FingerParameters& bad) { bad.mu_r_dynamic = 0.1; }, "mu_r_dynamic");
  refuses([](FingerParameters& bad) { bad.mu = 0.0, bad.mu_r = 1e-3; }, "mu_r");
  refuses([](FingerParameters& bad) { bad.mu_r = 1e-3, bad.mu_r_dynamic = 2e-3; }, "mu_r_dynamic");
  // So little friction that slip has none at all: the moment has no radius.
  refuses([](FingerParameters& bad) { bad.mu = 1e-310, bad.mu_dynamic = 0.0, bad.mu_r = bad.mu_r_dynamic = 1e-3; },
          "mu_r_dynamic");
  FingerParameters good = parameters(0.3);
  good.mu_r = 1e-3;
  EXPECT_FALSE(finger.refusal(good));
  EXPECT_TRUE(finger.change(good));
  EXPECT_EQ(finger.parameters().mu, 0.3);
}

Vector3d rounded(const Vector3d& vector, double unit) {
  return (vector / unit).array().round() * unit;
}

// What hosts send, all at once: float poses that nobody normalises, normals of four decimals, encoders of 10 um, uneven
// and repeated time steps, contacts lost and found without steps in the air, other bodies and materials, and a fault
// now and then. A sample is invalid where there is a fault and nowhere else, the limit holds, and no step stores or
// dissipates more than the held force was worth, plus what a sampled spring adds.
TEST(Host, TheWorldAsItIs) {
  std::array<int, 4> seen{};
  for_each_choice(64, [&](const Choice& choice, Random& random) {
    FingerParameters with = choice.parameters.finger;
    with.max_speed = FingerParameters{}.max_speed;
    SoftFinger finger(make_finger_curve(choice.curve.kind, hertz(), 1e-6), with, choice.curve.projection);
    const AnySurface& surface = choice.surface.surface;
    RandomDevice device(surface, random);
    BodyPose body;
    Eigen::Quaternionf wrist(random_orientation(random).cast<float>());
    double time = 0.0;
    double taken = -1.0;  // energy of the springs after the last good sample; < 0: none
    FingerOutput last;
    FingerSample before;
    for (int i = 0; i < repetitions(2000, 200); ++i) {
      const std::size_t chance = random.below(400);
      double step = chance < 20 ? 0.0 : chance == 20 ? 0.01 : random.uniform(2e-4, 1.8e-3);
      time += step;
      if (chance == 21 || random.below(300) == 0) {  // another body, or another place after a while
        finger.reset();
        taken = -1.0;
        device = RandomDevice(surface, random);
        wrist = random_orientation(random).cast<float>();
        time = 0.0;
        body = {random.vector(0.3), random_orientation(random)};
        body.orientation.coeffs() = (body.orientation.coeffs() * 1e4).array().round() / 1e4;
      }
      body.position += random.vector(1e-5);
      wrist = Eigen::Quaternionf(Eigen::AngleAxisf(0.02F, Eigen::Vector3f::UnitX())) * wrist;
      const DevicePose hand = device.at(0.2 + time);  // it does not rest
      Contact contact = surface.contact(rounded(hand.position, 1e-5), finger.state().contact);
      const ContactMemory memory = contact.memory;
      contact.point = body.to_world(contact.point).cast<float>().cast<double>();
      contact.normal = rounded(body.out_of_body() * contact.normal, 1e-4);
      Orientation orientation = wrist.cast<double>();
      Fault fault = Fault::none;
      const auto is_fault = [&](std::size_t kind, Fault name) {
        if (chance == kind) fault = name;
        return chance == kind;
      };
      if (is_fault(22, Fault::not_finite)) contact.depth = nan;
      if (is_fault(23, Fault::speed)) contact.point.x() += 0.6;
      if (is_fault(24, Fault::normal)) contact.normal *= 0.5;  // none at all is no fault in the air
      if (is_fault(25, Fault::orientation)) orientation = Orientation(2.0, 0.0, 0.0, 0.0);
      if (is_fault(26, Fault::time_step)) step = -1e-3;
      const FingerFaults& faults = finger.state().faults;
      if (fault == Fault::speed && (!faults.seen || faults.refused)) continue;  // a refused place that is held counts
      FingerParameters other = with;
      other.mu *= random.uniform(1.0, 1.5);
      ASSERT_TRUE(random.below(50) != 0 || finger.change(other));
      contact = to_body(body, contact);
      contact.memory = memory;
      const FingerOutput output = finger.update(contact, to_body(body, orientation), step);
      ASSERT_EQ(to_string(output.fault), to_string(fault)) << i;
      ++seen[static_cast<std::size_t>(output.state)];
      if (fault != Fault::none) continue;
      const FingerState& state = finger.state();
      ASSERT_LE(output.force.norm(), 1.5 * with.mu * state.limit_load * (1.0 + 1e-9)) << i;
      const double twist = output.angle - state.sample.angle;
      const double energy = 0.5 * with.stiffness * (output.proxy - state.sample.position()).squaredNorm() +
                            0.5 * with.twist_stiffness * twist * twist;
      const Vector3d way = state.sample.position() - before.position();
      const double turn = state.sample.angle - before.angle;
      if (taken >= 0.0 && with.damping == 0.0) {
        const double worth = -last.whole_force().dot(way) - last.moment * turn +
                             0.5 * with.stiffness * way.squaredNorm() + 0.5 * with.twist_stiffness * turn * turn;
        // A normal within 1e-6 of unit length keeps its bits; where the finger lands, it may have been in the surface
        // already by the rounding of its place to a float.
        const double inside =
            last.state == ContactState::free ? 6e-8 * with.stiffness * std::max(contact.depth, 0.0) : 0.0;
        const double rounding = 1e-12 + 4e-6 * last.whole_force().norm() * way.norm() + inside;
        ASSERT_LE(energy - taken + output.slip_work, worth + rounding) << i << ' ' << to_string(output.state);
      }
      taken = energy;
      last = output;
      before = state.sample;
    }
  });
  for (const int times : seen) EXPECT_GE(times, 100);
}

}  // namespace
}  // namespace limitcurve::godobject::test
