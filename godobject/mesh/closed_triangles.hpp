// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/mend.hpp"
#include "godobject/mesh/tree.hpp"

#include <vector>

namespace limitcurve::godobject {

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

/// The smallest angle between two faces at an edge [rad], on a blade or in a slit. For a smaller one the outward direction at the edge
/// would be rounding. The thinnest plate along the grid's axes has a larger angle.
inline constexpr double sharpest_edge = 1e-13;

/// Mends and checks triangles: all, or one of the bodies, which are the connected parts, counted
/// from 1 in the order of their first faces (0: all). Throws std::invalid_argument, with the face,
/// its position, the fault, what is expected and a way on, for triangles that are open, not a
/// manifold, one-sided, self-intersecting (faces cross, touch or fold on to each other), too thin
/// or sharp, or not finite.
ClosedTriangles close(const TriangleList& triangles, int body = 0);

}  // namespace limitcurve::godobject
