// SPDX-License-Identifier: MIT
// No path of a device wins energy from a finger: random paths on every surface, climbing towards the one that wins
// most. Slowly led, a finger gives back what it stored at most; sampled and held, what `device_damping_needed` names is
// enough.
#include "tests/godobject/scene/metamorphic/energy_search.hpp"

namespace limitcurve::godobject::test::energy_search_test {
namespace {

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

/// What a search is for: paths of a finger within reach of a surface.
struct Search {
  SoftFinger finger;
  const AnySurface& surface;
  Reach reach;
  Random& random;

  [[nodiscard]] DevicePose outside() const { return random_pose(reach, random, true); }
  template <class Value>
  double climb(int tries, Value&& value) const {
    Path path;
    for (std::size_t i = 0; i < poses; ++i) path.push_back(random_pose(reach, random));
    return test::climb(path, reach, repetitions(tries), random, value);
  }
};

/// Calls `body(search)` for the choices without dampers, as they are, rough as sandpaper, and so rough that nothing
/// slips.
template <class Body>
void for_each_search(std::uint64_t seed, Body&& body) {
  for_each_choice(seed, [&](const Choice& choice, Random& random) {
    FingerParameters with = choice.parameters.finger;
    if (with.damping > 0.0) return;
    const double which = random.uniform(0.0, 1.0);
    if (which < 0.3) with.mu = 100.0;
    if (which > 0.7 && with.mu > 0.0) with.mu = 1.67;
    const AnySurface& surface = choice.surface.surface;
    body(Search{{make_finger_curve(choice.curve.kind, hertz(), 1e-8), with, choice.curve.projection},
                surface,
                reach_on(surface, random),
                random});
  });
}

// From outside into the surface and thrice round a loop, and out again: at no time has the user more than was put in.
// What is climbed for is what the last round wins.
TEST(EnergySearch, NoLoopWinsEnergy) {
  double best = -1.0;
  int slips = 0;
  int sticks = 0;
  for_each_search(21, [&](const Search& search) {
    const AnySurface& surface = search.surface;
    const DevicePose outside = search.outside();
    const auto round = [&](const Path& path) {
      SlowUser user(search.finger);
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
    best = std::max(best, search.climb(300, round));
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
  for_each_search(22, [&](Search search) {
    const AnySurface& surface = search.surface;
    if (search.random.uniform(0.0, 1.0) < 0.3) search.reach.depth = search.reach.aside = 0.025;
    const DevicePose outside = search.outside();
    const auto gain = [&](const Path& path) {
      SlowUser user(search.finger);
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
    search.climb(300, gain);
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
  for_each_search(23, [&](Search search) {
    const AnySurface& surface = search.surface;
    const bool turns = search.random.below(2) == 0;
    if (!turns) search.reach.turn = 0.0;
    const DevicePose outside = search.outside();
    const auto delay = static_cast<int>(search.random.below(3));
    const DeviceDamping device = device_damping_needed(search.finger.parameters(), time_step, delay);
    const auto gain = [&](const Path& path) {
      SampledUser user(search.finger, device, time_step, delay);
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
    best = std::max(best, search.climb(200, gain));
  });
  EXPECT_GT(best, -1e-12);
}

}  // namespace
}  // namespace limitcurve::godobject::test::energy_search_test
