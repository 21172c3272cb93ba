// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/wrench.hpp"

#include <cmath>
#include <limits>

namespace limitcurve::cli {

/// A law's wrench at s = c/a in the given units, with the error that `eval` and Law.evaluate state: the law's own, the
/// change of the curve due to the rounding of s, and half a unit in the last place for each rounding of the scaling.
inline WrenchEstimate in_units(const WrenchEstimate& unit, double s, double force_unit, double moment_unit) noexcept {
  constexpr double rounding = 0.5 * std::numeric_limits<double>::epsilon();
  s = std::fabs(s);
  const double force_shift = std::isinf(s) ? 0.0 : std::abs(s * unit.force_slope) * rounding;
  const double moment_shift = std::isinf(s) ? 0.0 : s * force_shift;
  const UnitWrench wrench{force_unit * unit.wrench.force, moment_unit * unit.wrench.moment};
  return {wrench,
          {force_unit * (unit.error.force + force_shift) + 2.0 * rounding * wrench.force,
           moment_unit * (unit.error.moment + moment_shift) + 3.0 * rounding * wrench.moment},
          unit.force_slope};
}

}  // namespace limitcurve::cli
