// SPDX-License-Identifier: MIT
#include "limitcurve/choose.hpp"

#include "limitcurve/boundary_error.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/number.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/shipped_costs.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace limitcurve {

namespace {

/// Mean nanoseconds of `wrench` over slips of every kind; the least of a few rounds, for the others were disturbed.
template <LimitBoundary Boundary>
double measured_cost(const Boundary& boundary) {
  using Clock = std::chrono::steady_clock;
  constexpr int rounds = 5;
  constexpr int calls = 64;
  double least = std::numeric_limits<double>::infinity();
  volatile double sink = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) sink = boundary.wrench(SlipTwist::of_spin_fraction((i + 0.5) / calls)).force;
    least = std::min(least, std::chrono::duration<double, std::nano>(Clock::now() - start).count() / calls);
  }
  static_cast<void>(sink);
  return least;
}

/// A table as coarse as the tolerance of the radius allows.
Candidate sufficient_table(const Law& law, const ExactCurve& exact, double tolerance) {
  // An error ε of f and m is at most ε(1 + 1/m₀)/0.9 of a radius.
  const double bound = std::clamp(0.9 * tolerance / (1.0 + 1.0 / exact.moment_ratio()), Table::finest_tolerance, Table::coarsest_tolerance);
  const Table table = Table::build(law, bound);
  return {"table", bound, boundary_error(table, exact).max_error, shipped_costs::of("table").wrench};
}

std::string printed(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string reason(const Candidate& candidate, const Candidate& best, double tolerance) {
  if (candidate.error > tolerance) return in_percent(candidate.error) + " > " + in_percent(tolerance);
  if (candidate.chosen) return in_percent(candidate.error) + ": chosen";
  return in_percent(candidate.error) + ", " + printed("%.2g", candidate.nanoseconds / best.nanoseconds) + " times the cost";
}

}  // namespace

std::string in_percent(double fraction) {
  if (fraction == 0.0) return "0";
  if (!(fraction >= 1e-4)) return printed("%.1e", fraction);
  return printed(fraction < 0.1 ? "%.2g" : "%.0f", 100.0 * fraction) + " %";
}

std::vector<Candidate> choose(const Law& law, double tolerance) {
  if (!(tolerance >= 1e-10 && tolerance <= 1.0)) throw out_of_range("tolerance", tolerance, "1", "1e-10 <= tolerance <= 1");
  const ExactCurve exact(law);
  const double m0 = exact.moment_ratio();
  const auto error_of = [&](const auto& boundary) { return boundary_error(boundary, exact).max_error; };
  const auto cost_of = [](const char* model) { return shipped_costs::of(model).wrench; };
  const Superellipse superellipse = minimax_superellipse(exact);
  const Quartic quartic = minimax_quartic(exact);
  std::vector<Candidate> candidates{
      {"diamond", 1.0, error_of(diamond(1.0, m0)), cost_of("diamond")},
      {"box", std::numeric_limits<double>::infinity(), error_of(box(1.0, m0)), cost_of("box")},
      {"ellipse", 1.0, error_of(Ellipse::through_intercepts(m0)), cost_of("ellipse")},
      sufficient_table(law, exact, tolerance),
      {"quartic", quartic.kappa(), error_of(quartic), cost_of("quartic")},
      {"superellipse", superellipse.exponent(), error_of(superellipse), cost_of("superellipse")},
      // In the unit of the shipped figures, whatever this machine is like or busy with.
      {"exact", std::numeric_limits<double>::quiet_NaN(), 0.0,
       measured_cost(exact) * cost_of("ellipse") / measured_cost(Ellipse::through_intercepts(m0))},
  };
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& one, const Candidate& other) { return one.nanoseconds < other.nanoseconds; });
  const auto best =
      std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) { return candidate.error <= tolerance; });
  best->chosen = true;
  for (Candidate& candidate : candidates) candidate.reason = reason(candidate, *best, tolerance);
  return candidates;
}

}  // namespace limitcurve
