// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch.hpp"

#include <functional>
#include <string>

namespace limitcurve::cli {

/// Reads a patch from a command line: `points:FILE.csv` (columns x,y,load), `polygon:FILE.csv` (x,y), `rectangle:x=0.02,y=0.01` (full
/// sides), `ellipse:law=hertz,a=0.004,b=0.002`, `image:FILE.csv,pixel=0.0005` (rows of pressures, no header), each with `,mx=…,my=…` if
/// friction differs along x and y. Throws std::invalid_argument with the place of the error in the text or in the file.
Patch read_patch(const std::string& text);

/// Calls `take(twist)` for each row of a CSV file with the columns vx, vy, omega.
void read_twists(const std::string& file, const std::function<void(const PatchTwist&)>& take);

}  // namespace limitcurve::cli
