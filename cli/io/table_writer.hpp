// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <string>

namespace limitcurve::cli {

using TableWriter = std::string (*)(const limitcurve::Table&);

/// What writes a table in the form that a file's name ends in: .csv, .json, .h or .hpp. Throws std::invalid_argument, which begins with
/// `option`, for any other name.
TableWriter table_writer(const std::string& file, const std::string& option);

}  // namespace limitcurve::cli
