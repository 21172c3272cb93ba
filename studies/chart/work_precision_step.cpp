// SPDX-License-Identifier: MIT
#include "work_precision_step.hpp"

#include "way.hpp"

#include "godobject/batch/batch.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/validate/validate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::bench {
namespace {

using namespace limitcurve::godobject;

constexpr double radius = 0.005;
constexpr double depth = 0.002;

/// At 2 mm depth the load is 2 N and the friction limit 1.2 N: 1.2 mm of deflection.
FingerParameters parameters(double stiffness_ratio, double moment_ratio) {
  FingerParameters result;
  result.mu = 0.6;
  result.radius_law = RadiusLaw::constant(radius);
  result.stiffness = 1000.0;
  result.twist_stiffness = stiffness_ratio * result.stiffness * (radius * moment_ratio) * (radius * moment_ratio);
  return result;
}

struct SteadyError {
  double max = 0.0;
  double mean = 0.0;
};

/// Error of the steady wrench over stiffness ratios k_r/k_l/(m₀a)² and CORs a decade on either side of 1: many CORs,
/// because a table's error differs from cell to cell, and inside the rim Hertz is a polynomial. The fingers stay and
/// the proxies move, by steps that a float resolves.
template <class Real>
SteadyError steady_error(const Law& law, const BasicFingerCurve<Real>& curve, Projection projection) {
  constexpr int steps = 1000;           // forgets the start to rounding
  constexpr double step_length = 1e-3;  // [m]
  constexpr std::array stiffness_ratios{0.1, 0.3, 1.0, 3.0, 10.0};
  constexpr std::size_t count = 1001;
  std::vector<double> cors(count);
  for (std::size_t k = 0; k < count; ++k) cors[k] = std::pow(10.0, 2.0 * static_cast<double>(k) / (count - 1) - 1.0);
  const double m0 = law->moment_ratio();
  SteadyError result;
  for (const double ratio : stiffness_ratios) {
    const FingerParameters of_finger = parameters(ratio, m0);
    const BasicBatch<Real> stepper(curve, of_finger, projection);
    BasicContactArrays<Real> arrays(count);
    const BasicContactBatch<Real> contacts = arrays.batch();
    std::ranges::fill(arrays.depth(), static_cast<Real>(depth));
    for (int i = 0; i <= steps; ++i) {
      stepper.step(contacts);
      for (std::size_t k = 0; k < count && i < steps; ++k) {
        const SlipTwist twist = SlipTwist::about_cor(cors[k]);
        contacts.proxy_x[k] -= static_cast<Real>(step_length * twist.slide);
        contacts.proxy_angle[k] -= static_cast<Real>(step_length * twist.spin / radius);
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      const double unit = of_finger.mu * of_finger.stiffness * depth;
      const UnitWrench settled{static_cast<double>(std::fabs(contacts.fx[k])) / unit,
                               static_cast<double>(std::fabs(contacts.moment[k])) / (unit * radius)};
      const double error = tolerance_error(settled, law->evaluate(cors[k]).wrench, m0);
      result.max = std::fmax(result.max, error);
      result.mean += error / static_cast<double>(count * stiffness_ratios.size());
    }
  }
  return result;
}

/// Input of one step.
struct Sample {
  Contact contact;
  double twist;
};

/// Slides and twists so that the centre of rotation moves slowly over the whole range: every step slips. The contacts
/// are prepared before the timing.
std::vector<Sample> slow_motion(std::size_t count) {
  std::vector<Sample> samples;
  double x = 0.0;
  double twist = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double u =
        0.5 - 0.45 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count));
    x += 1e-4 * (1.0 - u);
    twist += 1e-4 * u / radius;
    samples.push_back({{{x, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), depth}, twist});
  }
  return samples;
}
const std::vector<Sample> motion = slow_motion(4096);

/// A finger that runs the motion step by step; `cold` forgets the position of the last slip (no warm start), but not
/// that it slipped.
class Stepper {
 public:
  Stepper(const FingerCurve& curve, Projection projection, bool cold)
      : finger_(curve, parameters(2.0, curve.moment_ratio()), projection), cold_(cold) {
    finger_.update({Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), depth}, 0.0);
  }

  double step() {
    if (cold_) finger_.forget_warm_start();
    const Sample& sample = motion[next_];
    if (++next_ == motion.size()) next_ = 0;
    return finger_.update(sample.contact, sample.twist).moment;
  }

 private:
  SoftFinger finger_;
  bool cold_;
  std::size_t next_ = 0;
};

benchmark::Counter seconds_of(std::size_t steps) {
  return {static_cast<double>(steps), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert};
}

