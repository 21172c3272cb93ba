// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch/patch_table.hpp"
#include "limitcurve/table.hpp"

#include <string>
#include <string_view>

namespace limitcurve::cli {

/// Reads a table that `limitcurve table` wrote, as .csv or .json by the file's name. Throws std::invalid_argument with
/// file, place and cause if the file is truncated, edited or no table.
limitcurve::Table read_table(const std::string& file);

/// The same of a table of a patch.
PatchTable read_patch_table(const std::string& file);

/// Reads a table from JSON `text`; error messages call it `source`.
limitcurve::Table read_table_json(std::string_view text, const std::string& source);
PatchTable read_patch_table_json(std::string_view text, const std::string& source);

}  // namespace limitcurve::cli
