// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
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

}  // namespace limitcurve::stability
