// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/range.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace limitcurve {

/// Reads a number within `range`, or any number; otherwise throws std::invalid_argument "got '…', expected …".
double read_number(std::string_view text, const std::optional<Range>& range);

/// Reads the numbers of a list such as `0.25,0.5,1`; blanks around an item are allowed. An empty, malformed or
/// out-of-range item throws std::invalid_argument with its position, counted from 1.
std::vector<double> read_number_list(std::string_view text, const Range& range);

}  // namespace limitcurve
