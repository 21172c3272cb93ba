// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <string>
#include <string_view>

namespace limitcurve::cli {

/// The table in a file that `limitcurve table` wrote, .csv or .json by its name. Throws std::invalid_argument that names
/// file, place and what is wrong if it is torn, edited or no such file.
limitcurve::Table read_table(const std::string& file);

/// The table in the JSON `text`; `source` names it in complaints.
limitcurve::Table read_table_json(std::string_view text, const std::string& source);

}  // namespace limitcurve::cli
