// SPDX-License-Identifier: MIT
#pragma once

#include "../../tests/limitcurve/reference.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/wrench.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The methods that `studies/chart/measure` measures, each with its error and its time.
namespace limitcurve::bench {

/// Something with a cost that Google Benchmark times.
struct Way {
  std::string name;  ///< slashes between the columns that the driver makes of it
  std::function<void(benchmark::State&)> time;
  double nanoseconds;  ///< of a call, roughly
};

/// All methods, in the order of the chart's data.
inline std::vector<Way>& ways() {
  static std::vector<Way> all;
  return all;
}

/// Error in the norm of a table's tolerance (docs/accuracy.md): the larger of |Δf| and |Δm|/max(1, m₀).
inline double tolerance_error(UnitWrench one, UnitWrench other, double moment_ratio) {
  return std::fmax(std::fabs(one.force - other.force),
                   std::fabs(one.moment - other.moment) / std::fmax(1.0, moment_ratio));
}

/// A low-discrepancy sequence in [0, 1], in an order that a branch predictor cannot learn.
inline std::vector<double> spread(std::size_t count) {
  std::vector<double> result;
  double u = 0.5;
  for (std::size_t i = 0; i < count; ++i) {
    u += 0.6180339887498949;
    u -= std::floor(u);
    result.push_back(u);
  }
  return result;
}

/// Time of a call [ns], roughly.
template <class Call>
double rough_cost(const Call& call) {
  using Clock = std::chrono::steady_clock;
  for (std::size_t calls = 1;; calls *= 2) {
    const std::vector<double> inputs = spread(calls);
    double sum = 0.0;
    const Clock::time_point begin = Clock::now();
    for (const double u : inputs) sum += call(u);
    benchmark::DoNotOptimize(sum);
    const double taken = std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
    if (taken > 1e4) return taken / static_cast<double>(calls);
  }
}

/// A pressure law with its reference: the 50-digit values of data/reference at its centres of rotation, and between
/// these `evaluate` in 80-bit arithmetic. Methods are added as calls from a slip twist to a unit wrench.
class WrenchStudy {
 public:
  WrenchStudy(std::string_view law_name, Law law) : law_name_(law_name), law_(std::move(law)) {
    // The difficult inputs come first, so that slow methods get them, too.
    for (const test::ReferenceRow& row : test::reference_rows()) {
      if (row.law != law_name_) continue;
      places_.push_back(SlipTwist::about_cor(row.s));
      references_.push_back({static_cast<double>(row.force), static_cast<double>(row.moment)});
    }
    special_ = places_.size();
    for (const double u : spread(497)) {
      places_.push_back(SlipTwist::of_spin_fraction(u));
      references_.push_back(law_->evaluate(places_.back().cor()).wrench);
    }
    moment_ratio_ = law_->moment_ratio();
  }

  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] double moment_ratio() const { return moment_ratio_; }

  /// `kind` is "ours" or "others"; `family` and `parameter` are the chart's names of the method; `bytes` is its memory.
  template <class Call>
  void add(std::string_view kind, std::string_view family, std::string_view parameter, std::size_t bytes,
           Call call) const {
    const std::string name =
        "wrench/" + law_name_ + '/' + std::string(kind) + '/' + std::string(family) + '/' + std::string(parameter);
    const auto at = [call](double u) {
      const UnitWrench wrench = call(SlipTwist::of_spin_fraction(u));
      return wrench.force + wrench.moment;
    };
    const double rough = rough_cost(at);
    const auto max_error = std::make_shared<double>(std::numeric_limits<double>::quiet_NaN());
    const auto time = [this, call, at, rough, bytes, max_error](benchmark::State& state) {
      const std::vector<double> inputs = spread(static_cast<std::size_t>(std::clamp(1e6 / rough, 4.0, 1024.0)));
      for (auto _ : state) {
        double sum = 0.0;
        for (const double u : inputs) sum += at(u);
        benchmark::DoNotOptimize(sum);
      }
      if (std::isnan(*max_error)) *max_error = max_error_of(call, rough);
      const auto calls = static_cast<double>(inputs.size());
      state.counters["seconds"] =
          benchmark::Counter(calls, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
      state.counters["max_error"] = *max_error;
      state.counters["bytes"] = static_cast<double>(bytes);
    };
    ways().push_back({name, time, rough});
    if (bytes != 0 && rough < 50.0) add_many(name, call);
  }

 private:
  /// The same where the data are not in the first cache: a scene's 64 tables, visited at random. A copy of `Call` has
  /// memory of its own.
  template <class Call>
  static void add_many(const std::string& name, const Call& call) {
    ways().push_back({"many_" + name,
                      [call](benchmark::State& state) {
                        const std::vector<Call> tables(64, call);
                        std::vector<std::pair<SlipTwist, const Call*>> visits;
                        for (const double u : spread(1 << 16)) {
                          const double which = u * 7919.0;  // independent of u, as far as a look-up goes
                          visits.emplace_back(SlipTwist::of_spin_fraction(u),
                                              &tables[static_cast<std::size_t>(64.0 * (which - std::floor(which)))]);
                        }
                        for (auto _ : state) {
                          double sum = 0.0;
                          for (const auto& [twist, table] : visits) {
                            const UnitWrench wrench = (*table)(twist);
                            sum += wrench.force + wrench.moment;
                          }
                          benchmark::DoNotOptimize(sum);
                        }
                        state.counters["seconds"] = benchmark::Counter(
                            static_cast<double>(visits.size()),
                            benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
                      },
                      10.0});
  }

  template <class Call>
  double max_error_of(const Call& call, double rough) const {
    double worst = 0.0;
    const auto count = std::min(places_.size(), special_ + static_cast<std::size_t>(std::max(2e8 / rough, 9.0)));
    for (std::size_t i = 0; i < count; ++i)
      worst = std::fmax(worst, tolerance_error(call(places_[i]), references_[i], moment_ratio_));
    return worst;
  }

  std::string law_name_;
  Law law_;
  std::vector<SlipTwist> places_;
  std::size_t special_ = 0;
  std::vector<UnitWrench> references_;
  double moment_ratio_ = 0.0;
};

}  // namespace limitcurve::bench
