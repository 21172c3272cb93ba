// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch/patch_table.hpp"
#include "limitcurve/table.hpp"

#include <functional>
#include <string>

namespace limitcurve::cli {

using TableWriter = std::function<std::string(const limitcurve::Table&)>;
using PatchTableWriter = std::function<std::string(const PatchTable&)>;

/// The writer for the format that the file's extension names: .csv, .json, .h or .hpp. Throws std::invalid_argument
/// that begins with `option` for any other extension, and for a `name` (of the table in a header; may be empty) or
/// `is_single` with .csv or .json.
TableWriter table_writer(const std::string& file, const std::string& option, const std::string& name = {},
                         bool is_single = false);
/// The same of a table of a patch, for .csv and .json.
PatchTableWriter patch_table_writer(const std::string& file, const std::string& option);

}  // namespace limitcurve::cli
