// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/number.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::fit::internal {

/// A point of the exact curve in the normalised plane of the paper, x = f, y = m/m₀.
struct CurvePoint {
  double x;
  double y;
  /// Square root of the point's share of the rays (in polar angle, by the trapezoidal rule), 1 on average: the sum of
  /// squares of residuals times this weight gives `CurveError::rms_error`.
  double weight;
};

/// `count` points of the curve of `law`, evenly spaced in the normalised slip angle atan(s/m₀) from pure twist to pure
/// slide; the ends are exact.
inline std::vector<CurvePoint> curve_points(const PressureLaw& law, std::size_t count) {
  if (count < 3) throw std::invalid_argument("points = " + std::to_string(count) + " is out of range: expected >= 3");
  constexpr double quarter_turn = 1.5707963267948966;
  const double moment_ratio = law.moment_ratio();
  std::vector<CurvePoint> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = quarter_turn * static_cast<double>(i) / static_cast<double>(count - 1);
    const double s = i + 1 == count ? std::numeric_limits<double>::infinity() : moment_ratio * std::tan(angle);
    const UnitForces<double> forces = law.forces(s);
    points.push_back({forces.force, forces.moment / moment_ratio, 0.0});
  }
  const auto ray = [&](std::size_t i) { return std::atan2(points[i].x, points[i].y); };
  for (std::size_t i = 0; i < count; ++i) {
    const double width = 0.5 * (ray(std::min(i + 1, count - 1)) - ray(i == 0 ? 0 : i - 1));
    points[i].weight = std::sqrt(std::max(width, 0.0) / quarter_turn * static_cast<double>(count));
  }
  return points;
}

}  // namespace limitcurve::fit::internal
