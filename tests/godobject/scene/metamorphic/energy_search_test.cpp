// SPDX-License-Identifier: MIT
// No path of a device wins energy from a finger: random paths on every surface, climbing towards the one that wins
// most. Slowly led, a finger gives back what it stored at most; sampled and held, what `device_damping_needed` names is
// enough.
#include "tests/godobject/scene/metamorphic/energy_search.hpp"

#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

namespace limitcurve::godobject::test::energy_search_test {
namespace {

using Eigen::Vector3d;

constexpr double time_step = 1e-3;
constexpr std::size_t poses = 8;

/// Somewhere on a surface.
Reach reach_on(const AnySurface& surface, Random& random) {
  Vector3d from = 0.2 * random_direction(random);
  from.z() = std::fabs(from.z());
  const Contact contact = surface.contact(from, {});
  return {contact.point,
          contact.normal,
          random.logarithmic(1e-4, 0.008),
          random.logarithmic(1e-4, 0.006),
          random.uniform(0.0, 1.0),
          random.uniform(0.0, 1.0)};
}

Path random_path(const Reach& reach, Random& random) {
  Path path;
  for (std::size_t i = 0; i < poses; ++i) path.push_back(random_pose(reach, random));
  return path;
}

/// The sets of parameters without dampers, as they are, rough as sandpaper, and so rough that nothing slips.
bool prepare(FingerParameters& finger, Random& random) {
  if (finger.damping > 0.0) return false;
  const double which = random.uniform(0.0, 1.0);
  if (which < 0.3) finger.mu = 100.0;
  if (which > 0.7 && finger.mu > 0.0) finger.mu = 1.67;
  return true;
}

// From outside into the surface and thrice round a loop, and out again: at no time has the user more than was put in.
// What is climbed for is what the last round wins.
TEST(EnergySearch, NoLoopWinsEnergy) {
  double best = -1.0;
  int slips = 0;
  int sticks = 0;
  for_each_choice(21, [&](const Choice& choice, Random& random) {
    FingerParameters with = choice.parameters.finger;
    if (!prepare(with, random)) return;
    const SoftFinger finger(make_finger_curve(choice.curve.kind, hertz(), 1e-8), with, choice.curve.projection);
    const AnySurface& surface = choice.surface.surface;
    const Reach reach = reach_on(surface, random);
    const DevicePose outside = random_pose(reach, random, true);
    const auto round = [&](const Path& path) {
      SlowUser user(finger);
      user.move(surface, outside);
      double before = 0.0;
      double lost = 0.0;
      for (int turn = 0; turn < 3; ++turn) {
        before = user.won().work + user.stored();
        for (const DevicePose& pose : path) {
          user.move(surface, pose);
          EXPECT_LE(user.won().beyond_rounding(), 0.0);
          const ContactState state = user.finger().output().state;
          slips += state == ContactState::slip;
          sticks += state == ContactState::stick;
          if (state == ContactState::free) lost = -1.0;
        }
      }
      const double won = user.won().work + user.stored() - before;
      EXPECT_LE(won, user.won().rounding);
      user.move(surface, outside);
      EXPECT_LE(user.won().beyond_rounding(), 0.0);
      return won + lost;
    };
    best = std::max(best, climb(random_path(reach, random), reach, repetitions(300), random, round));
  });
  // The search finds loops that lose nothing.
  EXPECT_GT(best, -1e-12);
  EXPECT_GT(slips, repetitions(10000));
  EXPECT_GT(sticks, repetitions(10000));
}

// A slip loses energy, and what is said to be dissipated is not more than that; on every surface, also where a finger
// leaps across it. What is climbed for is the least loss.
TEST(EnergySearch, EverySlipLosesWhatItSays) {
  int slips = 0;
  for_each_choice(22, [&](const Choice& choice, Random& random) {
    FingerParameters with = choice.parameters.finger;
    if (!prepare(with, random)) return;
    const SoftFinger finger(make_finger_curve(choice.curve.kind, hertz(), 1e-8), with, choice.curve.projection);
    const AnySurface& surface = choice.surface.surface;
    Reach reach = reach_on(surface, random);
    if (random.uniform(0.0, 1.0) < 0.3) reach.depth = reach.aside = 0.025;
    const DevicePose outside = random_pose(reach, random, true);
    const auto gain = [&](const Path& path) {
      SlowUser user(finger);
      user.move(surface, outside);
      double most = -1e300;
      for (const DevicePose& pose : path) {
        const bool touched = user.finger().state().in_contact;
        const Won before = user.won();
        const double stored = user.stored();
        user.move(surface, pose);
        const FingerOutput now = user.finger().output();
        if (!touched || now.state == ContactState::free) continue;
        const double won = user.won().work - before.work + user.stored() - stored;
        const double rounding = user.won().rounding - before.rounding;
        EXPECT_LE(won, rounding);
        EXPECT_GE(now.slip_work, 0.0);
        EXPECT_LE(now.slip_work, rounding - won);
        if (now.state != ContactState::slip) continue;
        ++slips;
        most = std::max(most, won);
      }
      return most;
    };
    climb(random_path(reach, random), reach, repetitions(300), random, gain);
  });
  EXPECT_GT(slips, repetitions(10000));
}

/// Steps over a sphere of 10 mm so slowly that a step is a small part of what slides; returns what a user put in, less
/// what is stored, by what is said to be dissipated.
double put_in_by_dissipated(const AnySurface& surface, double depth, int steps) {
  SlowUser user(hertz_finger(parameters(0.6, 0.006, 1000.0, 0.036)));
  double dissipated = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 1.5 * i / steps;
    user.move(surface, {(0.01 - depth) * Vector3d(std::sin(angle), 0.0, std::cos(angle))});
    dissipated += user.finger().output().slip_work;
  }
  return -(user.won().work + user.stored()) / dissipated;
}

// Friction acts at the proxy, a depth farther from the middle of a sphere than the finger is, but not along the same
// direction: what is dissipated is what the user puts in, to the first order in the time step.
TEST(EnergySearch, OnASphereTheUserPutsInWhatIsDissipated) {
  const AnySurface sphere(SphereSurface(0.01));
  for (const double depth : {0.0005, 0.002, 0.004}) {
    const double coarse = put_in_by_dissipated(sphere, depth, 1000) - 1.0;
    const double fine = put_in_by_dissipated(sphere, depth, 4000) - 1.0;
    EXPECT_GE(fine, 0.0) << depth;
    EXPECT_NEAR(fine, 0.25 * coarse, 0.1 * coarse) << depth;
  }
}

// Sampled, late by up to two samples and held, with a device damped as `device_damping_needed` says: no path wins, on
// any surface, of translation and of twist about the normal. A device that turns while its finger's normal turns too
// wins by the held moment at most ½ |M| |Δn| |Δθ| in a step.
TEST(EnergySearch, TheDampingThatIsNamedIsEnough) {
  double best = -1.0;
  for_each_choice(23, [&](const Choice& choice, Random& random) {
    FingerParameters with = choice.parameters.finger;
    if (!prepare(with, random)) return;
    const SoftFinger finger(make_finger_curve(choice.curve.kind, hertz(), 1e-8), with, choice.curve.projection);
    const AnySurface& surface = choice.surface.surface;
    Reach reach = reach_on(surface, random);
    const bool turns = random.uniform(0.0, 1.0) < 0.5;
    if (!turns) reach.turn = 0.0;
    const DevicePose outside = random_pose(reach, random, true);
    const int delay = static_cast<int>(random.uniform(0.0, 2.999));
    const DeviceDamping device = device_damping_needed(with, time_step, delay);
    const auto gain = [&](const Path& path) {
      SampledUser user(finger, device, time_step, delay);
      user.move(surface, outside);
      double before = 0.0;
      for (int turn = 0; turn < 3; ++turn) {
        before = user.won().work;
        for (const DevicePose& pose : path) {
          user.move(surface, pose);
          EXPECT_LE(user.won().beyond_rounding(), turns ? user.turning_normal() : 0.0);
        }
      }
      return user.won().work - before;
    };
    best = std::max(best, climb(random_path(reach, random), reach, repetitions(200), random, gain));
  });
  EXPECT_GT(best, -1e-12);
}

}  // namespace
}  // namespace limitcurve::godobject::test::energy_search_test
