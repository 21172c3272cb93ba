// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string_view>

namespace limitcurve::cli {

/// The valid values of an option or a column, and their description for error messages. NaN is never valid.
struct Range {
  bool (*contains)(double);
  std::string_view text;
};

inline constexpr double largest = std::numeric_limits<double>::max();

inline constexpr Range finite{[](double value) { return value >= -largest && value <= largest; }, "a finite number"};
inline constexpr Range positive{[](double value) { return value > 0.0 && value <= largest; }, "a finite number > 0"};
inline constexpr Range non_negative{[](double value) { return value >= 0.0 && value <= largest; }, "a finite number >= 0"};
inline constexpr Range positive_or_inf{[](double value) { return value > 0.0; }, "a number > 0, or inf"};
inline constexpr Range share{[](double value) { return value >= 0.0 && value <= 1.0; }, "a number from 0 to 1"};
/// Distances of a centre of rotation; infinity is pure sliding.
inline constexpr Range distance{[](double value) { return value >= 0.0; }, "a number >= 0, or inf"};

}  // namespace limitcurve::cli
