// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/number.hpp"
#include "limitcurve/pressure_law.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::fit::internal {

/// A point of the exact curve in the normalised plane of the paper, x = f, y = m/m₀, and its COR distance s = c/a.
struct CurvePoint {
  double x;
  double y;
  double cor;
};

/// `count` points of the curve of `law`, evenly in slip angle atan(s) from pure twist to pure slide, ends included exactly.
inline std::vector<CurvePoint> curve_points(const PressureLaw& law, std::size_t count) {
  if (count < 3) throw std::invalid_argument("points = " + std::to_string(count) + " is out of range: expected >= 3");
  constexpr double quarter_turn = 1.5707963267948966;
  const double moment_ratio = law.moment_ratio();
  std::vector<CurvePoint> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = quarter_turn * static_cast<double>(i) / static_cast<double>(count - 1);
    const double s = i + 1 == count ? std::numeric_limits<double>::infinity() : std::tan(angle);
    const UnitForces<double> forces = law.forces(s);
    points.push_back({forces.force, forces.moment / moment_ratio, s});
  }
  return points;
}

}  // namespace limitcurve::fit::internal
