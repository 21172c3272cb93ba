// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/rows.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::cli {

/// No subcommand was given; the text is the help.
struct NoSubcommand : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Runs `limitcurve ARGUMENTS…`; what --format says overrules `results`. Throws std::invalid_argument for wrong usage
/// or bad input, any other std::exception when the job failed. Called by `run_program`, and by Python.
void run_command_line(std::vector<std::string> arguments, Results results);

/// What main() does: results on standard output, messages, progress and one line of complaint on standard error; none
/// if whoever reads the results left. Returns the exit status.
int run_program(const std::vector<std::string>& arguments);

}  // namespace limitcurve::cli
