// SPDX-License-Identifier: MIT
// Faults of the first edition on curved surfaces: twist without rotation, and energy gain on a closed path. The test
// computes work and spin independently: from forces along the finger's path, and from angles in closed form.
#include "godobject/body/grasp.hpp"
#include "godobject/surfaces/surfaces.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::curved_surface_test {
namespace {

constexpr double pi = std::numbers::pi;

FingerParameters skin() {
  return parameters(0.6, 0.006, 1000.0, 0.036);
}

Quaterniond about(const Vector3d& axis, double angle) {
  return Quaterniond(AngleAxisd(angle, axis));
}

/// Work on the user along a path, by the trapezoidal rule in force and in moment about the normal.
struct Work {
  double sum = 0.0;  // [J]
  bool all_stick = true;

  void add(const DevicePose& to, const FingerOutput& output) {
    const Vector3d force = output.whole_force();
    const Vector3d moment = output.moment_vector();
    if (known_) {
      const AngleAxisd turn(to.orientation * last_.orientation.conjugate());
      sum += 0.5 * (force + force_).dot(to.position - last_.position) +
             0.5 * (moment + moment_).dot(turn.axis() * turn.angle());
      all_stick = all_stick && output.state == ContactState::stick;
    }
    last_ = to;
    force_ = force;
    moment_ = moment;
    known_ = true;
  }

