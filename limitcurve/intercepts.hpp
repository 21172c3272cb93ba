// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/number.hpp"

#include <cmath>

namespace limitcurve {

/// Refuses intercepts of a limit boundary, in unit wrenches, that are not > 0 and finite: throws std::invalid_argument
/// naming the one and its value.
inline void check_intercepts(double force_max, double moment_max) {
  if (!(force_max > 0.0) || std::isinf(force_max)) throw out_of_range("force_max", force_max, "1", "> 0 and finite");
  if (!(moment_max > 0.0) || std::isinf(moment_max)) throw out_of_range("moment_max", moment_max, "1", "> 0 and finite");
}

}  // namespace limitcurve
