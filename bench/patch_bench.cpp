// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"
#include "limitcurve/patch.hpp"
#include "limitcurve/table.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

/// Time of a wrench of a contact that is not round, and of a disc by its table, in the same run: compare within one run.
namespace limitcurve::bench {
namespace {

constexpr std::size_t count = 1024;

/// CORs in random order, in all directions, from `near` to `far` radii, evenly in the logarithm.
std::vector<PatchTwist> twists(double radius, double near, double far) {
  std::vector<PatchTwist> made;
  double u = 0.5;
  double v = 0.5;
  for (std::size_t i = 0; i < count; ++i) {
    u = std::fmod(u + 0.6180339887498949, 1.0);
    v = std::fmod(v + 0.7548776662466927, 1.0);
    const double distance = radius * near * std::pow(far / near, u);
    made.push_back({distance * std::cos(2.0 * std::numbers::pi * v), distance * std::sin(2.0 * std::numbers::pi * v), 1.0});
  }
  return made;
}

void report(benchmark::State& state) {
  state.counters["per_call"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void add(const std::string& name, const Patch& patch, double near, double far) {
  benchmark::RegisterBenchmark(name.c_str(), [patch, near, far](benchmark::State& state) {
    const std::vector<PatchTwist> all = twists(patch.radius(), near, far);
    for (auto _ : state) {
      double sum = 0.0;
      for (const PatchTwist& twist : all) sum += patch.evaluate(twist).wrench.moment;
      benchmark::DoNotOptimize(sum);
    }
    report(state);
  });
}

void add_table() {
  benchmark::RegisterBenchmark("disc by its table", [table = Table::build(hertz(), 1e-8)](benchmark::State& state) {
    std::vector<SlipTwist> all;
    for (const PatchTwist& twist : twists(1.0, 0.01, 100.0)) all.push_back({std::hypot(twist.vx, twist.vy), 1.0});
    for (auto _ : state) {
      double sum = 0.0;
      for (const SlipTwist& twist : all) sum += table.wrench(twist).moment;
      benchmark::DoNotOptimize(sum);
    }
    report(state);
  });
}

}  // namespace
}  // namespace limitcurve::bench

int main(int argc, char** argv) {
  using namespace limitcurve;
  using bench::add;
  bench::add_table();
  const std::vector<PatchLoad> tripod{{-0.04, -0.04, 1}, {0.04, -0.02, 2}, {-0.04, 0.08, 1}};
  add("3 points", Patch::points(tripod), 0.01, 100.0);
  const Patch rectangle = Patch::rectangle(0.02, 0.01);
  add("rectangle, COR within 3 radii", rectangle, 0.01, 3.0);
  add("rectangle, COR beyond", rectangle, 3.0, 1000.0);
  const Patch ellipse = Patch::ellipse(hertz(), 0.008, 0.004);
  add("elliptic hertz 2:1, COR inside", ellipse, 0.01, 0.5);
  add("elliptic hertz 2:1, COR outside", ellipse, 1.01, 100.0);
  add("elliptic hertz 20:1, COR outside", Patch::ellipse(hertz(), 0.02, 0.001), 1.01, 100.0);
  const Patch uniform_ellipse = Patch::ellipse(uniform(), 0.008, 0.004);
  add("elliptic uniform 2:1, COR inside", uniform_ellipse, 0.01, 0.5);
  add("elliptic uniform 2:1, COR outside", uniform_ellipse, 1.01, 100.0);
  std::vector<double> pressures;
  for (int i = 0; i < 64 * 64; ++i) pressures.push_back(1.0 + i % 7);
  add("image 64 x 64", Patch::image(pressures, 64, 1e-3), 0.01, 100.0);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
