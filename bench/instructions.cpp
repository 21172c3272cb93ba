// SPDX-License-Identifier: MIT
// The calls of a servo loop, for valgrind to count their instructions: a number that a noisy machine cannot spoil. Run by
// scripts/instruction_counts, which compares it with bench/instruction_counts.csv; alone it prints its cases and no more.
#include "bench/finger_motion.hpp"
#include "godobject/batch.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/chord_table.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <valgrind/callgrind.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace limitcurve;
using namespace limitcurve::godobject;
using bench::on_plane;
using bench::parameters;
using bench::Sample;
using bench::slow_motion;

constexpr std::size_t count = 1024;

/// Evenly in [0, 1): Weyl's sequence of the golden ratio.
double share(std::size_t i) {
  return std::fmod(0.6180339887498949 * static_cast<double>(i + 1), 1.0);
}

/// Counts what `body` does, `calls` calls, under that name; once before to warm it up.
template <class Body>
void measure(const std::string& name, Body&& body) {
  body();
  CALLGRIND_ZERO_STATS;
  body();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  std::puts(name.c_str());
}

/// Keeps a result from being optimised away.
void keep(double value) {
  asm volatile("" : : "x"(value));
}

void measure_forces(const std::string& name, const Law& law, bool outside) {
  std::vector<double> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back(outside ? 1.0 / share(i) : share(i));
  measure(name, [&] {
    for (const double s : places) keep(law->forces(s).moment);
  });
}

void measure_table(const Table& table) {
  std::vector<SlipTwist> twists;
  std::vector<UnitWrench> wrenches;
  for (std::size_t i = 0; i < count; ++i) {
    twists.push_back(SlipTwist::of_spin_fraction(share(i)));
    wrenches.push_back({share(i), share(i + count)});
  }
  measure("table wrench", [&] {
    for (const SlipTwist twist : twists) keep(table.wrench(twist).moment);
  });
  const ChordTable chords(table, 1e-4);
  measure("chord table wrench", [&] {
    for (const SlipTwist twist : twists) keep(chords.wrench(twist).moment);
  });
  measure("table point", [&] {
    for (const SlipTwist twist : twists) keep(table.point(twist).slope.moment);
  });
  measure("table gauge", [&] {
    for (const UnitWrench wrench : wrenches) keep(table.gauge(wrench));
  });
}

/// A slip about a centre of rotation that wanders slowly; or leaps, of which hardly any sticks; or a trembling that sticks.
enum class Motion { slow, wild, held };

std::vector<Sample> samples(Motion motion) {
  if (motion == Motion::slow) return slow_motion(count);
  const double size = motion == Motion::wild ? 1.0 : 0.02;
  std::vector<Sample> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double one = 2.0 * share(i) - 1.0;
    const double other = 2.0 * share(i + 7 * count) - 1.0;
    const double third = 2.0 * share(i + 3 * count) - 1.0;
    result.push_back({on_plane(0.01 * size * one, 0.01 * size * other, 0.002 + 0.0005 * size * one), size * third});
  }
  return result;
}

template <class Boundary, class Projection>
void measure_step(const std::string& name, const Boundary& boundary, Projection projection, Motion motion,
                  const FingerParameters& with = parameters()) {
  SoftFinger finger(boundary, with, projection);
  const std::vector<Sample> all = samples(motion);
  measure(name, [&] {
    finger.reset();
    for (const Sample& sample : all) keep(finger.update(sample.contact, sample.twist).moment);
  });
}

/// What a projection takes of each trial, without what it remembers of the last.
template <class Boundary, class Projection>
void measure_cold(const std::string& name, const Boundary& boundary, Projection projection) {
  const SoftFinger finger(boundary, parameters(), projection);
  const std::vector<Sample> all = samples(Motion::wild);
  measure(name, [&] {
    for (const Sample& sample : all) {
      const double r = sample.contact.point.norm();
      keep(finger.friction().resolve(r, std::fabs(sample.twist), 1000.0 * sample.contact.depth, 0.0).moment);
    }
  });
}

template <class Boundary, class Projection>
void measure_batch(const std::string& name, const Boundary& boundary, Projection projection) {
  const Friction friction(boundary, parameters(), projection);
  std::array<std::vector<double>, 12> arrays;
  for (auto& array : arrays) array.assign(count, 0.0);
  auto& [x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment] = arrays;
  start.assign(count, -2.0);
  depth.assign(count, 0.002);
  ContactBatch batch{x, y, angle, depth, proxy_x, proxy_y, proxy_angle, start, trend, force_x, force_y, moment};
  step(friction, batch);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = 0.01 * share(i);
    angle[i] = share(i + count);
  }
  // Back and forth, so that most slip each time, and no sum grows.
  measure(name, [&] {
    std::swap(batch.x, batch.y);
    step(friction, batch);
  });
}

}  // namespace

int main() {
  measure_forces("forces hertz inside", hertz(), false);
  measure_forces("forces hertz outside", hertz(), true);
  measure_forces("forces uniform inside", uniform(), false);
  measure_forces("forces uniform outside", uniform(), true);
  measure_forces("forces xydas-kao:k=3 inside", xydas_kao(3.0), false);

  const double moment_ratio = hertz()->moment_ratio();
  const Table table = Table::build(hertz(), 1e-8);
  measure_table(table);

  const Ellipse ellipse = Ellipse::through_intercepts(moment_ratio);
  measure_step("step ellipse radial held", ellipse, Radial{}, Motion::held);
  measure_step("step ellipse radial wild", ellipse, Radial{}, Motion::wild);
  measure_step("step ellipse closest-point wild", ellipse, ClosestPoint{}, Motion::wild);
  measure_step("step table radial wild", table, Radial{}, Motion::wild);
  measure_step("step table closest-point held", table, ClosestPoint{}, Motion::held);
  measure_step("step table closest-point warm", table, ClosestPoint{}, Motion::slow);
  measure_step("step table closest-point wild", table, ClosestPoint{}, Motion::wild);
  measure_cold("resolve table closest-point cold", table, ClosestPoint{});
  measure_step("step box closest-point wild", box(1.0, moment_ratio), ClosestPoint{}, Motion::wild);
  measure_step("step exact closest-point warm", ExactCurve(hertz()), ClosestPoint{}, Motion::slow);
  FingerParameters soft = parameters();
  soft.radius_law = RadiusLaw::power(0.00207, 0.259);
  measure_step("step table c-curve power-radius", table, CCurve{}, Motion::wild, soft);
  measure_batch("batch ellipse radial", ellipse, Radial{});
  measure_batch("batch table closest-point", table, ClosestPoint{});
  return 0;
}
