// SPDX-License-Identifier: MIT
// Entry "reality": bristles, the usual friction of dynamic models, at the rates and loads of real devices.
#include "../failures.hpp"

#include "../../../tests/fit/synthetic.hpp"
#include "../numerics/sampling.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace limitcurve::stability {

namespace {

using namespace godobject;
using Eigen::Vector3d;

constexpr double mu = 0.5;
constexpr double stiffness = 1000.0;
constexpr double depth = 1e-3;
constexpr double limit = mu * stiffness * depth;  // [N]

/// Friction as bristles (P. Dahl 1968; LuGre without its viscous parts), a step a sample: dz/dt = v − |v| k z/(μP),
/// force k z.
class Bristles {
 public:
  /// Friction [N] at x under the limit μP, along the motion that it resists.
  double update(double x, double most) {
    const double moved = x - last_;
    last_ = x;
    stretch_ += moved - std::fabs(moved) * stiffness * stretch_ / most;
    return stiffness * stretch_;
  }

 private:
  double last_ = 0.0;
  double stretch_ = 0.0;
};

SoftFinger finger_of_skin() {
  FingerParameters with;
  with.mu = mu;
  with.stiffness = stiffness;
  with.max_speed = 1e9;  // some jump
  return {Ellipse::through_intercepts(hertz()->moment_ratio()), with};
}

Contact at(double x, double y = 0.0, double beneath = depth) {
  return {{x, y, 0.0}, Vector3d::UnitZ(), beneath};
}

/// Times of samples, each off by up to `jitter` of a period.
std::vector<double> sampled(double rate, double duration, double jitter) {
  fit::Random random(9);
  std::vector<double> times{0.0};
  for (int i = 1; i < static_cast<int>(rate * duration); ++i)
    times.push_back((i + jitter * random.uniform(-1.0, 1.0)) / rate);
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
  SoftFinger finger = finger_of_skin();
  std::vector<Vector3d> forces;
  double next = 0.1;
  for (const double time : sampled(rate, 0.9, jitter)) {
    // In addition to its own samples every rate has the samples of the comparison.
    for (; next <= time && forces.size() < 40; next += 0.02) forces.push_back(finger.update(stirred(next), 0.0).force);
    finger.update(stirred(time), 0.0);
  }
  return forces;
}

}  // namespace

Hazard rates_and_jitter() {
  Hazard found;
  Figure& figure = found.draw("reality_rates");
  constexpr double jitter = 0.3;
  const auto largest = [&](double rate) {
    SoftFinger finger = finger_of_skin();
    Bristles bristles;
    std::pair<double, double> most{0.0, 0.0};
    for (const double time : sampled(rate, 1.0, jitter)) {
      const double x = scrubbed(time);
      const double force = std::fabs(bristles.update(x, limit)) / limit;
      most.first = force <= 1e6 ? std::max(most.first, force) : 1e6;
      const FingerOutput output = finger.update(at(x), 0.0);
      raise(most.second, output.force.norm() / limit);
    }
    return most;
  };
  const std::vector<Vector3d> truth = stirring(1e6, 0.0);
  const auto error = [&](double rate) {
    const std::vector<Vector3d> forces = stirring(rate, jitter);
    double worst = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) raise(worst, (forces[i] - truth[i]).norm() / limit);
    return worst;
  };
  double ours = 0.0;
  for (const double rate : in_ratios(100.0, 1e4, 33)) {
    const auto [customary, held] = largest(rate);
    raise(ours, held);
    figure.add("force", "bristles", rate, customary);
    figure.add("force", "limitcurve", rate, held);
    figure.add("error", "limitcurve", rate, error(rate));
  }
  found.add("rates with jitter of 30 %", "bristles (Dahl, LuGre), explicit",
            "largest friction / limit (scrubbing at 100 Hz; ours: 100 Hz to 10 kHz; 1e6: more)", largest(100.0).first,
            ours);
  found.add("rates with jitter of 30 %", "bristles (Dahl, LuGre), explicit", "the same at 200 Hz", largest(200.0).first,
            ours);
  return found;
}

Hazard collapsing_load() {
  SoftFinger finger = finger_of_skin();
  Bristles bristles;
  const auto contact = [](double x, double load) { return at(x, 0.0, load / stiffness); };
  // A load of 5 N, a deflection up to the limit, then a drop to 5 mN in one step, at rest.
  finger.update(contact(0.0, 5.0), 0.0);
  for (int i = 0; i <= 1000; ++i) {
    finger.update(contact(1e-5 * i, 5.0), 0.0);
    bristles.update(1e-5 * i, mu * 5.0);
  }
  const FingerOutput let_go = finger.update(contact(0.01, 0.005), 0.0);
  return {{{"load drops in one step", "bristles of a fixed stiffness (Dahl, LuGre)",
            "friction force at rest / limit (load to a thousandth in one step)",
            bristles.update(0.01, mu * 0.005) / (mu * 0.005), let_go.force.norm() / (mu * let_go.load)}},
          {}};
}

}  // namespace limitcurve::stability
