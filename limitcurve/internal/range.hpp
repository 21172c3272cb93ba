// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string_view>

namespace limitcurve {

/// The valid values of an option, a column or a parameter, and their description for error messages. NaN is never
/// valid.
struct Range {
  double least;
  double most;
  std::string_view text;
  bool whole = false;  ///< whole numbers only, within ±1e9

  [[nodiscard]] constexpr bool contains(double value) const noexcept {
    return value >= least && value <= most && (!whole || value == static_cast<double>(static_cast<int>(value)));
  }
};

namespace ranges {
inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr double smallest = std::numeric_limits<double>::denorm_min();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

inline constexpr Range finite{-largest, largest, "a finite number"};
inline constexpr Range positive{smallest, largest, "a finite number > 0"};
inline constexpr Range non_negative{0.0, largest, "a finite number >= 0"};
/// Distances of a centre of rotation; infinity is pure sliding.
inline constexpr Range distance{0.0, infinite, "a number >= 0, or inf"};
inline constexpr Range signed_distance{-infinite, infinite, "a number, or inf"};
}  // namespace ranges

}  // namespace limitcurve
