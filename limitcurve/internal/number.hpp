// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve {

/// The shortest decimal that reads back as exactly `value`; "inf", "-inf" or "nan" for a number that is not finite.
std::string format_number(double value);
/// The value rounded to `digits` digits, for messages: as printf's %.*g, but independent of the locale.
std::string format_number(double value, int digits);

/// The number written in `text` ("inf" and "nan" included); nothing if the whole text is not a number. A number beyond
/// the range of double gives 0 or ±inf. Independent of the locale.
std::optional<double> parse_number(std::string_view text);

/// The exception for a parameter out of range, "NAME = VALUE UNIT is out of range: expected RANGE"; unit "1" is left
/// out.
std::invalid_argument out_of_range(std::string_view name, double value, std::string_view unit, std::string_view range);

}  // namespace limitcurve
