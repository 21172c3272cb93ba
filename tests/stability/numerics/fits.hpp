// SPDX-License-Identifier: MIT
#pragma once

#include "../atlas.hpp"

/// Entry c: curves of few parameters laid through the exact one, and through measurements.
namespace limitcurve::stability {

/// The centre of rotation that an approximation implies, towards the axes.
Hazard cor_near_the_axes();
/// Sums of Gaussians, whose tails die while the moment falls as 1/s.
Hazard dying_tails();
/// The shape of the pressure and the radius of the contact, which measured slips hardly tell apart.
Hazard shape_and_radius();

}  // namespace limitcurve::stability
