// SPDX-License-Identifier: MIT
#include "bench/work_precision_step.hpp"

#include "bench/contacts.hpp"
#include "bench/finger_motion.hpp"
#include "bench/way.hpp"

#include "godobject/godobject.hpp"
#include "limitcurve/boundary_error.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/float_table.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <array>
#include <vector>

namespace limitcurve::bench {
namespace {

using namespace limitcurve::godobject;
using godobject::bench::on_plane;
using godobject::bench::Sample;
using godobject::bench::slow_motion;

constexpr double radius = 0.005;
constexpr double depth = 0.002;

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

/// Error of the steady wrench over stiffness ratios k_r/k_l/(m₀a)² and CORs a decade to either side of 1.
template <class Boundary, class Projection>
SteadyError steady_error(const Law& law, const Boundary& boundary, Projection projection) {
  constexpr int steps = 1000;           // forgets the start to rounding
  constexpr double step_length = 1e-3;  // [m]
  const double m0 = law->moment_ratio();
  SteadyError result;
  int runs = 0;
  for (const double ratio : {0.1, 0.3, 1.0, 3.0, 10.0}) {
    for (const double s : {0.1, 0.3, 1.0, 3.0, 10.0}) {
      SoftFinger finger(boundary, parameters(ratio, m0), projection);
      const SlipTwist twist = SlipTwist::about_cor(s);
      for (int i = 0; i <= steps; ++i) {
        finger.update(on_plane(step_length * i * twist.slide, 0.0, depth), step_length * i * twist.spin / radius);
      }
      const double unit = finger.friction().law().mu() * finger.output().load;
      const UnitWrench settled{finger.output().force.norm() / unit, std::fabs(finger.output().moment) / (unit * radius)};
      const double error = distance(settled, law->evaluate(s).wrench, m0);
      result.max = std::fmax(result.max, error);
      result.mean += error;
      ++runs;
    }
  }
  result.mean /= runs;
  return result;
}

/// The same of a batch of floats, one contact for each COR. Positions are told from where the fingers are: a float resolves no
/// stride of a millimetre a metre away.
template <class Boundary, class Projection>
SteadyError steady_error_of_floats(const Law& law, const Boundary& boundary, Projection projection) {
  constexpr int steps = 1000;
  constexpr double step_length = 1e-3;
  const std::array<double, 5> cors{0.1, 0.3, 1.0, 3.0, 10.0};
  const double m0 = law->moment_ratio();
  SteadyError result;
  for (const double ratio : {0.1, 0.3, 1.0, 3.0, 10.0}) {
    const Friction<Boundary, Projection> friction(boundary, parameters(ratio, m0), projection);
    std::array<float, cors.size()> x{}, y{}, angle{}, depths{}, proxy_x{}, proxy_y{}, proxy_angle{}, start{}, trend{}, force_x{}, force_y{},
        moment{};
    depths.fill(static_cast<float>(depth));
    start.fill(-2.0F);
    const FloatContactBatch batch{x, y, angle, depths, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment};
    step(friction, batch);
    for (int i = 0; i < steps; ++i) {
      for (std::size_t k = 0; k < cors.size(); ++k) {
        const SlipTwist twist = SlipTwist::about_cor(cors[k]);
        proxy_x[k] -= static_cast<float>(step_length * twist.slide);
        proxy_angle[k] -= static_cast<float>(step_length * twist.spin / radius);
      }
      step(friction, batch);
    }
    for (std::size_t k = 0; k < cors.size(); ++k) {
      const double unit = friction.law().mu() * friction.law().stiffness() * depth;
      const UnitWrench settled{std::hypot(static_cast<double>(force_x[k]), static_cast<double>(force_y[k])) / unit,
                               std::fabs(static_cast<double>(moment[k])) / (unit * radius)};
      const double error = distance(settled, law->evaluate(cors[k]).wrench, m0);
      result.max = std::fmax(result.max, error);
      result.mean += error / 25.0;
    }
  }
  return result;
}

/// What the fingers take, one after another. Contacts ready to be used: making them is not in the time of a step.
const std::vector<Sample> motion = slow_motion(4096);

/// A finger that takes the motion's steps one by one; `cold` forgets where the last slip was, but not that it slipped.
template <class Boundary, class Projection>
class Stepper {
 public:
  Stepper(const Boundary& boundary, const FingerParameters& of_finger, Projection projection, bool cold)
      : finger_(boundary, of_finger, projection), cold_(cold) {
    finger_.update(on_plane(0.0, 0.0, depth), 0.0);
  }