void set(benchmark::State& state, const SteadyError& error) {
  state.counters["max_error"] = error.max;
  state.counters["mean_error"] = error.mean;
}

void step_one(benchmark::State& state, const FingerCurve& curve, Projection projection, bool cold,
              const SteadyError& error) {
  Stepper stepper(curve, projection, cold);
  for (auto _ : state) benchmark::DoNotOptimize(stepper.step());
  set(state, error);
  state.counters["seconds"] = seconds_of(1);
}

/// Sixteen fingers in turn, as in a scene with many fingers: no step waits for the last one of the same finger.
void step_many(benchmark::State& state, const FingerCurve& curve, Projection projection, bool cold) {
  std::vector<Stepper> many(16, Stepper(curve, projection, cold));
  for (auto _ : state) {
    for (Stepper& one : many) benchmark::DoNotOptimize(one.step());
  }
  state.counters["seconds"] = seconds_of(many.size());
}

/// Contacts whose fingers move to and fro by more than the largest deflection, so that all of them slip in every step.
/// Only the step is timed: moving to and fro is an exchange of arrays.
template <class Real>
void step_batch(benchmark::State& state, const BasicFingerCurve<Real>& curve, Projection projection,
                const SteadyError& error) {
  constexpr std::size_t count = 1024;
  const BasicBatch<Real> batch(curve, parameters(2.0, curve.moment_ratio()), projection);
  BasicContactArrays<Real> arrays(count);
  std::vector<Real> back(count);
  for (std::size_t i = 0; i < count; ++i) {
    arrays.x()[i] = Real(0.004);
    arrays.depth()[i] = static_cast<Real>(depth);
    // Not all alike.
    arrays.twist()[i] = Real(0.4) + Real(1e-3) * static_cast<Real>(i % 64);
    back[i] = -arrays.twist()[i];
  }
  BasicContactBatch<Real> contacts = arrays.batch();
  std::span<const Real> other_angle = back;
  const auto turn_round_and_step = [&] {
    std::swap(contacts.x, contacts.y);
    std::swap(contacts.twist, other_angle);
    batch.step(contacts);
  };
  // The first contact and the first slips take longer.
  for (int i = 0; i < 12; ++i) turn_round_and_step();
  for (auto _ : state) {
    turn_round_and_step();
    benchmark::ClobberMemory();
  }
  state.counters["seconds"] = seconds_of(count);
  set(state, error);
}

}  // namespace

void register_steps() {
  const Law law = hertz();
  const auto add_batch = [&]<class Real>(const std::string& name, const BasicFingerCurve<Real>& curve,
                                         Projection projection) {
    const SteadyError error = steady_error(law, curve, projection);
    benchmark::RegisterBenchmark(name.c_str(),
                                 [=](benchmark::State& state) { step_batch<Real>(state, curve, projection, error); })
        ->MinTime(0.01)
        ->Repetitions(9);
  };
  const auto add = [&](const std::string& curve_name, const FingerCurve& curve, Projection projection) {
    const std::string name = curve_name + '/' + std::string(to_string(projection));
    const SteadyError error = steady_error(law, curve, projection);
    for (const bool cold : {false, true}) {
      const std::string start = cold ? "/cold" : "/warm";
      benchmark::RegisterBenchmark(("step/" + name + start).c_str(),
                                   [=](benchmark::State& state) { step_one(state, curve, projection, cold, error); })
          ->MinTime(0.01)
          ->Repetitions(5);
      benchmark::RegisterBenchmark(("many/" + name + start).c_str(),
                                   [=](benchmark::State& state) { step_many(state, curve, projection, cold); })
          ->MinTime(0.01)
          ->Repetitions(9);
    }
    add_batch("batch/" + name, curve, projection);
  };
  const auto add_both = [&](const std::string& name, const FingerCurve& curve) {
    add(name, curve, Projection::radial);
    add(name, curve, Projection::closest_point);
  };
  add("box", box(1.0, law->moment_ratio()), Projection::closest_point);
  const Ellipse ellipse = Ellipse::through_intercepts(law->moment_ratio());
  add_both("ellipse", ellipse);
  for (const int digits : {2, 4, 6, 8, 10, 14}) {
    add_both("table 1e-" + std::to_string(digits), Table::build(law, std::pow(10.0, -digits)));
  }
  add_batch("batch/float ellipse/radial", BasicFingerCurve<float>(ellipse), Projection::radial);
  for (const int digits : {2, 4, 6}) {
    const BasicFingerCurve<float> curve(FloatTable::build(law, std::pow(10.0, -digits)));
    add_batch("batch/float table 1e-" + std::to_string(digits) + "/closest-point", curve, Projection::closest_point);
  }
}

}  // namespace limitcurve::bench
