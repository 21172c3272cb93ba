// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <string>

namespace limitcurve::cli {

using TableWriter = std::string (*)(const limitcurve::Table&);

/// The writer for the format that the file's extension names: .csv, .json, .h or .hpp. Throws std::invalid_argument that begins with
/// `option` for any other extension.
TableWriter table_writer(const std::string& file, const std::string& option);

}  // namespace limitcurve::cli
