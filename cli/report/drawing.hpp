// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/messages.hpp"

#include <filesystem>
#include <string>

namespace limitcurve::cli {

/// Runs the Python script that draws the report from the CSV files in `directory`, into it. Returns what the script prints, but for its
/// lines `figure N of M`, which take the progress of the whole from the share `begin` to 1. What it complains of is said in `messages`,
/// or becomes the message of the std::runtime_error where it fails.
std::string draw_report(const std::filesystem::path& script, const std::filesystem::path& directory, Messages& messages, double begin);

}  // namespace limitcurve::cli
