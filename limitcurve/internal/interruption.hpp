// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve {

/// Called between the samples of a table that is being built. What it throws ends the work; Python's module raises KeyboardInterrupt for
/// Ctrl-C. None by default; set it before any work begins.
inline void (*between_samples)() = nullptr;

}  // namespace limitcurve
