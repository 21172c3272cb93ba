// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/contact_radius.hpp"

#include <span>

namespace limitcurve::cli {

/// Warns on standard error of a radius law that gives more than 0.1 m at one of the `loads` [N], which hardly any finger has and many a law in
/// millimetres, and of samples that they go beyond. Loads of 0 are passed over. One line each.
void warn_of_radii(const RadiusLaw& radius_law, std::span<const double> loads);

}  // namespace limitcurve::cli
