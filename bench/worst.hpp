// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

namespace limitcurve::bench {

/// The largest time of a single call over the inputs [ns]: each input counts with the fastest of a few calls, so that interrupts do not
/// count. Includes one reading of the clock (about 20 ns).
template <class Inputs, class Call>
double worst_nanoseconds(const Inputs& inputs, Call&& call) {
  using Clock = std::chrono::steady_clock;
  constexpr int repetitions = 9;
  double worst = 0.0;
  for (const auto& input : inputs) {
    double fastest = 1e9;
    for (int i = 0; i < repetitions; ++i) {
      const auto start = Clock::now();
      auto result = call(input);
      benchmark::DoNotOptimize(result);
      fastest = std::min(fastest, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
    }
    worst = std::max(worst, fastest);
  }
  return worst;
}

}  // namespace limitcurve::bench
