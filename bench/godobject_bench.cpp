// SPDX-License-Identifier: MIT
// A step of the god-object on the plane, boundary by projection. Mean by Google Benchmark; `worst_ns` is the slowest single
// step of a second pass, each timed on its own (clock included; the operating system may be in it). `many/` steps sixteen fingers in
// turn: `a_step` is what one takes where it need not wait for itself.
#include "bench/contacts.hpp"
#include "bench/finger_motion.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace limitcurve;
using namespace limitcurve::godobject;
using bench::on_plane;
using bench::parameters;
using bench::Sample;
using bench::slow_motion;

constexpr std::size_t count = 4096;

/// Jumps of millimetres and tenths of radians in all directions, under a load that changes too: hardly a step sticks.
std::vector<Sample> wild() {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.push_back({on_plane(0.01 * share(engine), 0.01 * share(engine), 0.002 + 0.001 * share(engine)), 2.0 * share(engine)});
  }
  return samples;
}

/// Trembles within the limit.
std::vector<Sample> held() {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < count; ++i) {
    samples.push_back({on_plane(2e-4 * share(engine), 2e-4 * share(engine), 0.002), 0.02 * share(engine)});
  }
  return samples;
}

/// The step that is timed, in the mean and for the worst: one copy of it for both.
template <class Finger>
[[gnu::noinline]] const FingerOutput& take_step(Finger& finger, const Sample& sample, bool cold) {
  if (cold) finger.forget_place();
  return finger.update(sample.contact, sample.twist);
}

template <class Boundary, class Projection>
void step(benchmark::State& state, const Boundary& boundary, Projection projection, const std::vector<Sample>& samples, bool cold) {
  SoftFinger finger(boundary, parameters(), projection);
  finger.update(on_plane(0.0, 0.0, 0.002), 0.0);
  const auto advance = [&](const Sample& sample) -> const FingerOutput& { return take_step(finger, sample, cold); };
  std::size_t i = 0;
  for (auto _ : state) {
    const FingerOutput& output = advance(samples[i]);
    benchmark::DoNotOptimize(output.moment);
    if (++i == samples.size()) i = 0;
  }
  using Clock = std::chrono::steady_clock;
  double worst = 0.0;
  std::size_t slips = 0;
  for (const Sample& sample : samples) {
    const auto start = Clock::now();
    const FingerOutput& output = advance(sample);
    benchmark::DoNotOptimize(output.moment);
    worst = std::max(worst, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
    slips += output.state == ContactState::slip;
  }
  state.counters["worst_ns"] = worst;
  state.counters["slips"] = static_cast<double>(slips) / static_cast<double>(samples.size());
}

/// Sixteen fingers in turn: one step need not wait for the last of the same finger, as in a scene of many.
template <class Boundary, class Projection>
void steps_of_many(benchmark::State& state, const Boundary& boundary, Projection projection, const std::vector<Sample>& samples,
                   bool cold) {
  constexpr std::size_t fingers = 16;
  const SoftFinger finger(boundary, parameters(), projection);
  std::vector<SoftFinger<Boundary, Projection>> many(fingers, finger);
  for (auto& one : many) one.update(on_plane(0.0, 0.0, 0.002), 0.0);
  std::size_t i = 0;
  for (auto _ : state) {
    for (auto& one : many) benchmark::DoNotOptimize(take_step(one, samples[i], cold).moment);
    if (++i == samples.size()) i = 0;
  }
  state.counters["a_step"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(fingers),
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// One call for many contacts, in doubles or floats; every one slips.
template <class Real, class Boundary, class Projection>
void step_of_batch(benchmark::State& state, const Boundary& boundary, Projection projection) {
  const auto contacts = static_cast<std::size_t>(state.range(0));
  const Friction<Boundary, Projection> friction(boundary, parameters(), projection);
  bench::Contacts<Real> arrays(contacts, 0.002);
  arrays.settle(friction);
  for (auto _ : state) {
    arrays.turn_round();
    step(friction, arrays.batch());
    benchmark::ClobberMemory();
  }
  state.counters["a_contact"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(contacts),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class Boundary>
void all_projections(const std::string& name, const Boundary& boundary) {
  static const std::vector<std::pair<std::string, std::vector<Sample>>> motions{
      {"slow", slow_motion(count)}, {"wild", wild()}, {"held", held()}};
  for (const auto& [motion, samples] : motions) {
    const auto add = [&, &motion_of = motion, &samples_of = samples](const std::string& rule, auto projection, bool cold) {
      benchmark::RegisterBenchmark(("step/" + name + "/" + rule + "/" + motion_of).c_str(),
                                   [=, &samples_of](benchmark::State& state) { step(state, boundary, projection, samples_of, cold); });
    };
    const auto add_many = [&, &motion_of = motion, &samples_of = samples](const std::string& rule, auto projection, bool cold) {
      benchmark::RegisterBenchmark(("many/" + name + "/" + rule + "/" + motion_of).c_str(), [=, &samples_of](benchmark::State& state) {
        steps_of_many(state, boundary, projection, samples_of, cold);
      });
    };
    if (&samples == &motions.front().second) {
      const auto add_batch = [&](const std::string& rule, auto projection) {
        benchmark::RegisterBenchmark(("batch/" + name + "/" + rule).c_str(),
                                     [=](benchmark::State& state) { step_of_batch<double>(state, boundary, projection); })
            ->Arg(1)
            ->Arg(4)
            ->Arg(64)
            ->Arg(1024)
            ->Arg(65536);
      };
      add_batch("radial", Radial{});
      add_batch("closest-point", ClosestPoint{});
    }
    const auto add_three = [&](const auto& add_one) {
      add_one("radial", Radial{}, false);
      add_one("closest-point-warm", ClosestPoint{}, false);
      add_one("closest-point-cold", ClosestPoint{}, true);
    };
    add_three(add_many);
    add_three(add);
    add("c-curve", CCurve{}, false);
  }
}

const bool registered = [] {
  const Law law = hertz();
  all_projections("ellipse", Ellipse::through_intercepts(law->moment_ratio()));
  all_projections("table-1e-8", Table::build(law, 1e-8));
  all_projections("exact-hertz", ExactCurve(law));
  all_projections("superellipse", Superellipse::through_intercepts(law->moment_ratio(), 1.725));
  all_projections("quartic", Quartic::through_intercepts(law->moment_ratio(), 3.142));
  all_projections("box", box(1.0, law->moment_ratio()));
  const auto add_floats = [](const char* name, const auto& boundary, auto projection) {
    auto* const batches =
        benchmark::RegisterBenchmark(name, [=](benchmark::State& state) { step_of_batch<float>(state, boundary, projection); });
    for (const int size : {1, 4, 64, 1024, 65536}) batches->Arg(size);
  };
  add_floats("floats/ellipse/radial", Ellipse::through_intercepts(law->moment_ratio()), Radial{});
  add_floats("floats/float-table-1e-6/closest-point", FloatTable::build(law, 1e-6), ClosestPoint{});
  return true;
}();

}  // namespace
