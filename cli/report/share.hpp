// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace limitcurve::cli {

/// The folder that holds scripts/figures/report.py and data/: $LIMITCURVE_SHARE if set, else the package's, else share/limitcurve beside the
/// folder of the executable, else the source tree it was built from. Throws std::runtime_error that names where it looked.
std::filesystem::path find_share();

/// Names the folder inside the package whose module this code is in; empty in an executable. Before the first call of `find_share`.
void set_package_share(std::filesystem::path folder);

}  // namespace limitcurve::cli
