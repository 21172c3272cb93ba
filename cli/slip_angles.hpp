// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace limitcurve::cli {

/// s = c/a at the i-th of `points` ≥ 2 slip angles atan(s) spread evenly from 0 (pure twist) to 90° (pure slide, s = inf).
inline double cor_at_slip_angle(std::size_t i, std::size_t points) {
  if (i + 1 == points) return std::numeric_limits<double>::infinity();
  // 2i = N−1 is 45°, the rim: exactly there, not beside it.
  if (2 * i + 1 == points) return 1.0;
  return std::tan(0.5 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points - 1));
}

}  // namespace limitcurve::cli
