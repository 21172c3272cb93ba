// SPDX-License-Identifier: MIT
#include "limitcurve/table/buckets.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve::table {

std::size_t Buckets::per_run() const noexcept {
  // The last bucket contains ½ + 2^−d = 2^−d · 2^(d−1) · (1 + 2^(1−d)).
  const std::size_t parts = std::size_t{1} << index_bits;
  const int octaves_below = octaves - 1;
  return static_cast<std::size_t>(octaves_below) * parts + (octaves_below > index_bits ? 0 : parts >> octaves_below) + 1;
}

double Buckets::distance(std::size_t i) const noexcept {
  const std::size_t parts = std::size_t{1} << index_bits;
  const double part = 1.0 + static_cast<double>(i % parts) / static_cast<double>(parts);
  const double offset = std::ldexp(1.0, -octaves);
  return offset * (std::ldexp(part, static_cast<int>(i / parts)) - 1.0);
}

std::vector<double> Buckets::edges() const {
  std::vector<double> result;
  for (std::size_t i = 0; i < per_run(); ++i) result.push_back(distance(i));
  if (result.back() < 0.5) result.push_back(0.5);
  for (std::size_t i = per_run(); i-- > 0;) {
    const double edge = 1.0 - distance(i);
    if (edge > result.back()) result.push_back(edge);
  }
  return result;
}

}  // namespace limitcurve::table
