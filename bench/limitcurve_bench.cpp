// SPDX-License-Identifier: MIT
#include "bench/worst.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/quadrature/closed_form.hpp"
#include "limitcurve/quadrature/evaluators.hpp"
#include "limitcurve/table.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

/// Time of a friction wrench: closed forms, quadrature, tables, ellipse. Compare within one run; machines differ.
namespace limitcurve::bench {
namespace {

/// CORs in random order, so that no branch predictor learns them: evenly spaced in the spin fraction over `from` … `to`.
std::vector<double> spin_fractions(double from, double to) {
  constexpr std::size_t count = 1024;
  std::vector<double> result;
  double u = 0.5;
  for (std::size_t i = 0; i < count; ++i) {
    u += 0.6180339887498949;
    u -= std::floor(u);
    result.push_back(from + (to - from) * u);
  }
  return result;
}

template <class Call>
void over(benchmark::State& state, const std::vector<double>& fractions, Call&& call) {
  for (auto _ : state) {
    double sum = 0.0;
    for (const double u : fractions) sum += call(u);
    benchmark::DoNotOptimize(sum);
  }
  const auto count = static_cast<double>(fractions.size());
  state.counters["per_call"] = benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["worst_ns"] = worst_nanoseconds(fractions, call);
}

/// CORs by region: under the finger, at the rim on both sides down to one rounding, outside.
std::vector<double> cors(const std::string& region) {
  std::vector<double> result;
  if (region == "rim") {
    for (const double u : spin_fractions(0.0, 2.0)) {
      result.push_back(u < 1.0 ? 1.0 - std::pow(10.0, -1.0 - 15.0 * u) : 1.0 + std::pow(10.0, -1.0 - 15.0 * (u - 1.0)));
    }
    return result;
  }
  for (const double u : region == "inside" ? spin_fractions(0.5, 1.0) : spin_fractions(1e-6, 0.5)) result.push_back((1.0 - u) / u);
  return result;
}

/// The least time of a call [ns], over passes through all inputs.
template <class Inputs, class Call>
double best_nanoseconds(const Inputs& inputs, int passes, Call&& call) {
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < passes; ++pass) {
    const auto start = Clock::now();
    for (const double s : inputs) {
      const UnitWrench wrench = call(s);
      benchmark::DoNotOptimize(wrench.force + wrench.moment);
    }
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
  return best / static_cast<double>(inputs.size());
}

/// The largest relative error of f and m, against the law's `evaluate`.
template <class Inputs, class Call>
double largest_error(const PressureLaw& law, const Inputs& inputs, Call&& call) {
  double error = 0.0;
  for (const double s : inputs) {
    const UnitWrench found = call(s);
    const UnitWrench truth = law.evaluate(s).wrench;
    error = std::max({error, std::fabs(found.force / truth.force - 1.0), std::fabs(found.moment / truth.moment - 1.0)});
  }
  return error;
}

/// The pair (f, m) by `ours`, with its error, and the time of Boost's quadrature at the same CORs, divided by ours.
template <class Ours>
void pair(benchmark::State& state, const Law& law, const std::string& region, const Ours& ours) {
  const std::vector<double> all = cors(region);
  for (auto _ : state) {
    double sum = 0.0;
    for (const double s : all) {
      const UnitWrench wrench = ours(s);
      sum += wrench.force + wrench.moment;
    }
    benchmark::DoNotOptimize(sum);
  }
  const std::vector<double> some(all.begin(), all.begin() + 128);
  const auto theirs = [&](double s) {
    // To the tolerance that is Boost's own default, at which its error is one of rounding.
    const UnitForces<double> forces = evaluators::boost(*law, s, Slope::unwanted, std::sqrt(std::numeric_limits<double>::epsilon())).forces;
    return UnitWrench{forces.force, forces.moment};
  };
  const double peer = best_nanoseconds(some, 5, theirs);
  const auto count = static_cast<double>(all.size());
  state.counters["per_call"] = benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["worst_ns"] = worst_nanoseconds(all, ours);
  state.counters["error"] = largest_error(*law, some, ours);
  state.counters["boost_ns"] = peer;
  state.counters["boost_error"] = largest_error(*law, some, theirs);
  state.counters["times_faster"] = peer / best_nanoseconds(all, 200, ours);
}

template <UnitForces<double> (*form)(double) noexcept>
UnitWrench wrench_of(double s) noexcept {
  const UnitForces<double> forces = form(s);
  return {forces.force, forces.moment};
}

template <class Ours>
void register_pair(const Law& law, const Ours& ours) {
  for (const char* region : {"inside", "rim", "outside"}) {
    benchmark::RegisterBenchmark(("pair/" + law->name() + "/" + region).c_str(),
                                 [law, region, ours](benchmark::State& state) { pair(state, law, region, ours); });
  }
}

/// The exact pair (f, m) beside Boost's quadrature.
void register_pairs() {
  // A lambda each, so that the form is inlined.
  register_pair(hertz(), [](double s) { return wrench_of<closed_form::hertz<double>>(s); });
  register_pair(flat_punch(), [](double s) { return wrench_of<closed_form::flat_punch<double>>(s); });
  register_pair(uniform(), [](double s) { return wrench_of<closed_form::uniform<double>>(s); });
  register_pair(parabolic(), [](double s) { return wrench_of<closed_form::parabolic<double>>(s); });
  for (const Law& law : {xydas_kao(3.0), limitcurve::power(2.3)}) {
    register_pair(law, [law](double s) {
      const UnitForces<double> forces = law->forces(s);
      return UnitWrench{forces.force, forces.moment};
    });
  }
}

template <class Curve>
void lookup(benchmark::State& state, const Curve& curve) {
  over(state, spin_fractions(0.0, 1.0), [&](double u) {
    const UnitWrench wrench = curve.wrench(SlipTwist::of_spin_fraction(u));
    return wrench.force + wrench.moment;
  });
}

template <class Curve>
void gauge(benchmark::State& state, const Curve& curve) {
  over(state, spin_fractions(0.0, 1.0), [&](double u) { return curve.gauge({1.0 - u, u}); });
}

template <class Curve>
void register_model(const std::string& name, const Curve& curve) {
  benchmark::RegisterBenchmark(name.c_str(), [curve](benchmark::State& state) { lookup(state, curve); });
  benchmark::RegisterBenchmark((name + "-gauge").c_str(), [curve](benchmark::State& state) { gauge(state, curve); });
}

void register_all() {
  register_pairs();
  for (const char* text : {"xydas-kao:k=3", "power:n=2.3"}) {
    const ExactCurve curve(parse_law(text));
    benchmark::RegisterBenchmark(("quadrature/" + std::string(text)).c_str(), [curve](benchmark::State& state) { lookup(state, curve); });
  }
  for (const char* text : {"hertz", "uniform", "flat-punch", "xydas-kao:k=3", "power:n=-0.9"}) {
    for (const double tolerance : {1e-4, 1e-8}) {
      const Table table = Table::build(parse_law(text), tolerance);
      const std::string name = std::string(text) + "/" + format_number(tolerance);
      benchmark::RegisterBenchmark(("table/" + name).c_str(), [table](benchmark::State& state) { lookup(state, table); });
      benchmark::RegisterBenchmark(("table-gauge/" + name).c_str(), [table](benchmark::State& state) { gauge(state, table); });
    }
  }
  register_model("box", box(1.0, 0.589));
  register_model("ellipse", Ellipse::through_intercepts(0.589));
}

}  // namespace
}  // namespace limitcurve::bench

int main(int argc, char** argv) {
  limitcurve::bench::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
