// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limitcurve::cli {

/// The folder that holds scripts/figures/report.py and data/: $LIMITCURVE_SHARE if set, else share/limitcurve beside the folder of
/// the executable, else the source tree it was built from. Throws std::runtime_error that names where it looked.
std::filesystem::path find_share();

}  // namespace limitcurve::cli
