// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/key_values.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace limitcurve::cli {

/// Reads the numbers of a list such as `0.25,0.5,1`; blanks around an item are allowed. An empty, malformed or
/// out-of-range item throws std::invalid_argument with its position, counted from 1.
std::vector<double> read_number_list(std::string_view text, const Range& range);

/// A key whose value is an angle: `30deg`, `0.5rad`, or a bare number of radians.
KeyValue angle_key(std::string_view key, double& value, const Range& range, bool required = true);

/// Splits `FILE[,key=value…]` of a kind; the file's name may contain commas. Throws std::invalid_argument if it is
/// empty.
std::string split_file(std::string_view kind, std::string_view rest, std::string_view& items);

/// The text as one word of a POSIX shell, for every line that is printed to be typed. Quoted if a shell would change
/// it.
std::string shell_word(std::string_view text);

}  // namespace limitcurve::cli
