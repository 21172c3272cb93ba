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
#include <string>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;

constexpr double tick = 1e-3;

SoftFinger finger(double stiffness, double damping, double mu) {
  FingerParameters with;
  with.mu = mu;
  with.stiffness = stiffness;
  with.damping = damping;
  return {Ellipse::through_intercepts(hertz()->moment_ratio()), with};
}

Contact pressed(double x, double depth) {
  return {{x, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), depth};
}

/// A device of 0.1 kg and some damping on a sticking contact, pushed once; the contact's force is held for a sample and comes
/// some samples late. Its motion between samples is exact.
struct Device {
  double mass = 0.1;
  double damping;
  int delay;

  /// By how much the amplitude √(x² + v²m/k) grows in a second: its largest value in a tenth of a second, and a second later.
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
      if (i < part) first = std::max(first, amplitude);
      if (i >= second) last = std::max(last, amplitude);
    }
    return last / first;
  }
};

/// The least damping at which oscillations do not grow.
double damping_that_settles(double stiffness, int delay) {
  double low = 1e-3 * stiffness * tick;
  double high = 10.0 * stiffness * tick;
  while (high - low > 1e-4 * high) {
    const double middle = 0.5 * (low + high);
    (Device{.damping = middle, .delay = delay}.growth(stiffness) > 1.0 ? low : high) = middle;
  }
  return high;
}

/// A hand moves the device to and fro with every sample, in straight lines: energy from the contact in a second [J], and the dissipation
/// of a unit of the device's damping [J s m⁻¹ N⁻¹].
struct ToAndFro {
  double given = 0.0;
  double taken_per_damping = 0.0;
};

ToAndFro to_and_fro(double stiffness, double damping, double sample_time) {
  constexpr double reach = 1e-5;
  SoftFinger contact = finger(stiffness, damping, 1e6);
  contact.update(pressed(0.0, 1e-3), 0.0);
  ToAndFro sum;
  double x = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double next = i % 2 == 0 ? reach : -reach;
    const double force = contact.update(pressed(x, 1e-3), 0.0, sample_time).force.x();
    // First let the transient of the start decay.
    if (i >= 500) {
      sum.given += force * (next - x);
      sum.taken_per_damping += (next - x) * (next - x) / sample_time;
    }
    x = next;
  }
  return sum;
}

}  // namespace

Hazard delayed_forces() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"time_delay", {}});
  constexpr double stiffness = 1000.0;
  for (const int delay : {0, 1, 2}) {
    const std::string late = delay == 0 ? "no delay" : delay == 1 ? "one sample late" : "two samples late";
    for (const double k : in_ratios(50.0, 5000.0, 21)) {
      figure.rows.push_back({"needed", late, k, damping_that_settles(k, delay)});
      figure.rows.push_back({"needed", late + ", formula", k, device_damping_needed(k, 0.0, tick, delay)});
    }
    if (delay == 0) continue;
    const double customary = 1.05 * device_damping_needed(stiffness, 0.0, tick);
    const double ours = 1.05 * device_damping_needed(stiffness, 0.0, tick, delay);
    found.findings.push_back({"force " + late, "device damped by 1.05 kT/2", "growth of an oscillation in one second (1000 N/m, 0.1 kg)",
                              Device{.damping = customary, .delay = delay}.growth(stiffness),
                              Device{.damping = ours, .delay = delay}.growth(stiffness)});
  }
  return found;
}

Hazard sampled_contact() {
  Hazard found;
  double off = 0.0;
  double most_given = 0.0;
  double our_given = 0.0;
  for (const double sample_time : {1e-4, 1e-3, 1e-2}) {
    for (const double stiffness : in_ratios(10.0, 1e4, 7)) {
      for (const double damping : {0.0, 0.1, 1.0, 10.0}) {
        const ToAndFro sum = to_and_fro(stiffness, damping, sample_time);
        const double needed = device_damping_needed(stiffness, damping, sample_time);
        const double measured = sum.given / sum.taken_per_damping;
        off = std::max(off, std::fabs(measured / needed - 1.0));
        const double unit = sum.taken_per_damping * needed;
        most_given = std::max(most_given, (sum.given - sum.taken_per_damping * damping) / unit);
        our_given = std::max(our_given, (sum.given - sum.taken_per_damping * 1.001 * needed) / unit);
      }
    }
  }
  found.findings.push_back({"sampled contact, any hand", "device damped by b, sampling ignored",
                            "energy drawn by an oscillation / dissipation of the required damping (≤ 0: none)", most_given, our_given});
  found.findings.push_back({"sampled contact, any hand", "b taken as sufficient damping",
                            "error of the sufficient damping, k 10 to 1e4 N/m, b 0 to 10 N s/m, 100 Hz to 10 kHz", 1.0, off});
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
    customary = std::max(customary, std::fabs(spring - damping * (x - last) / sample_time) / mu);
    last = x;
    const FingerOutput output = dragged.update(pressed(x, 1e-3), 0.0, sample_time);
    ours = std::max(ours, output.force.norm() / (mu * output.load));
  }
  found.findings.push_back({"encoder steps of 10 µm, velocities from differences", "damper beside the friction limit",
                            "largest friction force / limit (5 N s/m, 5 mm/s, 10 kHz)", customary, ours});
  // A finger rests at half the limit while the encoder jitters by a step: methods that sum increments creep.
  double stretch = 0.5 * mu / stiffness;
  const double at_first = stretch;
  SoftFinger contact = finger(stiffness, 0.0, mu);
  contact.update(pressed(0.0, 1e-3), 0.0);
  const double proxy = contact.update(pressed(at_first, 1e-3), 0.0).proxy.x();
  double creep = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double jump = i % 2 == 0 ? resolution : -resolution;
    stretch += jump - std::fabs(jump) * stiffness * stretch / mu;
    creep = std::max(creep, std::fabs(contact.update(pressed(at_first + (i % 2 == 0 ? resolution : 0.0), 1e-3), 0.0).proxy.x() - proxy));
  }
  found.findings.push_back({"encoder steps of 10 µm, at rest", "bristles (Dahl, LuGre)", "creep at half the limit / deflection (1e4 steps)",
                            (at_first - stretch) / at_first, creep / at_first});
  return found;
}

}  // namespace limitcurve::stability
