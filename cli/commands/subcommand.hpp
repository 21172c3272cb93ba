// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands/options.hpp"
#include "cli/io/rows.hpp"

namespace limitcurve::cli {

/// The help text of a subcommand. `notes` explains its columns; `example` is a command line that runs.
struct Manual {
  std::string name;
  std::string purpose;
  std::string notes;
  std::string example;
};

/// One subcommand: its options are its members, filled by the parser before `run`.
class Subcommand {
 public:
  virtual ~Subcommand() = default;

  [[nodiscard]] virtual Manual manual() const = 0;
  virtual void declare(Options& options) = 0;
  /// Writes the results. Throws std::invalid_argument for wrong usage or bad input, any other std::exception when the
  /// job failed.
  virtual void run(const Results& results) = 0;
};

}  // namespace limitcurve::cli
