// SPDX-License-Identifier: MIT
#pragma once

#include "../atlas.hpp"

/// Entry "geometry": surfaces with an unexpected nearest point, normal or inside.
namespace limitcurve::stability {

/// A finger pressed deeper than half a plate.
Hazard thin_plate();
/// Points nearest to a vertex or an edge of a mesh: on which side are they?
Hazard side_at_a_vertex();
/// Defective meshes: open, flipped, self-intersecting, with faces without area.
Hazard broken_meshes();
/// Faces so thin that rounding determines their normal.
Hazard slivers();
/// Friction carried over an edge.
Hazard normals_that_jump();

}  // namespace limitcurve::stability
