// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <functional>
#include <string>

namespace limitcurve::cli {

using TableWriter = std::function<std::string(const limitcurve::Table&)>;

/// The writer for the format that the file's extension names: .csv, .json, .h or .hpp. Throws std::invalid_argument
/// that begins with `option` for any other extension, and for a `name` (of the table in a header; may be empty) or
/// `is_single` with .csv or .json.
TableWriter table_writer(const std::string& file, const std::string& option, const std::string& name = {},
                         bool is_single = false);

}  // namespace limitcurve::cli
