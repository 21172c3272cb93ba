// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve {

/// The shortest decimal that reads back as exactly `value`; "inf", "-inf", "nan" for what is not finite.
std::string format_number(double value);

/// The double that `text`, all of it, denotes ("inf" and "nan" included); nothing if it is not a number.
std::optional<double> parse_number(std::string_view text);

/// The complaint about a parameter: its name, value, unit ("1" if none) and permitted range.
std::invalid_argument out_of_range(std::string_view name, double value, std::string_view unit, std::string_view range);

}  // namespace limitcurve
