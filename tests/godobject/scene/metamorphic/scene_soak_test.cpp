// SPDX-License-Identifier: MIT
// What holds in every step of a random scene: one to four fingers of random stiffness, friction and radius on a body of
// random mass that rests, is moved or is free, with every curve and projection on every surface.
#include "tests/godobject/random_scene.hpp"

#include "godobject/body/grasp.hpp"
#include "limitcurve/patch/patch.hpp"
#include "tests/fuzz/step_check.hpp"

namespace limitcurve::godobject::test::scene_soak_test {
namespace {

constexpr int steps = repetitions(500, 20);
constexpr double size = 0.03;  // of a body [m]

Quaterniond rotation(Random& random, double angle) {
  return Quaterniond(AngleAxisd(random.uniform(-angle, angle), random_direction(random)));
}

RadiusLaw any_radius(Random& random) {
  static const std::array<LoadSample, 4> measured{{{0.3, 0.002}, {1.0, 0.0026}, {3.0, 0.0034}, {9.0, 0.0031}}};
  const std::array laws{RadiusLaw::constant(random.logarithmic(1e-4, 0.05)), RadiusLaw::hertz(0.008, 2e5),
                        RadiusLaw::power(0.00207, 0.259), RadiusLaw::sampled(measured)};
  return laws[random.below(4)];
}

/// The choice's finger, of any stiffness.
SoftFinger any_finger(const Choice& choice, Random& random) {
  FingerParameters with = choice.parameters.finger;
  const double rougher = random.logarithmic(0.02, 5.0);
  with.mu *= rougher;
  if (with.mu_dynamic) *with.mu_dynamic *= rougher;
  if (!with.mu_r) with.radius_law = any_radius(random);
  const double stiffer = random.logarithmic(0.01, 100.0);
  with.stiffness *= stiffer;
  with.damping *= stiffer * random.logarithmic(0.01, 10.0);
  with.twist_stiffness = with.stiffness * random.logarithmic(1e-7, 1e-3);
  with.twist_damping = with.damping * random.logarithmic(1e-7, 1e-3);
  // Four times as rough along x as across.
  if (random.below(8) == 0 && !with.mu_r) return {Patch::rectangle(0.01, 0.01).orthotropic(1.0, 0.25), with};
  const std::array laws{hertz(), uniform(), flat_punch()};
  return {make_finger_curve(choice.curve.kind, laws[random.below(3)], 1e-8), with, choice.curve.projection};
}

BodyParameters any_body(Random& random) {
  BodyParameters body =
      BodyParameters::block(random.logarithmic(1e-3, 10.0), Vector3d::Constant(size) + 0.5 * random.vector(size));
  if (random.below(2) == 0) body.gravity.setZero();
  if (random.below(3) == 0) body.free = {true, true, false, false, false, true};
  return body;
}

/// Now and then it jumps: to another side, off, or deep into the body; and back if it is too far.
void wander(DevicePose& device, const BodyState& body, double stride, Random& random) {
  if (random.below(100) == 0 || (device.position - body.position).norm() > 2.0 * size) {
    device.position = body.to_world(random.vector(1.5 * size));
  } else {
    device.position += random.vector(stride);
  }
  device.orientation = (rotation(random, stride / size) * device.orientation).normalized();
  device.twist += random.uniform(-1.0, 1.0) * stride / size;
}

/// How far the body's momentum is from that before a step and the impulse of the forces as they are rendered, of the
/// larger of both.
double momentum_error(const Grasp& hand, const BodyState& before, double time_step) {
  const BodyParameters& body = hand.parameters();
  const BodyState& now = hand.body();
  Vector3d force = body.mass * body.gravity;
  Vector3d moment = Vector3d::Zero();
  double sizes = force.norm();
  for (std::size_t i = 0; i < hand.finger_count(); ++i) {
    const Vector3d on_body = -hand.force_on_user(i);
    force += on_body;
    moment += (now.orientation * hand.finger(i).state().sample.position()).cross(on_body) - hand.moment_on_user(i);
    sizes += on_body.norm();
  }
  Vector3d linear = body.mass * (now.velocity - before.velocity) - force * time_step;
  Vector3d angular = angular_momentum(body, now) - angular_momentum(body, before) - moment * time_step;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (!body.free[static_cast<std::size_t>(i)]) linear[i] = 0.0;
    if (!body.free[static_cast<std::size_t>(i) + 3]) angular[i] = 0.0;
  }
  const double gyration = std::sqrt(body.inertia.mean() / body.mass);
  const double whole = body.mass * (before.velocity.norm() + now.velocity.norm()) + sizes * time_step +
                       (angular_momentum(body, before).norm() + angular_momentum(body, now).norm()) / gyration;
  return whole > 0.0 ? (linear.norm() + angular.norm() / gyration) / whole : 0.0;
}

// Every step of every finger is as `check_step` says, and the momentum of a free body changes by the impulse of the
// forces as they are rendered.
TEST(SceneSoak, EveryStepHolds) {
  std::array<int, 4> states{};
  std::size_t unsolved = 0;
  std::size_t body_steps = 0;
  for_each_choice(61, [&](const Choice& choice, Random& random) {
    const std::size_t fingers = 1 + random.below(4);
    Grasp hand(any_body(random), {}, choice.surface.surface,
               std::vector<SoftFinger>(fingers, any_finger(choice, random)));
    std::vector<DevicePose> devices(fingers);
    for (DevicePose& device : devices) device = {random.vector(0.9 * size), rotation(random, 3.0), 0.0};
    BodyState body;
    hand.place(body, devices);
    const double time_step = random.logarithmic(1e-5, 1e-2);
    const double stride = random.logarithmic(1e-6, 0.2) * size;
    const bool is_free = random.below(4) == 0;
    const bool is_moved = random.below(2) == 0;
    for (int i = 0; i < steps; ++i) {
      SCOPED_TRACE("step " + std::to_string(i));
      const Grasp last = hand;
      for (DevicePose& device : devices) wander(device, hand.body(), stride, random);
      if (is_free) {
        hand.step(devices, time_step);
        ASSERT_TRUE(hand.divided() > last.divided() || momentum_error(hand, last.body(), time_step) <= 1e-11);
        ++body_steps;
      } else {
        if (is_moved) {
          body.position += random.vector(0.3 * stride);
          body.orientation = (rotation(random, stride / size) * body.orientation).normalized();
        }
        hand.carry(body, devices, time_step);
      }
      for (std::size_t k = 0; k < fingers; ++k) {
        const SoftFinger& finger = hand.finger(k);
        const FingerState& before = last.finger(k).state();
        const FingerOutput output = finger.output();
        ++states[static_cast<std::size_t>(output.state)];
        ASSERT_NE(output.state, ContactState::invalid);
        // But for the rounding of the positions that spring and damper are between.
        const double rounding = 4.0 * std::numeric_limits<double>::epsilon() *
                                (finger.parameters().stiffness + finger.parameters().damping / time_step);
        ASSERT_LE(std::fabs(output.force.dot(output.normal)),
                  1e-12 * output.force.norm() + rounding * output.proxy.norm())
            << "not tangent";
        // In a step of a body in parts a finger may come off and touch down anew.
        const bool whole = hand.divided() == last.divided() && hand.unsolved() == last.unsolved();
        const std::string_view fault = limitcurve::test::check_step(finger, whole ? before : FingerState{}).fault;
        ASSERT_TRUE(fault.empty()) << fault;
        ASSERT_TRUE(finger.margin() >= 0.0 && finger.margin() <= 1.0);
      }
      unsolved += hand.unsolved() - last.unsolved();
    }
  });
  EXPECT_LE(unsolved, 1 + body_steps / 10'000);
  EXPECT_GT(states[static_cast<std::size_t>(ContactState::slip)], 10 * steps);
  EXPECT_GT(states[static_cast<std::size_t>(ContactState::stick)], 10 * steps);
}

// Two fingers at rest press a body without gravity, which is knocked, from two sides: what the finite angle turned in a
// step may add to the energy is all that it gains (godobject/README.md, "Bodies").
TEST(SceneSoak, ABodyBetweenFingersAtRestGainsNoEnergy) {
  for_each_choice(62, [&](const Choice& choice, Random& random) {
    BodyParameters body = any_body(random);
    const bool planar = !body.free[2];
    body.gravity.setZero();
    const Vector3d half = Vector3d::Constant(0.5 * size);
    Grasp held(body, {}, AnySurface(BoxSurface(half)), std::vector<SoftFinger>(2, any_finger(choice, random)));
    const double depth = random.logarithmic(1e-3, 0.1) * size;
    // Pressed along the axis that a planar body turns about, or in the plane.
    const auto axis = static_cast<Eigen::Index>(random.below(3));
    Vector3d at = random.vector(0.3 * size);
    at[axis] = 0.0;
    const Vector3d reach = (half.x() - depth) * Vector3d::Unit(axis);
    const std::array<DevicePose, 2> pinch{DevicePose{at + reach}, DevicePose{at - reach}};
    held.place({}, pinch);
    const double time_step = random.logarithmic(1e-5, 1e-2);
    BodyState knocked;
    const double speed = random.logarithmic(1e-3, 1.0);
    knocked.velocity = random.vector(speed);
    knocked.angular_velocity = random.vector(speed / size);
    if (planar) {
      knocked.velocity.z() = 0.0;
      knocked.angular_velocity.head<2>().setZero();
    }
    if (random.below(2) == 0) {
      // The gripped point rests, and friction pulls it towards the centre of mass: what the turn of a step adds is not
      // lost elsewhere.
      const FingerParameters& with = held.finger(0).parameters();
      const Vector3d lever = planar ? Vector3d(at.x(), at.y(), 0.0) : at;
      const double stretch = random.uniform(0.0, 1.0) * std::min(with.mu, 1.0) * depth;
      const double spin =
          random.uniform(1.0, 10.0) * std::sqrt(2.0 * with.stiffness * stretch / (body.mass * lever.norm()));
      knocked.angular_velocity *= std::min(spin, 0.5 / time_step) / knocked.angular_velocity.norm();
      knocked.velocity = -knocked.angular_velocity.cross(lever);
      knocked.position = stretch * lever.normalized();
    }
    held.place(knocked, pinch);
    const double first = held.energy();
    double last = first;
    double spun = knocked.angular_velocity.norm();
    for (int i = 0; i < steps; ++i) {
      const std::array before{held.finger(0).state().sample.goal, held.finger(1).state().sample.goal};
      const auto is_off = [&](std::size_t k) { return held.finger(k).output().state == ContactState::free; };
      bool let_go = is_off(0) || is_off(1);
      held.step(pinch, time_step);
      const double turned = std::max(held.body().angular_velocity.norm(), spun) * time_step;
      spun = held.body().angular_velocity.norm();
      double levers = 0.0;
      double moments = 0.0;
      double slides = 0.0;
      for (std::size_t k = 0; k < 2; ++k) {
        const FingerOutput output = held.finger(k).output();
        ASSERT_GE(output.slip_work, 0.0);
        let_go = let_go || is_off(k);
        const double force = held.force_on_user(k).norm();
        levers += force * output.proxy.norm();
        slides += force * (held.finger(k).state().sample.goal - before[k]).norm();
        moments += std::fabs(output.moment);
      }
      const double of_grip = 0.5 * turned * turned * levers + (let_go ? turned * slides : 0.0);
      ASSERT_LE(held.energy() - last - 1e-12 * first, planar ? of_grip : turned * turned * (first + levers + moments))
          << i;
      last = held.energy();
    }
  });
}

}  // namespace
}  // namespace limitcurve::godobject::test::scene_soak_test
