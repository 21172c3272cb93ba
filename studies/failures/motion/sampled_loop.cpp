// SPDX-License-Identifier: MIT
// Entry "time": forces that are sampled, late, and from the steps of an encoder.
#include "../failures.hpp"
#include "../numerics/sampling.hpp"
#include "godobject/scene/passivity.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limitcurve::stability {

namespace {

using namespace godobject;

constexpr double tick = 1e-3;

SoftFinger finger(double stiffness, double damping, double mu) {
  FingerParameters with;
  with.mu = mu;
  with.stiffness = stiffness;
  with.max_speed = 1e9;  // some jump
  with.damping = damping;
  return {Ellipse::through_intercepts(hertz()->moment_ratio()), with};
}

Contact pressed(double x, double depth) {
  return {{x, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), depth};
}

/// A device of 0.1 kg and some damping on a sticking contact, pushed once; the contact's force is held for a sample and
/// comes some samples late. Its motion between samples is exact.
struct Device {
  double mass = 0.1;
  double damping;
  int delay;

  /// By how much the amplitude √(x² + v²m/k) grows in a second: its largest value in a tenth of a second, and a second
  /// later.
  [[nodiscard]] double growth(double stiffness) const {
    SoftFinger contact = finger(stiffness, 0.0, 1e6);
    contact.update(pressed(0.0, 1e-3), 0.0);
    std::array<double, 4> line{};
    double x = 0.0;
    double v = 1e-3;
    const double decay = std::exp(-damping * tick / mass);
    double first = 0.0;
    double last = 0.0;
    constexpr int second = 1000;
    constexpr int part = 100;
    for (int i = 0; i < second + part; ++i) {
      std::rotate(line.begin(), line.end() - 1, line.end());
      line[0] = contact.update(pressed(x, 1e-3), 0.0).force.x();
      const double force = line[static_cast<std::size_t>(delay)];
      // v decays towards force/damping.
      const double final = force / damping;
      x += final * tick + (v - final) * mass / damping * (1.0 - decay);
      v = final + (v - final) * decay;
      const double amplitude = std::hypot(x, v * std::sqrt(mass / stiffness));
      if (i < part) raise(first, amplitude);
      if (i >= second) raise(last, amplitude);
    }
    return last / first;
  }
};

}  // namespace

Hazard delayed_forces() {
  Hazard found;
  constexpr double stiffness = 1000.0;
  const auto growth = [](double needed, int delay) {
    return Device{.damping = 1.05 * needed, .delay = delay}.growth(stiffness);
  };
  for (const int delay : {1, 2}) {
    found.add(delay == 1 ? "force one sample late" : "force two samples late", "device damped by 1.05 kT/2",
              "growth of an oscillation in one second (1000 N/m, 0.1 kg)",
              growth(device_damping_needed(stiffness, 0.0, tick), delay),
              growth(device_damping_needed(stiffness, 0.0, tick, delay), delay));
  }
  return found;
}

Hazard encoder_steps() {
  Hazard found;
  constexpr double mu = 0.5;
  constexpr double stiffness = 1000.0;
  constexpr double damping = 5.0;
  constexpr double resolution = 1e-5;
  constexpr double sample_time = 1e-4;
  SoftFinger dragged = finger(stiffness, damping, mu);
  dragged.update(pressed(0.0, 1e-3), 0.0);
  double customary_proxy = 0.0;
  double last = 0.0;
  double customary = 0.0;
  double ours = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    const double x = resolution * std::round(5e-3 * i * sample_time / resolution);
    // The usual method: the spring within the friction limit, plus the damper.
    double spring = stiffness * (customary_proxy - x);
    if (std::fabs(spring) > mu) {
      spring = std::copysign(mu, spring);
      customary_proxy = x + spring / stiffness;
    }
    raise(customary, std::fabs(spring - damping * (x - last) / sample_time) / mu);
    last = x;
    const FingerOutput output = dragged.update(pressed(x, 1e-3), 0.0, sample_time);
    raise(ours, output.force.norm() / (mu * output.load));
  }
  found.add("encoder steps of 10 µm, velocities from differences", "damper beside the friction limit",
            "largest friction force / limit (5 N s/m, 5 mm/s, 10 kHz)", customary, ours);
  return found;
}

}  // namespace limitcurve::stability