 private:
  DevicePose last_;
  Vector3d force_ = Vector3d::Zero();
  Vector3d moment_ = Vector3d::Zero();
  bool known_ = false;
};

// Point 1: on a circle of latitude θ from the pole, with the axes of longitude and latitude for orientation, a finger
// turns about the pole's axis by 2π, of which cos θ about the normal; and one that keeps its orientation does not turn.
TEST(CurvedSurface, ACircleOfLatitudeTwistsByItsHolonomy) {
  const AnySurface ball(SphereSurface(0.05));
  for (const double theta : {0.05, 0.7, 1.5, 2.5}) {
    SoftFinger turning = hertz_finger(skin());
    SoftFinger still = hertz_finger(skin());
    for (int i = 0; i <= 500; ++i) {
      const double longitude = 2.0 * pi * i / 500.0;
      const Vector3d place = 0.0485 * Vector3d(std::sin(theta) * std::cos(longitude),
                                               std::sin(theta) * std::sin(longitude), std::cos(theta));
      turning.update(ball, {place, about(Vector3d::UnitZ(), longitude) * about(Vector3d::UnitY(), theta)});
      still.update(ball, {place, about(Vector3d(1.0, 2.0, 3.0).normalized(), 1.0)});
    }
    EXPECT_NEAR(turning.state().sample.angle, 2.0 * pi * std::cos(theta), 1e-11) << theta;
    EXPECT_EQ(still.state().sample.angle, 0.0) << theta;
  }
}

// Points 1 and 10: a stuck finger on a plane, wound up, cones about the normal at a tilt of 0.3 rad. What it feeds to
// its user in each turn is what its springs lose.
TEST(CurvedSurface, ConingFeedsNothingButTheSprings) {
  FingerParameters with = skin();
  with.mu = 50.0;
  SoftFinger finger = hertz_finger(with);
  const AnySurface plane(PlaneSurface{});
  const auto pose = [](double phase, double wound) {
    return DevicePose{
        {0.0, 0.0, -0.002},
        about(Vector3d::UnitZ(), phase) * about(Vector3d::UnitY(), 0.3) * about(Vector3d::UnitZ(), wound - phase)};
  };
  for (int i = 0; i <= 100; ++i) finger.update(plane, pose(0.0, 0.5 * i / 100.0));
  const double begin = finger.spring_energy();
  Work work;
  for (int i = 0; i <= 20000; ++i) {
    const DevicePose device = pose(4.0 * pi * i / 20000.0, 0.5);
    work.add(device, finger.update(plane, device));
  }
  EXPECT_TRUE(work.all_stick);
  EXPECT_GT(std::fabs(finger.spring_energy() - begin), begin);  // by 2π(1 − cos 0.3) a turn
  EXPECT_NEAR(work.sum, begin - finger.spring_energy(), 1e-8 * begin);
}

// A finger drops down a step of 5 mm, from tread to tread in one sample or in many: it rests there, and bears what
// friction holds.
TEST(CurvedSurface, AStairKeepsNoSpringsOfTheUpperTread) {
  for (const double mu : {0.0, 0.1, 0.6}) {
    for (const double depth : {1e-4, 0.002}) {
      for (const int parts : {1, 2, 4, 10, 100}) {  // of 10 ms
        SoftFinger finger = hertz_finger(parameters(mu));
        const Vector3d from(-2e-5, 0.0, 2e-4);
        const Vector3d to(1e-5, 0.0, -depth);
        const auto go = [&](const Vector3d& x) {
          const double tread = x.x() < 0.0 ? 0.005 : 0.0;
          return finger.update({{x.x(), x.y(), tread}, Vector3d::UnitZ(), tread - x.z()}, 0.0, 0.01 / parts);
        };
        for (int i = 0; i < parts; ++i) go(from + (to - from) * i / parts);
        go(to);
        const FingerOutput rest = go(to);
        EXPECT_LE(rest.load, 1000.0 * depth * (1.0 + mu) * (1.0 + 1e-12)) << mu << ' ' << depth << ' ' << parts;
        EXPECT_EQ(rest.state, ContactState::stick) << mu << ' ' << depth << ' ' << parts;
        EXPECT_TRUE(same_bits(go(to).proxy, rest.proxy));
      }
    }
  }
}

// A finger that trembles in a corner of two faces, of which the host gives the nearer: its sticks keep the springs.
TEST(CurvedSurface, ACornerKeepsItsSticks) {
  Random random(10);
  int sticks = 0;
  int lowered = 0;
  for (int run = 0; run < 50; ++run) {
    const double mu = random.logarithmic(0.1, 3.0);
    SoftFinger finger = hertz_finger(parameters(mu));
    const double size = random.logarithmic(1e-6, 3e-5);
    Vector3d x(1e-4, 0.0, 1e-4);
    Vector3d velocity = Vector3d::Zero();
    for (int i = 0; i < 2000; ++i) {
      velocity = 0.98 * velocity + random.vector(size);
      x += velocity + 0.01 * (Vector3d(-3e-4, 0.0, -3e-4) - x);
      const bool floor = x.z() < x.x();
      const double depth = -(floor ? x.z() : x.x());
      const Vector3d normal = floor ? Vector3d::UnitZ() : Vector3d::UnitX();
      const Vector3d before = finger.output().proxy;
      const bool touched = finger.state().in_contact;
      const FingerOutput out = finger.update({x + normal * depth, normal, depth}, 0.0);
      if (!touched || depth <= 0.0) continue;
      sticks += out.state == ContactState::stick;
      lowered += normal.dot(before - x) > (1.0 + mu) * depth * (1.0 + 1e-9);
    }
  }
  EXPECT_GT(sticks, 1000);
  EXPECT_LT(lowered, sticks / 500);
}

// A ball that does not turn slides past a finger at rest: the normal at the end of a step acts on all of it. What this
// adds to the energy is within the bound of godobject/README.md ("Energy"), and half the time step adds half as much in
// all.
TEST(CurvedSurface, ABallThatSlidesPastGainsWhatIsSaid) {
  for (const double mu : {0.0, 0.01, 0.3}) {
    for (const double depth : {0.0005, 0.004, 0.012}) {
      for (const double speed : {0.5, 1.0}) {
        const auto rises = [&](double time_step) {
          BodyParameters body = BodyParameters::ball(0.1, 0.03);
          body.gravity.setZero();
          body.free = {true, true, true, false, false, false};
          Grasp grasp(body, BodyState{}, AnySurface(SphereSurface(0.03)),
                      {hertz_finger(parameters(mu)), hertz_finger(parameters(mu))});
          const std::array<DevicePose, 2> devices{DevicePose{{0.0, 0.0, 0.03 - depth}},
                                                  DevicePose{{0.0, 0.0, depth - 0.03}}};
          BodyState start;
          start.position.x() = 0.005;
          grasp.place(start, devices);
          start.velocity.x() = -speed;
          grasp.place(start, devices);
          const double first = grasp.energy();
          double sum = 0.0;
          for (int i = 0; i * time_step < 0.01 / speed; ++i) {
            const double last = grasp.energy();
            double bound = 1e-12 * first;
            const std::array before{grasp.finger(0).state().sample, grasp.finger(1).state().sample};
            grasp.step(devices, time_step);
            for (std::size_t k = 0; k < 2; ++k) {
              const FingerSample& now = grasp.finger(k).state().sample;
              const double way = (now.goal - before[k].goal).norm();
              const double turn = (now.normal - before[k].normal).norm();
              bound += (grasp.force_on_user(k).norm() + 0.5 * 1000.0 * way * turn) * way * turn;
            }
            EXPECT_LE(grasp.energy() - last, bound) << mu << ' ' << depth << ' ' << speed << ' ' << i;
            sum += std::max(grasp.energy() - last, 0.0) / first;
          }
          EXPECT_EQ(grasp.unsolved() + grasp.divided(), 0U);
          return sum;
        };
        const double whole = rises(1e-3);
        if (mu > 0.0 || depth != 0.004) continue;
        EXPECT_GT(whole, 1e-4) << "it shows: " << speed;
        EXPECT_LE(rises(2.5e-4), 0.4 * whole) << speed;
      }
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test::curved_surface_test
