// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/range.hpp"

#include <limits>

namespace limitcurve::cli {

inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr double smallest = std::numeric_limits<double>::denorm_min();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

inline constexpr Range finite{-largest, largest, "a finite number"};
inline constexpr Range positive{smallest, largest, "a finite number > 0"};
inline constexpr Range non_negative{0.0, largest, "a finite number >= 0"};
/// Distances of a centre of rotation; infinity is pure sliding.
inline constexpr Range distance{-infinite, infinite, "a number, or inf"};

}  // namespace limitcurve::cli
