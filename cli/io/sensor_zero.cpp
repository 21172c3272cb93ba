// SPDX-License-Identifier: MIT
#include "cli/io/sensor_zero.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace limitcurve::cli {

namespace {

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// The smallest step between two values, 0 if all are equal.
double step_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1]) step = std::min(step, values[i] - values[i - 1]);
  }
  return std::isfinite(step) ? step : 0.0;
}

}  // namespace

SensorZero::SensorZero(const std::vector<std::vector<double>>& channels, std::span<const double> loads,
                       double least_load)
    : levels_(channels.size()), sigmas_(channels.size()) {
  if (loads.size() < shortest_pause) return;
  std::vector<double> sorted(loads.begin(), loads.end());
  const auto percentile = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 100);
  std::nth_element(sorted.begin(), percentile, sorted.end());
  const double bound = *percentile + least_load;
  // Three standard deviations of one row: second differences tell the noise, because a ramp has none.
  std::vector<double> bends;
  for (std::size_t i = 2; i < loads.size(); ++i)
    bends.push_back(std::fabs(loads[i] - 2.0 * loads[i - 1] + loads[i - 2]));
  std::sort(bends.begin(), bends.end());
  const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
  // Of a normal error the smaller half is 0.3246 on average: grips and steps hardly matter.
  noise_ = std::accumulate(bends.begin(), middle, 0.0) / static_cast<double>(middle - bends.begin()) / 0.3246 /
           std::sqrt(6.0);
  const double settled = std::max(3.0 / 0.6745 / std::sqrt(6.0) * *middle, 0.05 * least_load);
  std::vector<std::vector<double>> resting(channels.size());
  for (std::size_t end = 0, begin = 0; end < loads.size(); begin = end) {
    while (begin < loads.size() && !(loads[begin] < bound)) ++begin;
    for (end = begin; end < loads.size() && loads[end] < bound;) ++end;
    const std::size_t length = end - begin;
    if (length < shortest_pause) continue;
    // Where the log begins and ends nothing is loaded.
    const std::size_t first = begin == 0 ? 0 : begin + length / 4;
    const std::size_t last = end == loads.size() ? end : end - length / 4;
    middles_.push_back(0.5 * static_cast<double>(first + last - 1));
    std::vector<double> changes(loads.begin() + static_cast<std::ptrdiff_t>(first),
                                loads.begin() + static_cast<std::ptrdiff_t>(last));
    const double level = middle_of(changes);
    for (double& load : changes) load = std::fabs(load - level);
    // What rests far below was no load either: a light grip then passes for a part of the pauses beside it. A skin that
    // sticks pulls for a moment, without rest.
    std::vector<double> lower;
    std::copy_if(loads.begin() + static_cast<std::ptrdiff_t>(begin), loads.begin() + static_cast<std::ptrdiff_t>(end),
                 std::back_inserter(lower), [&](double load) { return load < level - least_load - settled; });
    const double rest = lower.empty() ? 0.0 : middle_of(lower);
    const auto rests =
        std::count_if(lower.begin(), lower.end(), [&](double load) { return std::fabs(load - rest) <= settled; });
    if (middle_of(changes) > settled || static_cast<std::size_t>(rests) >= shortest_pause) ++unsettled_;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const std::span<const double> rows = std::span(channels[i]).subspan(first, last - first);
      levels_[i].push_back(middle_of({rows.begin(), rows.end()}));
      for (const double value : rows) resting[i].push_back(value - levels_[i].back());
    }
  }
  for (std::size_t i = 0; i < channels.size() && !middles_.empty(); ++i) {
    double sum = 0.0;
    for (const double value : resting[i]) sum += value * value;
    sigmas_[i] = std::sqrt(sum / static_cast<double>(resting[i].size()));
    // A step rounds by a twelfth of its square.
    if (sigmas_[i] > 0.0) sigmas_[i] = std::max(sigmas_[i], step_of(channels[i]) / std::sqrt(12.0));
  }
}

double SensorZero::at(std::size_t channel, std::size_t row) const {
  const auto place = static_cast<double>(row);
  const auto after =
      static_cast<std::size_t>(std::lower_bound(middles_.begin(), middles_.end(), place) - middles_.begin());
  if (after == 0) return levels_[channel].front();
  if (after == middles_.size()) return levels_[channel].back();
  const double share = (place - middles_[after - 1]) / (middles_[after] - middles_[after - 1]);
  return levels_[channel][after - 1] + share * (levels_[channel][after] - levels_[channel][after - 1]);
}

}  // namespace limitcurve::cli
