// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"

/// Entry "geometry": surfaces with an unexpected nearest point or normal.
namespace limitcurve::stability {

/// A finger pressed deeper than half a plate.
Hazard thin_plate();
/// Friction carried over an edge.
Hazard normals_that_jump();

}  // namespace limitcurve::stability
