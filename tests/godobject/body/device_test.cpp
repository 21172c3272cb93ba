// SPDX-License-Identifier: MIT
// What a real device does to a finger: samples that repeat, are quantised, noisy, refused or late.
#include "godobject/body/grasp.hpp"
#include "godobject/surfaces/surfaces.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test {
namespace {

FingerParameters skin() {
  return parameters(0.6, 0.006, 1000.0, 0.036);
}

// Point 2: at 5 mm/s friction is dynamic for any resolution, rate and noise of the device. The first edition gave a
// saw-tooth with the mean 0.449.
TEST(Device, ASampleThatRepeatsOrIsNoisyDoesNotBringASlidingFingerToRest) {
  struct Kind {
    const char* name;
    std::function<Vector3d(int, std::mt19937&)> place;  // of the finger, beneath the plane z = 0
    double bound;                                       // of the mean of F/P
  };
  std::normal_distribution<double> normal;
  const std::vector<Kind> kinds{
      {"encoder of 10 um", [](int i, auto&) { return Vector3d(1e-5 * std::round(0.5 * i), 0.0, -0.0015); }, 1e-6},
      {"half the rate", [](int i, auto&) { return Vector3d(5e-6 * (i / 2 * 2), 0.0, -0.0015); }, 1e-6},
      // Where noise takes the finger back by 3 um of 450, the force falls by as much.
      {"3 um of noise", [&](int i, auto& random) { return Vector3d(5e-6 * i + 3e-6 * normal(random), 0.0, -0.0015); },
       0.001},
      // At 50 um more depth the limit is 3.3 % above the trial.
      {"50 um of noise in depth",
       [&](int i, auto& random) { return Vector3d(5e-6 * i, 0.0, -0.0015 + 5e-5 * normal(random)); }, 0.01}};
  for (const Kind& kind : kinds) {
    std::mt19937 random(1);
    FingerParameters with = skin();
    with.mu_dynamic = 0.3;
    SoftFinger finger = hertz_finger(with);
    const AnySurface plane(PlaneSurface{});
    double sum = 0.0;
    for (int i = 0; i < 4000; ++i) {
      const FingerOutput output = finger.update(plane, {kind.place(i, random)}, 1e-3);
      if (i < 500) continue;
      ASSERT_LE(output.force.norm(), 0.3 * output.load * (1.0 + 1e-11)) << kind.name << ' ' << i;
      sum += output.force.norm() / output.load;
    }
    EXPECT_NEAR(sum / 3500.0, 0.3, kind.bound) << kind.name;
  }
}

/// The times at which a mass on a drive spring, rubbed by a finger at rest, begins to slip. The mass is moved here, by
/// exact steps of its free motion.
std::vector<double> slips_of_a_mass(double mu, double mu_dynamic, double rest_margin) {
  constexpr double mass = 0.1, drive = 50.0, speed = 0.01, time_step = 2e-5, end = 14.0;  // [kg, N/m, m/s, s, s]
  FingerParameters with = skin();
  with.mu = mu;
  with.mu_dynamic = mu_dynamic;
  with.stiffness = 2e4;
  with.rest_margin = rest_margin;
  SoftFinger finger = hertz_finger(with);
  const double depth = 2.0 / with.stiffness;
  // The finger's position relative to the touched mass: symplectic Euler, with a step far below the contact's period.
  double place = 0.0, velocity = 0.0;
  bool slipped = false;
  double last_slip = -1.0;
  std::vector<double> begins;
  for (double time = 0.0; time < end; time += time_step) {
    const FingerOutput output = finger.update(on_plane(place, 0.0, depth), 0.0);
    velocity += time_step / mass * (drive * (speed * time - place) + output.force.x());
    velocity *=
        1.0 - 2.0 * time_step * (output.state == ContactState::stick ? 20.0 : 0.0);  // the skin damps what it holds
    place += time_step * velocity;
    const bool slips = output.state == ContactState::slip;
    if (slips && !slipped && time - last_slip > 0.05) begins.push_back(time);
    if (slips) last_slip = time;
    slipped = slips;
  }
  return begins;
}

// Point 2: a mass pulled at v by a spring k sticks until k x = μ P, slips with μ_d P for half of its natural period,
// and sticks again: the period is 2 (μ − μ_d) P/(k v) + π √(m/k), and 2/ω atan2 … for the drive's way during the slip.
// (Popp, Stelter 1990; v small against it.)
TEST(Device, StickSlipOfAMassKeepsItsPeriod) {
  for (const auto& [mu, mu_dynamic] : {std::pair{0.6, 0.4}, {0.6, 0.3}, {0.6, 0.55}}) {
    constexpr double mass = 0.1, drive = 50.0, speed = 0.01, load = 2.0;
    const double omega = std::sqrt(drive / mass);
    // While it slips, relative to the drive: u'' = −ω²(u − μ_d P/k), from u = μP/k and u' = v; it sticks when u' is v
    // again.
    const double jump = (mu - mu_dynamic) * load / drive;
    const double slip_time = 2.0 / omega * (std::numbers::pi - std::atan2(jump * omega, speed));
    const double period = 2.0 * jump / speed + slip_time;
    const std::vector<double> begins = slips_of_a_mass(mu, mu_dynamic, FingerParameters{}.rest_margin);
    ASSERT_GT(begins.size(), 3U) << mu_dynamic;
    const double measured = (begins.back() - begins[1]) / static_cast<double>(begins.size() - 2);
    EXPECT_NEAR(measured, period, 0.01 * period) << mu_dynamic;
  }
}

// A steady speed under time stamps that are off by up to 30 % of a step: the damper has the stamps' velocity. A stamp
// that repeats the last one gives no velocity, and no infinite force.
TEST(Device, ADamperFollowsAClockThatJittersOrStandsStill) {
  FingerParameters with = skin();
  with.damping = 5.0;
  SoftFinger finger = hertz_finger(with);
  Random random(9);
  double last = 0.0;
  const auto load = [&](double time) { return finger.update(on_plane(0.0, 0.0, 0.05 * time), 0.0, time - last).load; };
  for (int i = 0; i < 100; ++i) {
    const double time = 1e-3 * (1.0 + i + random.uniform(-0.3, 0.3));
    const double found = load(time);
    ASSERT_NEAR(found, 0.05 * (1000.0 * time + (i == 0 ? 0.0 : 5.0)), 1e-12) << i;
    last = time;
  }
  EXPECT_NEAR(finger.update(on_plane(0.0, 0.0, 0.05 * last + 5e-5), 0.0, 0.0).load, 1000.0 * (0.05 * last + 5e-5),
              1e-12);
}

}  // namespace
}  // namespace limitcurve::godobject::test
