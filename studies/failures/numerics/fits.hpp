// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"

/// Entry "fits": curves with few parameters, fitted to the exact one and to measurements.
namespace limitcurve::stability {

/// The centre of rotation that an approximation implies, towards the axes.
Hazard cor_near_the_axes();
/// Sums of Gaussians, whose tails vanish while the moment falls like 1/s.
Hazard dying_tails();
/// The shape of the pressure and the radius of the contact, which measured slips hardly distinguish.
Hazard shape_and_radius();

}  // namespace limitcurve::stability