  double step() {
    const Sample& sample = motion[next_];
    if (++next_ == motion.size()) next_ = 0;
    return take(sample);
  }

  /// One step of any motion, and nothing else.
  [[gnu::noinline]] double take(const Sample& sample) {
    if (cold_) finger_.forget_place();
    return finger_.update(sample.contact, sample.twist).moment;
  }

 private:
  SoftFinger<Boundary, Projection> finger_;
  bool cold_;
  std::size_t next_ = 0;
};

template <class Boundary, class Projection>
void add_step(const Law& law, const std::string& boundary_name, const Boundary& boundary, const std::string& rule, Projection projection) {
  const auto error = std::make_shared<SteadyError>();
  for (const bool cold : {false, true}) {
    const FingerParameters of_finger = parameters(2.0, law->moment_ratio());
    const auto time = [=](benchmark::State& state) {
      Stepper stepper(boundary, of_finger, projection, cold);
      for (auto _ : state) benchmark::DoNotOptimize(stepper.step());
      if (error->mean == 0.0) *error = steady_error(law, boundary, projection);
      state.counters["seconds"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
      state.counters["max_error"] = error->max;
      state.counters["mean_error"] = error->mean;
      const CostOverInputs cost = cost_over(
          spread(1023), [&](double) { return stepper.step(); }, 1e3);
      state.counters["median_ns"] = cost.median;
      state.counters["worst_ns"] = cost.worst;
    };
    const auto counted = std::make_shared<Stepper<Boundary, Projection>>(boundary, of_finger, projection, cold);
    const auto run = [counted](std::size_t calls) {
      for (std::size_t i = 0; i < calls; ++i) benchmark::DoNotOptimize(counted->step());
    };
    ways().push_back({"step/" + boundary_name + '/' + rule + '/' + (cold ? "cold" : "warm"), time, run, 50.0});
  }
}

/// Sixteen fingers in turn, one call a step, as in a scene of many: no step waits for the last of the same finger.
template <class Boundary, class Projection>
void step_many(benchmark::State& state, const Boundary& boundary, Projection projection, double moment_ratio, bool cold) {
  constexpr std::size_t fingers = 16;
  std::vector<Stepper<Boundary, Projection>> many(fingers, Stepper(boundary, parameters(2.0, moment_ratio), projection, cold));
  std::size_t next = 0;
  for (auto _ : state) {
    for (auto& one : many) benchmark::DoNotOptimize(one.take(motion[next]));
    if (++next == motion.size()) next = 0;
  }
  state.counters["seconds"] =
      benchmark::Counter(static_cast<double>(fingers), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Real, class Boundary, class Projection>
void step_batch(benchmark::State& state, const Boundary& boundary, Projection projection, double moment_ratio) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Friction<Boundary, Projection> friction(boundary, parameters(2.0, moment_ratio), projection);
  godobject::bench::Contacts<Real> contacts(count, depth);
  contacts.settle(friction);
  for (auto _ : state) {
    contacts.turn_round();
    step(friction, contacts.batch());
    benchmark::ClobberMemory();
  }
  state.SetComplexityN(state.range(0));
  state.counters["seconds"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Boundary, class Projection>
void step_floats(benchmark::State& state, const Law& law, const Boundary& boundary, Projection projection, const SteadyError& error) {
  step_batch<float>(state, boundary, projection, law->moment_ratio());
  state.counters["max_error"] = error.max;
  state.counters["mean_error"] = error.mean;
}

/// Calls `body(name, boundary)` for the boundaries of the chart of steps, all of one law.
template <class Body>
void for_each_boundary(const Law& law, Body&& body) {
  const ExactCurve exact(law);
  const double m0 = law->moment_ratio();
  body("box", box(1.0, m0));
  body("diamond", diamond(1.0, m0));
  body("ellipse", Ellipse::through_intercepts(m0));
  body("superellipse", minimax_superellipse(exact));
  body("quartic", minimax_quartic(exact));
  for (const int digits : {2, 4, 6, 8, 10}) body("table 1e-" + std::to_string(digits), Table::build(law, std::pow(10.0, -digits)));
  body("exact", exact);
}

}  // namespace

void add_steps() {
  const Law law = hertz();
  for_each_boundary(law, [&](const std::string& name, const auto& boundary) {
    add_step(law, name, boundary, "radial", Radial{});
    add_step(law, name, boundary, "c-curve", CCurve{});
    add_step(law, name, boundary, "closest-point", ClosestPoint{});
  });
}

void register_batches() {
  const Law law = hertz();
  const double m0 = law->moment_ratio();
  const auto add = [&](const std::string& name, const auto& boundary, auto projection) {
    return benchmark::RegisterBenchmark(name.c_str(),
                                        [=](benchmark::State& state) { step_batch<double>(state, boundary, projection, m0); });
  };
  const auto add_floats = [&](const std::string& name, const auto& boundary, auto projection) {
    const SteadyError error = steady_error_of_floats(law, boundary, projection);
    return benchmark::RegisterBenchmark(name.c_str(),
                                        [=](benchmark::State& state) { step_floats(state, law, boundary, projection, error); });
  };
  const auto of_sizes = [](benchmark::internal::Benchmark* batches) {
    batches->MinTime(0.01)->Repetitions(3);
    for (const int size : {1, 4, 64, 1024, 65536}) batches->Arg(size);
  };
  for_each_boundary(law, [&](const std::string& name, const auto& boundary) {
    of_sizes(add("batch/" + name + "/radial", boundary, Radial{}));
    of_sizes(add("batch/" + name + "/c-curve", boundary, CCurve{}));
    of_sizes(add("batch/" + name + "/closest-point", boundary, ClosestPoint{}));
  });
  const auto add_many = [&](const std::string& name, const auto& boundary, auto projection) {
    for (const bool cold : {false, true}) {
      benchmark::RegisterBenchmark(("many/" + name + (cold ? "/cold" : "/warm")).c_str(),
                                   [=](benchmark::State& state) { step_many(state, boundary, projection, m0, cold); })
          ->MinTime(0.01)
          ->Repetitions(3);
    }
  };
  for_each_boundary(law, [&](const std::string& name, const auto& boundary) {
    add_many(name + "/radial", boundary, Radial{});
    add_many(name + "/c-curve", boundary, CCurve{});
    add_many(name + "/closest-point", boundary, ClosestPoint{});
  });
  const Ellipse ellipse = Ellipse::through_intercepts(m0);
  of_sizes(add_floats("batch/float ellipse/radial", ellipse, Radial{}));
  for (const int digits : {2, 4, 6}) {
    of_sizes(add_floats("batch/float table 1e-" + std::to_string(digits) + "/closest-point",
                        FloatTable::build(law, std::pow(10.0, -digits)), ClosestPoint{}));
  }
  constexpr int most = 10'000'000;
  const auto to_ten_million = [](benchmark::internal::Benchmark* batches) {
    batches->RangeMultiplier(10)->Range(1000, most)->MinTime(0.05)->Complexity(benchmark::oN);
  };
  to_ten_million(add("scale/ellipse/radial", ellipse, Radial{}));
  to_ten_million(add("scale/table 1e-6/closest-point", Table::build(law, 1e-6), ClosestPoint{}));
  to_ten_million(add_floats("scale/float table 1e-6/closest-point", FloatTable::build(law, 1e-6), ClosestPoint{}));
}

}  // namespace limitcurve::bench
