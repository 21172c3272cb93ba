// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/messages.hpp"

#include "limitcurve/contact_radius.hpp"
#include "limitcurve/patch.hpp"

#include <span>

namespace limitcurve::cli {

/// Warns, in one line each, of a radius law that gives more than 0.1 m at one of the `loads` [N] (probably the law is in
/// millimetres), and of loads outside the range of its samples. Ignores loads of 0.
void warn_of_radii(Messages& messages, const RadiusLaw& radius_law, std::span<const double> loads);

/// Warns of a patch, given as `text`, whose moment arm is above `largest_arm` [m] (probably it is in millimetres).
void warn_of_patch(Messages& messages, const std::string& text, const Patch& patch, double largest_arm = 1.0);

}  // namespace limitcurve::cli
