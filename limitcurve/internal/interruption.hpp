// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve {

/// Called in long work: between the samples of a table that is being built and of a fit, and between the rows of data
/// and of results. What it throws ends the work; Python's module raises KeyboardInterrupt for Ctrl-C. None by default;
/// set it before any work begins.
inline void (*between_samples)() = nullptr;

inline void let_interrupt() {
  if (between_samples != nullptr) between_samples();
}

}  // namespace limitcurve
