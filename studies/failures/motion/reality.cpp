// SPDX-License-Identifier: MIT
// Entry "reality": real devices.
#include "../failures.hpp"

#include "../../../tests/touch.hpp"
#include "../numerics/sampling.hpp"
#include "../random.hpp"
#include "bristles.hpp"
#include "godobject/soft_finger.hpp"
#include "godobject/surface.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;
using Eigen::Vector3d;

constexpr double mu = 0.5;
constexpr double stiffness = 1000.0;
constexpr double depth = 1e-3;
constexpr double limit = mu * stiffness * depth;  // [N]

FingerParameters parameters() {
  FingerParameters with;
  with.mu = mu;
  with.stiffness = stiffness;
  return with;
}

SoftFinger made_of(const FingerParameters& with) {
  return {Ellipse::through_intercepts(hertz()->moment_ratio()), with};
}

Contact at(double x, double y = 0.0, double beneath = depth) {
  return {{x, y, 0.0}, Vector3d::UnitZ(), beneath};
}

/// Times of samples, each off by up to `jitter` of a period.
std::vector<double> sampled(double rate, double duration, double jitter) {
  Random random(9);
  std::vector<double> times{0.0};
  for (int i = 1; i < static_cast<int>(rate * duration); ++i) times.push_back((i + jitter * random.uniform(-1.0, 1.0)) / rate);
  times.push_back(duration);
  return times;
}

/// A hand that moves to and fro, 2 cm at 2 Hz, up to 0.25 m/s.
double scrubbed(double time) {
  return 0.02 * std::sin(4.0 * std::numbers::pi * time);
}

/// One that stirs: an eight of 2 by 1 cm.
Contact stirred(double time) {
  return at(0.01 * std::sin(4.0 * std::numbers::pi * time), 0.005 * std::sin(8.0 * std::numbers::pi * time + 0.3));
}

/// Friction while stirring, when the next sample is due at each of 40 times.
std::vector<Vector3d> stirring(double rate, double jitter) {
  SoftFinger finger = made_of(parameters());
  std::vector<Vector3d> forces;
  double next = 0.1;
  for (const double time : sampled(rate, 0.9, jitter)) {
    // In addition to its own samples every rate has the samples of the comparison.
    for (; next <= time && forces.size() < 40; next += 0.02) forces.push_back(finger.update(stirred(next), 0.0).force);
    finger.update(stirred(time), 0.0);
  }
  return forces;
}

/// The usual load: a spring and a damper with the reported time step.
double customary_load(double beneath, double last, double damping, double time_step) {
  return stiffness * beneath + damping * (beneath - last) / time_step;
}

}  // namespace

Hazard rates_and_jitter() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"reality_rates", {}});
  constexpr double jitter = 0.3;
  const auto largest = [&](double rate) {
    SoftFinger finger = made_of(parameters());
    Bristles bristles(stiffness, 0.0);
    std::pair<double, double> most{0.0, 0.0};
    for (const double time : sampled(rate, 1.0, jitter)) {
      const double x = scrubbed(time);
      const double force = std::fabs(bristles.update(x, limit)) / limit;
      most.first = force <= 1e6 ? std::max(most.first, force) : 1e6;
      const FingerOutput output = finger.update(at(x), 0.0);
      most.second = std::max(most.second, output.force.norm() / limit);
    }
    return most;
  };
  const std::vector<Vector3d> truth = stirring(1e6, 0.0);
  const auto error = [&](double rate) {
    const std::vector<Vector3d> forces = stirring(rate, jitter);
    double worst = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) worst = std::max(worst, (forces[i] - truth[i]).norm() / limit);
    return worst;
  };
  double ours = 0.0;
  for (const double rate : in_ratios(100.0, 1e4, 33)) {
    const auto [customary, held] = largest(rate);
    ours = std::max(ours, held);
    figure.rows.push_back({"force", "bristles", rate, customary});
    figure.rows.push_back({"force", "limitcurve", rate, held});
    figure.rows.push_back({"error", "limitcurve", rate, error(rate)});
  }
  found.findings.push_back({"rates with jitter of 30 %", "bristles (Dahl, LuGre), explicit",
                            "largest friction / limit (scrubbing at 100 Hz; ours: 100 Hz to 10 kHz; 1e6: more)", largest(100.0).first,
                            ours});
  found.findings.push_back(
      {"rates with jitter of 30 %", "bristles (Dahl, LuGre), explicit", "the same at 200 Hz", largest(200.0).first, ours});
  return found;
}

