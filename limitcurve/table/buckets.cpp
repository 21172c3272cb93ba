// SPDX-License-Identifier: MIT
#include "limitcurve/table/buckets.hpp"

#include <cmath>

namespace limitcurve::table {

std::size_t Buckets::per_side() const noexcept {
  // The last bucket contains 1 + 2^−d = 2^−d · 2^d · (1 + 2^−d).
  const std::size_t parts = std::size_t{1} << index_bits;
  return static_cast<std::size_t>(octaves) * parts + (octaves > index_bits ? 0 : parts >> octaves) + 1;
}

double Buckets::edge(std::size_t i) const noexcept {
  const std::size_t parts = std::size_t{1} << index_bits;
  const double part = 1.0 + static_cast<double>(i % parts) / static_cast<double>(parts);
  const double offset = std::ldexp(1.0, -octaves);
  return 1.0 - offset * (std::ldexp(part, static_cast<int>(i / parts)) - 1.0);
}

std::vector<double> Buckets::edges() const {
  std::vector<double> result{0.0};
  for (std::size_t i = per_side(); i-- > 0;) {
    if (edge(i) > 0.0) result.push_back(edge(i));
  }
  return result;
}

}  // namespace limitcurve::table
