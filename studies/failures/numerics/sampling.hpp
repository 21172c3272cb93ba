// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace limitcurve::stability {

/// `count` ≥ 2 evenly spaced numbers from `from` to `to`.
inline std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(from + (to - from) * i / (count - 1));
  return numbers;
}

/// … in equal ratios.
inline std::vector<double> in_ratios(double from, double to, int count) {
  std::vector<double> numbers = evenly(std::log(from), std::log(to), count);
  for (double& number : numbers) number = std::exp(number);
  return numbers;
}

/// Keeps the larger value, of each of several.
inline void raise(double& worst, double value) {
  worst = std::max(worst, value);
}
template <class Values>
void raise(Values& worst, const Values& values) {
  for (std::size_t i = 0; i < worst.size(); ++i) raise(worst[i], values[i]);
}

}  // namespace limitcurve::stability
