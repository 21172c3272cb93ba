// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_boundary.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

namespace limitcurve::cli {

/// What one `boundary.wrench(twist)` costs [ns], here and now: the median over batches of look-ups spread over all twists.
/// Takes some milliseconds, or 64 look-ups a batch where these take longer.
template <LimitBoundary Boundary>
double lookup_cost(const Boundary& boundary) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t places = 1024;
  constexpr std::size_t batches = 21;
  constexpr double longest_batch = 1e6;  // ns
  std::array<SlipTwist, places> twists;
  // The multiples of the golden ratio, modulo 1, come in no order that a branch predictor could learn, and leave no gap.
  double u = 0.5;
  for (SlipTwist& twist : twists) {
    twist = SlipTwist::of_spin_fraction(u);
    u += 0.6180339887498949;
    if (u >= 1.0) u -= 1.0;
  }
  std::vector<double> costs;
  volatile double sink = 0.0;
  std::size_t count = 64;
  while (costs.size() < batches) {
    double sum = 0.0;
    const auto begin = Clock::now();
    for (std::size_t i = 0; i < count; ++i) {
      const UnitWrench wrench = boundary.wrench(twists[i % places]);
      sum += wrench.force + wrench.moment;
    }
    const double duration = std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
    sink = sink + sum;
    if (duration < 0.05 * longest_batch) {
      // Too short for the clock: warm up with more.
      count *= 4;
      costs.clear();
      continue;
    }
    costs.push_back(duration / static_cast<double>(count));
  }
  std::nth_element(costs.begin(), costs.begin() + batches / 2, costs.end());
  return costs[batches / 2];
}

}  // namespace limitcurve::cli
