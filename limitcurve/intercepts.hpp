// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/number.hpp"
#include "limitcurve/wrench.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve {

/// Refuses intercepts of a limit boundary, in unit wrenches, that are not > 0 and finite: throws std::invalid_argument
/// naming the one and its value.
inline void check_intercepts(double force_max, double moment_max) {
  if (!(force_max > 0.0) || std::isinf(force_max)) throw out_of_range("force_max", force_max, "1", "> 0 and finite");
  if (!(moment_max > 0.0) || std::isinf(moment_max)) throw out_of_range("moment_max", moment_max, "1", "> 0 and finite");
}

/// The wrench whose coordinates x = f/A and y = m/B are `larger` and `ratio` times as much; x is the larger one if `force_leads`.
inline UnitWrench between_intercepts(double force_max, double moment_max, bool force_leads, double larger, double ratio) noexcept {
  return force_leads ? UnitWrench{force_max * larger, moment_max * (ratio * larger)}
                     : UnitWrench{force_max * (ratio * larger), moment_max * larger};
}

/// Gauge of a wrench for a curve that is symmetric in x = f/A and y = m/B: `unit_length(r)` is that of (1, r), r ∈ [0, 1].
template <class UnitLength>
double symmetric_gauge(double force_max, double moment_max, UnitWrench wrench, UnitLength&& unit_length) noexcept {
  const double x = wrench.force / force_max;
  const double y = wrench.moment / moment_max;
  const double larger = std::max(x, y);
  return larger > 0.0 ? larger * unit_length(std::min(x, y) / larger) : 0.0;
}

}  // namespace limitcurve