Hazard clocks() {
  Hazard found;
  constexpr double damping = 5.0;
  constexpr double speed = 0.05;
  constexpr double tick = 1e-3;
  FingerParameters with = parameters();
  with.damping = damping;
  // A depth that grows at a steady speed: the damper's part of the load is b v.
  const auto load = [&](double time) { return stiffness * speed * time + damping * speed; };
  {
    SoftFinger finger = made_of(with);
    double last = 0.0;
    double customary = 0.0;
    double ours = 0.0;
    for (const double time : sampled(1.0 / tick, 0.05, 0.3)) {
      if (time == 0.0) {
        finger.update(at(0.0, 0.0, 1e-9), 0.0);
        continue;
      }
      const double nominal = customary_load(speed * time, speed * last, damping, tick);
      const double read = finger.update(at(0.0, 0.0, speed * time), 0.0, time - last).load;
      if (last > 0.0) {
        customary = std::max(customary, std::fabs(nominal - load(time)) / (damping * speed));
        ours = std::max(ours, std::fabs(read - load(time)) / (damping * speed));
      }
      last = time;
    }
    found.findings.push_back(
        {"a clock with jitter of 30 %", "the nominal time step", "error of the damper's force / (b v)", customary, ours});
  }
  // A time stamp that repeats the last one, or is before it.
  for (const auto& [stamp, what] : {std::pair(0.0, "stands still"), std::pair(-1e-5, "runs backwards by 10 µs")}) {
    SoftFinger finger = made_of(with);
    for (int i = 1; i <= 20; ++i) finger.update(at(0.0, 0.0, speed * tick * i), 0.0, tick);
    const double before = speed * tick * 20;
    const double now = speed * tick * 21;
    const double customary = customary_load(now, before, damping, stamp);
    const double ours = finger.update(at(0.0, 0.0, now), 0.0, stamp).load;
    const double right = stiffness * now;
    found.findings.push_back({std::string("a clock that ") + what, "damper with the reported time step", "load of that sample / k_l d",
                              customary / right, ours / right});
  }
  return found;
}

Hazard bad_samples() {
  Hazard found;
  FingerParameters with = parameters();
  with.max_displacement = 0.01;
  with.fault_decay = 0.99;
  SoftFinger finger = made_of(with);
  Bristles bristles(stiffness, 0.0);
  const auto path = [](int i) { return 1e-5 * i; };
  for (int i = 0; i < 100; ++i) {
    finger.update(at(path(i)), 0.0);
    bristles.update(path(i), limit);
  }
  const double before = finger.output().load;
  // A NaN sample.
  double customary = 0.0;
  double ours = 0.0;
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  finger.update(at(nothing), 0.0);
  static_cast<void>(bristles.update(nothing, limit));
  for (int i = 101; i <= 1100; ++i) {
    customary += !std::isfinite(bristles.update(path(i), limit));
    ours += !finger.update(at(path(i)), 0.0).force.allFinite();
  }
  found.findings.push_back(
      {"one sample that is NaN", "bristles; any accumulated state", "samples of the next 1000 without a force", customary, ours});
  // A sample 10 cm deep.
  const double leap = finger.update(at(path(1101), 0.0, 0.1), 0.0).load;
  found.findings.push_back({"one sample that jumps by 10 cm", "load k_l d of the raw sample",
                            "load of that sample / before (ours: max_displacement 1 cm)", stiffness * 0.1 / before, leap / before});
  // No samples any more.
  finger.update(at(path(1102)), 0.0);
  const double last = finger.update(at(path(1103)), 0.0).load;
  for (int i = 0; i < 1000; ++i) finger.update(at(nothing), 0.0);
  found.findings.push_back({"samples that stop", "the last force held", "load after a second / before (1 kHz; ours: fault_decay 0.99)", 1.0,
                            finger.output().load / last});
  return found;
}

Hazard plate_between_samples() {
  const Vector3d half{0.03, 0.02, 0.0005};
  const BoxSurface box(half);
  Hazard found;
  // A fall at 0.4 m/s, sampled at 1 kHz; the first sample after ten lost ones.
  constexpr double way = 0.4e-3;
  ContactMemory memory;
  static_cast<void>(touch(box, {0.003, 0.001, half.z() + 0.5 * way}, memory));
  const Vector3d now(0.003, 0.001, half.z() + 0.5 * way - way * 11);
  const double depth_right = half.z() - now.z();
  // The usual method: inside or not, and out through the nearest face.
  const double beneath = std::max(half.z() - std::fabs(now.z()), 0.0);
  const double customary = beneath > 0.0 ? std::copysign(beneath, now.z()) / depth_right : 0.0;
  const Contact contact = touch(box, now, memory);
  found.findings.push_back({"lost samples at a thin plate", "inside test at each sample",
                            "load / k_l d on the entry side (ten samples lost)", customary,
                            std::max(contact.depth, 0.0) * contact.normal.z() / depth_right});
  return found;
}

Hazard frozen_device() {
  Hazard found;
  SoftFinger finger = made_of(parameters());
  Bristles bristles(stiffness, 0.0);
  double creep = 0.0;
  double customary = 0.0;
  double ours = 0.0;
  // A deflection at half the limit, frozen for ten seconds, then 2 cm away.
  for (int i = 0; i <= 10; ++i) {
    finger.update(at(0.25e-4 * i), 0.0);
    bristles.update(0.25e-4 * i, limit);
  }
  const Vector3d proxy = finger.output().proxy;
  for (int i = 0; i < 10000; ++i) {
    bristles.update(0.25e-3, limit);
    creep = std::max(creep, (finger.update(at(0.25e-3), 0.0).proxy - proxy).norm());
  }
  for (int i = 0; i < 100; ++i) {
    customary = std::max(customary, std::fabs(bristles.update(0.02 + 1e-5 * i, limit)) / limit);
    ours = std::max(ours, finger.update(at(0.02 + 1e-5 * i), 0.0).force.norm() / limit);
  }
  found.findings.push_back({"a device that freezes and continues 2 cm away", "bristles (Dahl, LuGre), explicit",
                            "largest friction / limit after it", customary, ours + creep});
  return found;
}

}  // namespace limitcurve::stability
