// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// The timing of finger_bench: it repeats a workload, and each stretch counts with its fastest pass.
namespace limitcurve::bench {

using Clock = std::chrono::steady_clock;

inline constexpr double shortest_round = 1e7;  // [ns]

/// Results of all passes through a workload.
struct Times {
  double result = 0.0;          // sum of what the steps returned
  std::size_t steps = 0;        // in all
  std::vector<double> fastest;  // a step's time in each stretch [ns]
};

using Pass = std::function<void(Times&)>;

/// A pass of `stretches` calls of `stretch(index)`, each of which takes `steps` steps and returns the sum of their
/// results.
template <class Stretch>
Pass timed(std::size_t stretches, std::size_t steps, Stretch stretch) {
  return [stretches, steps, stretch = std::move(stretch)](Times& times) mutable {
    times.fastest.resize(stretches, std::numeric_limits<double>::infinity());
    auto last = Clock::now();
    for (std::size_t i = 0; i < stretches; ++i) {
      times.result += stretch(i);
      const auto now = Clock::now();
      const double taken = std::chrono::duration<double, std::nano>(now - last).count();
      last = now;
      times.fastest[i] = std::min(times.fastest[i], taken / static_cast<double>(steps));
    }
    times.steps += stretches * steps;
  };
}

struct Round {
  double mean, worst, result;
};

class Workload {
 public:
  Workload(std::string name, std::function<Pass()> make) : name_(std::move(name)), make_(std::move(make)) {}
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Prepares the workload, runs it until it is steady, and finds the number of passes in a round.
  void start() {
    pass_ = make_();
    times_ = {};
    pass_(times_);
    passes_ = 1;
    while (take_round() < shortest_round && passes_ < 1000000) passes_ *= 2;
  }
  [[nodiscard]] Round round() {
    times_.result = 0.0;
    times_.steps = 0;
    const double taken = take_round();
    const bool alike = times_.fastest.size() == 1;
    const auto steps = static_cast<double>(times_.steps);
    return {taken / steps, alike ? std::nan("") : *std::ranges::max_element(times_.fastest), times_.result / steps};
  }
  void stop() { pass_ = nullptr; }

 private:
  /// The processor's time for it [ns].
  double take_round() {
    const std::clock_t begin = std::clock();
    for (std::size_t i = 0; i < passes_; ++i) pass_(times_);
    return static_cast<double>(std::clock() - begin) * (1e9 / CLOCKS_PER_SEC);
  }

  std::string name_;
  std::function<Pass()> make_;
  Pass pass_;
  Times times_;
  std::size_t passes_ = 1;
};

}  // namespace limitcurve::bench
