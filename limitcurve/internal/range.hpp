// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limitcurve {

/// The valid values of an option, a column or a parameter, and their description for error messages. NaN is never valid.
struct Range {
  double least;
  double most;
  std::string_view text;
  bool whole = false;  ///< whole numbers only, within ±1e9

  [[nodiscard]] constexpr bool contains(double value) const noexcept {
    return value >= least && value <= most && (!whole || value == static_cast<double>(static_cast<int>(value)));
  }
};

}  // namespace limitcurve
