// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"

/// Entry "tables": limit curves as lookup tables.
namespace limitcurve::stability {

/// Evenly spaced nodes across the rim, where the derivatives of a limit curve are singular.
Hazard even_spacing();
/// Centres of rotation beyond the last node.
Hazard beyond_the_last_node();
/// An interpolant that is not convex: a driven finger has more than one equilibrium.
Hazard false_equilibria();

}  // namespace limitcurve::stability
