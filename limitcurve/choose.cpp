// SPDX-License-Identifier: MIT
#include "limitcurve/choose.hpp"

#include "limitcurve/boundary_error.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/number.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace limitcurve {

namespace {

// Mean nanoseconds of a wrench by its twist (bench_limitcurve: box, ellipse, table/*, quartic, superellipse).
constexpr double box_cost = 1.8;
constexpr double ellipse_cost = 3.9;
constexpr double table_cost = 8.0;
constexpr double quartic_cost = 38.0;
constexpr double superellipse_cost = 46.0;

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
  return {"table", bound, boundary_error(table, exact).max_error, table_cost};
}

}  // namespace

std::vector<Candidate> choose(const Law& law, double tolerance) {
  if (!(tolerance >= 1e-10 && tolerance <= 1.0)) throw out_of_range("tolerance", tolerance, "1", "1e-10 <= tolerance <= 1");
  const ExactCurve exact(law);
  const double m0 = exact.moment_ratio();
  const auto error_of = [&](const auto& boundary) { return boundary_error(boundary, exact).max_error; };
  const Superellipse superellipse = minimax_superellipse(exact);
  const Quartic quartic = minimax_quartic(exact);
  std::vector<Candidate> candidates{
      {"box", std::numeric_limits<double>::infinity(), error_of(box(1.0, m0)), box_cost},
      {"ellipse", 1.0, error_of(Ellipse::through_intercepts(m0)), ellipse_cost},
      sufficient_table(law, exact, tolerance),
      {"quartic", quartic.kappa(), error_of(quartic), quartic_cost},
      {"superellipse", superellipse.exponent(), error_of(superellipse), superellipse_cost},
      // In the unit of the shipped figures, whatever this machine is like or busy with.
      {"exact", std::numeric_limits<double>::quiet_NaN(), 0.0,
       measured_cost(exact) * ellipse_cost / measured_cost(Ellipse::through_intercepts(m0))},
  };
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& one, const Candidate& other) { return one.nanoseconds < other.nanoseconds; });
  std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) { return candidate.error <= tolerance; })->chosen =
      true;
  return candidates;
}

}  // namespace limitcurve
