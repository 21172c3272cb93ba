// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

int main(int argc, char** argv) {
  return limitcurve::cli::run_program({argv + 1, argv + argc});
}
