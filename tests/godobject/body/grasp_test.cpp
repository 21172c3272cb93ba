// SPDX-License-Identifier: MIT
#include "godobject/body/grasp.hpp"

#include "godobject/surfaces/surfaces.hpp"
#include "tests/godobject/scene.hpp"
#include "tests/integrators.hpp"

namespace limitcurve::godobject::test::grasp_test {
namespace {

constexpr double pi = std::numbers::pi;

Grasp make_grasp(const BodyParameters& body, const Vector3d& edges, const FingerParameters& with,
                 const FingerCurve& curve, int fingers) {
  return {body, BodyState{}, AnySurface(BoxSurface(0.5 * edges)),
          std::vector<SoftFinger>(static_cast<std::size_t>(fingers), SoftFinger(curve, with))};
}

/// Two opposite fingers on the faces ±z of a block of this thickness.
std::array<DevicePose, 2> pinch(double thickness, double depth, const Vector3d& at = Vector3d::Zero()) {
  return {DevicePose{at + Vector3d(0.0, 0.0, 0.5 * thickness - depth)},
          DevicePose{at - Vector3d(0.0, 0.0, 0.5 * thickness - depth)}};
}

/// Nothing drives the body but its own motion: what is in it and in the springs never grows, step after step.
void expect_energy_never_rises(Grasp& grasp, const std::array<DevicePose, 2>& devices, int steps, double time_step) {
  const double first = grasp.energy();
  double last = first;
  for (int i = 0; i < steps; ++i) {
    grasp.step(devices, time_step);
    const double now = grasp.energy();
    ASSERT_LE(now, last + 1e-12 * first) << "step " << i;
    last = now;
  }
}

const Vector3d edges{0.12, 0.04, 0.04};

const FingerCurve ellipse = Ellipse::through_intercepts(hertz()->moment_ratio());

// 5 mm beside the centre of mass, so that force and moment carry the weight: the proxies stay where they are in the
// block, bit for bit, and the block within 1e-12 m and rad of where it settled.
TEST(Grasp, HoldsABlockAtRest) {
  BodyParameters body = BodyParameters::block(0.1, edges);
  body.gravity = {0.0, -9.81, 0.0};
  FingerParameters with = parameters(1.67, 0.01, 1000.0, 0.0366);
  with.damping = 10.0;
  with.twist_damping = 1e-3;
  auto grasp = make_grasp(body, edges, with, Table::build(hertz(), 1e-8), 2);
  const auto devices = pinch(0.04, 0.002, {0.005, 0.0, 0.0});
  grasp.place(BodyState{}, devices);
  const std::array begin{grasp.finger(0).output(), grasp.finger(1).output()};
  for (int i = 0; i < 10'000; ++i) grasp.step(devices, 1e-3);
  const BodyState settled = grasp.body();
  for (int i = 0; i < repetitions(60'000, 1'000); ++i) {
    grasp.step(devices, 1e-3);
    ASSERT_LE((grasp.body().position - settled.position).norm(), 1e-12) << i;
    ASSERT_LE(2.0 * (grasp.body().orientation.coeffs() - settled.orientation.coeffs()).norm(), 1e-12) << i;
    for (std::size_t k = 0; k < 2; ++k) {
      const FingerOutput output = grasp.finger(k).output();
      ASSERT_TRUE(same_bits(output.proxy, begin[k].proxy) && output.angle == begin[k].angle) << i;
      ASSERT_EQ(output.state, ContactState::stick) << i;
    }
  }
}

// A body that may turn about z alone, its principal axes turned. What locks the others bears the moments about them, so
// that I_zz ω_z = M_z t: 1e-4 N m for 0.1 s. The whole inertia, inverted and cut, gave 0.312 for the explicit steps,
// and NaN without a moment.
TEST(Grasp, LockedAxesLeaveTheFreeBlockOfTheInertia) {
  BodyParameters body;
  body.mass = 0.1;
  body.inertia = {1e-5, 1e-4, 2e-4};
  body.gravity.setZero();
  body.free = {true, true, false, false, false, true};
  BodyState begin;
  begin.orientation = AngleAxisd(0.8, Vector3d(1.0, 1.0, 0.0).normalized());
  const Eigen::Matrix3d axes = begin.orientation.toRotationMatrix();
  const double inertia = (axes * body.inertia.asDiagonal() * axes.transpose())(2, 2);
  ASSERT_NEAR(1e-5 / inertia, 0.0798, 5e-5);
  const Vector3d moment(0.0, 0.0, 1e-4);
  Grasp grasp(body, begin, AnySurface(PlaneSurface{}), {});
  BodyState explicitly = begin;
  BodyState spinning = begin;
  spinning.angular_velocity.z() = 3.0;
  for (int i = 0; i < 100; ++i) {
    grasp.step({}, 1e-3, Vector3d::Zero(), moment);
    accelerate(body, explicitly, Vector3d::Zero(), moment, 1e-3);
    accelerate(body, spinning, Vector3d::Zero(), Vector3d::Zero(), 1e-3);
  }
  EXPECT_NEAR(grasp.body().angular_velocity.z(), 1e-5 / inertia, 1e-12);
  EXPECT_NEAR(explicitly.angular_velocity.z(), 1e-5 / inertia, 1e-12);
  EXPECT_NEAR(spinning.angular_velocity.z(), 3.0, 1e-12);
}

// The loads of a step count among the velocities that its equations are solved to. So a body at rest is touched at
// first without gravity as it is with 0.01 m/s² of it: in whole steps, with the momentum of the forces as they are
// rendered. The same where a moment alone turns it, and where fingers leave.
TEST(Grasp, AFirstTouchNeedsNoGravity) {
  for (const bool planar : {false, true}) {
    for (int scene = 0; scene < repetitions(300, 30); ++scene) {
      Random random(static_cast<std::uint64_t>(scene));
      BodyParameters body = BodyParameters::block(random.logarithmic(0.01, 1.0), edges);
      if (planar) body.free = {true, true, false, false, false, true};
      const std::size_t fingers = 1 + random.below(4);
      const FingerParameters with = parameters(random.logarithmic(0.1, 2.0), 0.005, random.logarithmic(1e2, 1e4));
      std::vector<DevicePose> out;
      std::vector<DevicePose> in;
      for (std::size_t i = 0; i < fingers; ++i) {
        const Vector3d way = random.vector(1.0).normalized();
        out.push_back({0.0201 * way});
        in.push_back({(0.02 - random.logarithmic(1e-9, 2e-3)) * way});
      }
      for (const double gravity : {0.0, 1e-2}) {
        body.gravity = {0.0, -gravity, 0.0};
        Grasp grasp(body, BodyState{}, AnySurface(SphereSurface(0.02)),
                    std::vector<SoftFinger>(fingers, hertz_finger(with)));
        grasp.place(BodyState{}, out);
        grasp.step(in, 1e-3);
        EXPECT_EQ(grasp.divided(), 0U) << planar << ' ' << scene << ' ' << gravity;
        Vector3d impulse = 1e-3 * body.mass * body.gravity;
        double size = impulse.norm();
        for (std::size_t i = 0; i < fingers; ++i) {
          impulse -= 1e-3 * grasp.force_on_user(i);
          size += 1e-3 * grasp.force_on_user(i).norm();
        }
        if (planar) impulse.z() = 0.0;
        EXPECT_LE((body.mass * grasp.body().velocity - impulse).norm(), 1e-12 * size)
            << planar << ' ' << scene << ' ' << gravity;
        for (int i = 0; i < 3; ++i) grasp.step(out, 1e-3, Vector3d::Zero(), {1e-3, -2e-3, 5e-4});
        EXPECT_EQ(grasp.divided(), 0U) << planar << ' ' << scene << ' ' << gravity;
      }
    }
  }
}

// Out of the grip: after the first finger came off, the second pushes a face that slides past it and turns. What a step
// adds is more than ½θ²|F||r|, and within the bound of godobject/README.md ("Energy").
TEST(Grasp, AFingerThatComesOffAddsWhatIsSaid) {
  BodyParameters body = BodyParameters::block(0.1, Vector3d::Constant(0.03));
  body.gravity.setZero();
  body.free = {true, true, false, false, false, true};
  Grasp grasp(body, BodyState{}, AnySurface(BoxSurface(Vector3d::Constant(0.015))),
              std::vector<SoftFinger>(2, hertz_finger(parameters(0.0))));
  const std::array<DevicePose, 2> devices{DevicePose{{0.0149, 0.007, 0.0}}, DevicePose{{-0.0149, 0.007, 0.0}}};
  grasp.place({}, devices);
  BodyState knocked;
  knocked.velocity = {0.05, -0.3, 0.0};
  knocked.angular_velocity.z() = 9.0;
  grasp.place(knocked, devices);
  double most = 0.0;
  double spun = 9.0;
  for (int i = 0; i < 20; ++i) {
    const double last = grasp.energy();
    const std::array before{grasp.finger(0).state().sample.goal, grasp.finger(1).state().sample.goal};
    grasp.step(devices, 0.003);
    const double turned = 0.003 * std::max(std::fabs(grasp.body().angular_velocity.z()), spun);
    spun = std::fabs(grasp.body().angular_velocity.z());
    double levers = 0.0;
    double slides = 0.0;
    for (std::size_t k = 0; k < 2; ++k) {
      const double force = grasp.force_on_user(k).norm();
      levers += force * grasp.finger(k).output().proxy.norm();
      slides += force * (grasp.finger(k).state().sample.goal - before[k]).norm();
    }
    const double turn = 0.5 * turned * turned * levers;
    if (levers > 0.0) most = std::max(most, (grasp.energy() - last) / turn);
    EXPECT_LE(grasp.energy() - last, turn + turned * slides + 1e-15) << i;
  }
  EXPECT_GT(most, 2.0) << "it shows";
}

// Springs a thousand times stiffer than the time step resolves, and a body that hits them sliding: solved, and no
// energy gained.
TEST(Grasp, SolvesSlipUnderStiffSprings) {
  Random random(8);
  for (int round = 0; round < repetitions(100, 4); ++round) {
    const double mass = random.logarithmic(1e-3, 1.0);
    const double stiffness = random.logarithmic(1.0, 2000.0) * mass / 1e-6;
    BodyParameters body = BodyParameters::block(mass, edges);
    body.gravity.setZero();
    if (round % 2 == 0) body.free = {true, true, false, false, false, true};
    FingerParameters with = parameters(0.6, 0.005, stiffness, stiffness * 4e-5);
    auto grasp = make_grasp(body, edges, with, ellipse, 2);
    const auto devices = pinch(0.04, 2.0 / stiffness, {0.01, 0.005, 0.0});
    grasp.place(BodyState{}, devices);
    BodyState start;
    start.velocity = {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.0};
    start.angular_velocity = {0.0, 0.0, random.uniform(-3.0, 3.0)};
    grasp.place(start, devices);
    SCOPED_TRACE(round);
    expect_energy_never_rises(grasp, devices, 200, 1e-3);
    EXPECT_EQ(grasp.unsolved(), 0U);
  }
}

// A damped oscillator has an answer: the ratio of successive swings of a body between two damped fingers.
TEST(Grasp, DampingIsTheOneAskedFor) {
  BodyParameters body = BodyParameters::planar_block(0.1, edges, 0.0);
  FingerParameters with = parameters(100.0, 0.01, 1000.0, 0.04);
  with.damping = 0.5;  // twice: 1 N s/m; γ = b/2m = 5/s, ω² = 2k/m − γ²
  auto grasp = make_grasp(body, edges, with, ellipse, 2);
  grasp.place(BodyState{}, pinch(0.04, 0.002));
  BodyState moved_body;
  moved_body.position.x() = 1e-4;
  grasp.place(moved_body, pinch(0.04, 0.002));
  constexpr double time_step = tests_are_short ? 1e-5 : 1e-6;
  const double omega = std::sqrt(2.0 * 1000.0 / 0.1 - 25.0);
  const int period = static_cast<int>(std::lround(2.0 * pi / omega / time_step));
  for (int i = 0; i < period; ++i) grasp.step(pinch(0.04, 0.002), time_step);
  // Implicit Euler adds ω²Δt/2 = 0.01/s, or 0.1/s.
  constexpr double decay = tests_are_short ? 5.1 : 5.01;
  EXPECT_NEAR(grasp.body().position.x() / 1e-4, std::exp(-decay * 2.0 * pi / omega), 1e-4);
}

// A body that falls leaves the device behind at any speed; the device's own jump is a fault.
TEST(Grasp, ABodyThatFallsIsNoJumpOfTheDevice) {
  FingerParameters with = parameters();
  with.max_speed = FingerParameters{}.max_speed;
  Grasp grasp = make_grasp(BodyParameters::block(0.1, edges), edges, with, ellipse, 1);
  for (int i = 0; i < 3000; ++i) {
    // Its frame may be rounded, too.
    const DevicePose device{{0.0, 0.0, i == 2500 ? 1.1 : 0.1}, {0.9998, 0.0, 0.0, 0.0}};
    grasp.step({&device, 1}, 1e-3);
    ASSERT_EQ(grasp.finger(0).output().fault, i == 2500 ? Fault::speed : Fault::none) << i;
  }
  EXPECT_LT(grasp.body().velocity.z(), -29.0);
  BodyState rounded;
  rounded.orientation = Orientation(0.707107, 0.0, 0.0, 0.707);
  grasp.place(rounded, {});
  EXPECT_NEAR(grasp.body().orientation.norm(), 1.0, 1e-15);
}

// Whatever refuses its samples, a finger's time since the last good one is the sum of the steps.
TEST(Grasp, AFaultLastsAsLongAsItsSteps) {
  BodyParameters body = BodyParameters::block(0.1, edges);
  body.gravity.setZero();
  FingerParameters with = parameters();
  with.max_speed = FingerParameters{}.max_speed;
  Grasp grasp = make_grasp(body, edges, with, ellipse, 1);
  DevicePose device{{0.0, 0.0, 0.5}};
  const FingerState& state = grasp.finger(0).state();
  const auto step = [&](double force) { grasp.step({&device, 1}, 1e-3, {force, 0.0, 0.0}); };
  step(0.0);
  device.twist = 2e6;
  for (int i = 1; i <= 200; ++i) {
    device.position.x() = 2e-3 * i;  // at 2 m/s
    step(0.0);
    EXPECT_NEAR(state.faults.elapsed, 1e-3 * i, 1e-12);
  }
  device.twist = 0.0;
  step(9e7);  // to 9e5 m/s
  EXPECT_EQ(state.output.fault, Fault::none);
  for (int i = 1; i <= 2; ++i) {
    step(9e7);
    EXPECT_EQ(state.output.fault, Fault::body);
    EXPECT_NEAR(state.faults.elapsed, 1e-3 * i, 1e-12);
  }
}

// What comes after a reset is what comes after construction, to the bit; `place` keeps the springs of fingers that
// touch.
TEST(Grasp, ResetStartsAnew) {
  const BodyParameters body = BodyParameters::planar_block(0.1, edges, 9.81);
  const Grasp first = make_grasp(body, edges, parameters(), ellipse, 2);
  const auto devices = pinch(0.04, 0.003);
  const auto episode = [&](Grasp& grasp) {
    grasp.place(BodyState{}, devices);
    for (int i = 0; i < 50; ++i) grasp.step(devices, 1e-3, {5.0, 0.0, 0.0});
    return grasp;
  };
  Grasp once = first;
  const Grasp expected = episode(once);
  ASSERT_GT(expected.dissipated(), 0.0);
  Grasp again = expected;
  again.reset();
  EXPECT_EQ(again.finger(0).output().state, ContactState::free);
  EXPECT_EQ(again.dissipated(), 0.0);
  const Grasp found = episode(again);
  EXPECT_TRUE(same_bits(found.body().position, expected.body().position) &&
              found.dissipated() == expected.dissipated());
  EXPECT_TRUE(same_bits(found.finger(0).output().proxy, expected.finger(0).output().proxy));
  Grasp placed = expected;
  placed.place(BodyState{}, devices);
  EXPECT_GT(placed.finger(0).output().force.norm(), 0.1) << "its springs are loaded";
}

// A refused step moves nothing, not by one bit, says so, and is over with the next one.
TEST(Grasp, RefusesInvalidSteps) {
  BodyParameters body = BodyParameters::block(0.1, edges);
  body.gravity = {0.0, -9.81, 0.0};
  Grasp grasp = make_grasp(body, edges, parameters(), ellipse, 2);
  const auto devices = pinch(0.04, 0.003);
  grasp.place(BodyState{}, devices);
  for (int i = 0; i < 10; ++i) grasp.step(devices, 1e-3);
  const BodyState before = grasp.body();
  Grasp undisturbed = grasp;
  undisturbed.step(devices, 1e-3);
  const auto is_refused = [&](Fault fault) {
    EXPECT_TRUE(same_bits(grasp.body().position, before.position) && same_bits(grasp.body().velocity, before.velocity));
    EXPECT_EQ(grasp.finger(0).output().state, ContactState::invalid);
    EXPECT_EQ(to_string(grasp.finger(1).output().fault), to_string(fault));
    Grasp next = grasp;
    next.step(devices, 1e-3);
    EXPECT_EQ(next.finger(0).output().state, ContactState::stick);
    EXPECT_TRUE(same_bits(next.body().position, undisturbed.body().position));
  };
  for (const double none : {nan, infinity, -infinity, -1e-3, 0.0}) {
    grasp.step(devices, none);
    is_refused(Fault::time_step);
  }
  for (const double none : {nan, infinity, 1e300, 1e30}) {
    grasp.step(devices, 1e-3, {none, 0.0, 0.0});
    is_refused(Fault::force);
    grasp.step(devices, 1e-3, Vector3d::Zero(), {0.0, none, 0.0});
    is_refused(Fault::force);
  }
  grasp.carry(before, devices, nan);
  is_refused(Fault::time_step);
  BodyState nowhere = before;
  nowhere.velocity.x() = nan;
  grasp.carry(nowhere, devices, 1e-3);
  is_refused(Fault::body);
  nowhere = before;
  nowhere.orientation.w() = 2.0;
  grasp.place(nowhere, devices);
  is_refused(Fault::body);
  EXPECT_THROW(Grasp(body, nowhere, AnySurface(PlaneSurface{}), {}), std::invalid_argument);
  // Bad devices move the body by its fingers' held forces, and it is held again. Without any it falls.
  auto bad = devices;
  bad[0].position.x() = nan;
  bad[1].orientation.x() = infinity;
  for (int i = 0; i < 5; ++i) grasp.step(bad, 1e-3);
  EXPECT_EQ(grasp.finger(0).output().state, ContactState::invalid);
  EXPECT_TRUE(grasp.body().position.allFinite());
  for (int i = 0; i < 1000; ++i) grasp.step(devices, 1e-3);
  EXPECT_EQ(grasp.finger(0).output().state, ContactState::stick);
  EXPECT_TRUE(grasp.body().position.allFinite());
  for (int i = 0; i < 10; ++i) grasp.step({}, 1e-3);
  EXPECT_LT(grasp.body().velocity.y(), -0.09);
}

}  // namespace
}  // namespace limitcurve::godobject::test::grasp_test
