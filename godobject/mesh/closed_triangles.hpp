// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/grid.hpp"
#include "godobject/mesh/tree.hpp"
#include "godobject/mesh/triangle_list.hpp"

#include <vector>

namespace limitcurve::godobject {

/// Repairs of a list of triangles. Only faults with a unique repair are repaired.
struct MeshRepairs {
  int welded = 0;   ///< vertices at the same grid point as another, merged with it (an STL has no shared vertices)
  int dropped = 0;  ///< faces with two corners at the same grid point, left out
  int turned = 0;   ///< faces with an inward normal, turned outward
};

/// Triangles that bound a solid: every edge joins two faces that run along it in opposite senses, the faces around a vertex are one fan,
/// two faces meet only in a shared edge or vertex, and all normals are outward.
struct ClosedTriangles {
  Grid grid;
  std::vector<Eigen::Vector3d> vertices;  ///< on the grid
  std::vector<Face> faces;
  std::vector<Face> neighbours;  ///< the face across each edge; edge i leads from corner i to the next
  Tree tree;
  MeshRepairs repairs;
};

/// The smallest height of a face divided by its longest edge. In a thinner face the normal and nearest points would be rounding.
inline constexpr double thinnest_face = 1e-6;

/// The smallest angle between two faces at an edge [rad], on a blade or in a slit. For a smaller one the outward direction at the edge
/// would be rounding. The thinnest plate along the grid's axes has a larger angle.
inline constexpr double sharpest_edge = 1e-13;

/// Checks and repairs triangles. Throws std::invalid_argument, with the face, its position, the fault and what is expected, for triangles
/// that are open, not a manifold, one-sided, self-intersecting (faces cross, touch or fold on to each other), too thin or sharp, or not
/// finite.
ClosedTriangles close(const TriangleList& triangles);

}  // namespace limitcurve::godobject
