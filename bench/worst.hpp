// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

namespace limitcurve::bench {

/// The largest time of a single call that was seen over the inputs [ns]: each input is called a few times and counts
/// with its fastest, so that an interrupt is not taken for the call. Includes one reading of the clock (some 20 ns).
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
