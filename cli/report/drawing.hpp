// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limitcurve::cli {

/// Runs the Python script that draws the report from the CSV files in `directory`, into it. What the script prints goes to
/// standard output; what it complains of becomes the message of the std::runtime_error.
void draw_report(const std::filesystem::path& script, const std::filesystem::path& directory);

}  // namespace limitcurve::cli
