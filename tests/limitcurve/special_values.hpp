// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace limitcurve::test {

inline constexpr double inf = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace limitcurve::test
