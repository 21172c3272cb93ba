// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/rows.hpp"

#include <string>
#include <vector>

namespace limitcurve::cli {

/// Runs `limitcurve ARGUMENTS…`; what --format says overrules `results`. Throws std::invalid_argument for wrong usage or bad
/// input, any other std::exception when the job failed. This is what main() calls, and `report` for each of its tables.
void run_command_line(const std::vector<std::string>& arguments, Results results);

}  // namespace limitcurve::cli
