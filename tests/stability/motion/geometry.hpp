// SPDX-License-Identifier: MIT
#pragma once

#include "../atlas.hpp"

/// Entry f, its part on shapes: surfaces whose nearest point, normal or inside is not what one expects.
namespace limitcurve::stability {

/// A finger pressed deeper than half a plate.
Hazard thin_plate();
/// Places nearest to a vertex or an edge of a mesh: on which side are they?
Hazard side_at_a_vertex();
/// Meshes that bound nothing: open, turned, tangled, with faces of no area.
Hazard broken_meshes();
/// Faces so thin that their normal is one of rounding.
Hazard slivers();
/// Friction carried over an edge.
Hazard normals_that_jump();

}  // namespace limitcurve::stability
