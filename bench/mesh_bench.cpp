// SPDX-License-Identifier: MIT
// A step of a finger on a ball of triangles, contact and friction together: `worst` is the slowest of 4096 steps, each with the fastest
// of nine runs, so that interrupts do not count (includes 20 ns of the clock).
#include "godobject/mesh/mesh.hpp"
#include "tests/mesh/shapes.hpp"
#include "tests/touch.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

namespace {

using namespace limitcurve;
using namespace limitcurve::godobject;
using Eigen::Vector3d;

constexpr double radius = 0.05;
constexpr std::size_t count = 4096;

/// Along the surface at a depth of 2 mm, 0.2 mm a step: 0.2 m/s at 1 kHz.
std::vector<Vector3d> sliding() {
  test::Random random(1);
  std::vector<Vector3d> result;
  Vector3d direction = Vector3d::UnitX();
  for (std::size_t i = 0; i < count; ++i) {
    direction = (direction + 0.004 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1))).normalized();
    result.push_back((radius - 0.002) * direction);
  }
  return result;
}

/// The same, 2 mm above it.
std::vector<Vector3d> hovering() {
  std::vector<Vector3d> result = sliding();
  for (Vector3d& finger : result) finger *= (radius + 0.002) / (radius - 0.002);
  return result;
}

/// Anywhere within 7 cm from one step to the next.
std::vector<Vector3d> leaping() {
  test::Random random(2);
  std::vector<Vector3d> result;
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back({random.uniform(-0.07, 0.07), random.uniform(-0.07, 0.07), random.uniform(-0.07, 0.07)});
  }
  return result;
}

void step(benchmark::State& state, const MeshSurface& surface, const std::vector<Vector3d>& path) {
  SoftFinger finger = test::hertz_finger();
  ContactMemory memory;
  const auto advance = [&](std::size_t i) { return finger.update(touch(surface, path[i], memory), 0.0).load; };
  for (auto _ : state) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i) sum += advance(i);
    benchmark::DoNotOptimize(sum);
  }
  std::vector<double> fastest(count, 1e300);
  for (int run = 0; run < 9; ++run) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto start = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(advance(i));
      fastest[i] = std::min(fastest[i], std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
    }
  }
  state.counters["mean_ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(count) * 1e-9,
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["worst_ns"] = *std::max_element(fastest.begin(), fastest.end());
}

const bool registered = [] {
  for (const auto& [name, times] : {std::pair<std::string, int>{"2k", 4}, {"131k", 7}}) {
    const MeshSurface surface{Mesh(test::ball_triangles(radius, times))};
    for (const auto& [motion, path] :
         {std::pair<std::string, std::vector<Vector3d>>{"sliding", sliding()}, {"hovering", hovering()}, {"leaping", leaping()}}) {
      benchmark::RegisterBenchmark((name + "/" + motion).c_str(),
                                   [surface, path = path](benchmark::State& state) { step(state, surface, path); });
    }
  }
  benchmark::RegisterBenchmark("build/131k", [](benchmark::State& state) {
    const TriangleList list = test::ball_triangles(radius, 7);
    for (auto _ : state) benchmark::DoNotOptimize(Mesh(list).volume());
  })->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
