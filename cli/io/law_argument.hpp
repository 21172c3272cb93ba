// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/contact_radius.hpp"
#include "limitcurve/pressure_law.hpp"

#include <string>

namespace limitcurve::cli {

/// The law that a command line names: the library's grammar, and `samples:FILE.csv`, a measured profile with the columns
/// radius,pressure. Throws std::invalid_argument that names the place in the text or in the file.
Law read_law(const std::string& text);

/// The radius law that a command line names: the library's grammar, and `samples:FILE.csv`, measured radii with the columns
/// load,radius [N, m]. Throws like `read_law`.
RadiusLaw read_radius_law(const std::string& text);

}  // namespace limitcurve::cli
