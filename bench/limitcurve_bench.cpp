// SPDX-License-Identifier: MIT
#include "bench/worst.hpp"

#include "limitcurve/closed_form.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/quartic.hpp"
#include "limitcurve/superellipse.hpp"
#include "limitcurve/table.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

/// What a friction wrench costs: closed forms, quadrature, tables, ellipse. Compare within one run; machines differ.
namespace limitcurve::bench {
namespace {

/// CORs without order, so that no branch predictor learns them: evenly spread in the spin fraction over `from` … `to`.
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

template <UnitForces<double> (*form)(double) noexcept>
void closed(benchmark::State& state, double from, double to) {
  over(state, spin_fractions(from, to), [](double u) {
    const UnitForces<double> forces = form((1.0 - u) / u);
    return forces.force + forces.moment;
  });
}

template <class Boundary>
void lookup(benchmark::State& state, const Boundary& boundary) {
  over(state, spin_fractions(0.0, 1.0), [&](double u) {
    const UnitWrench wrench = boundary.wrench(SlipTwist::of_spin_fraction(u));
    return wrench.force + wrench.moment;
  });
}

template <class Boundary>
void gauge(benchmark::State& state, const Boundary& boundary) {
  over(state, spin_fractions(0.0, 1.0), [&](double u) { return boundary.gauge({1.0 - u, u}); });
}

template <class Boundary>
void register_model(const std::string& name, const Boundary& boundary) {
  benchmark::RegisterBenchmark(name.c_str(), [boundary](benchmark::State& state) { lookup(state, boundary); });
  benchmark::RegisterBenchmark((name + "-gauge").c_str(), [boundary](benchmark::State& state) { gauge(state, boundary); });
}

void register_all() {
  benchmark::RegisterBenchmark("closed/hertz/inside", closed<closed_form::hertz<double>>, 0.5, 1.0);
  benchmark::RegisterBenchmark("closed/hertz/outside", closed<closed_form::hertz<double>>, 0.0, 0.5);
  benchmark::RegisterBenchmark("closed/uniform", closed<closed_form::uniform<double>>, 0.0, 1.0);
  benchmark::RegisterBenchmark("closed/parabolic", closed<closed_form::parabolic<double>>, 0.0, 1.0);
  benchmark::RegisterBenchmark("closed/flat-punch", closed<closed_form::flat_punch<double>>, 0.0, 1.0);
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
  register_model("superellipse", Superellipse(1.0, 0.589, 1.725));
  register_model("quartic", Quartic(1.0, 0.589, 3.142));
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
