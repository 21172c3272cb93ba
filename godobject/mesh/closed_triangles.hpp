// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/grid.hpp"
#include "godobject/mesh/tree.hpp"
#include "godobject/mesh/triangle_list.hpp"

#include <vector>

namespace limitcurve::godobject {

/// What was mended in a list of triangles: only where there is one way to do it.
struct MeshRepairs {
  int welded = 0;   ///< vertices at the same place of the grid as another, taken for one (an STL has no shared vertices)
  int dropped = 0;  ///< faces with two corners at the same place, left out: the faces beside them meet there
  int turned = 0;   ///< faces that looked inward, turned outward
};

/// Triangles that bound a solid: every edge joins two faces that run along it in opposite senses, the faces around a vertex are
/// one fan, no two faces meet but in a shared edge or vertex, and every face looks outward.
struct ClosedTriangles {
  Grid grid;
  std::vector<Eigen::Vector3d> vertices;  ///< on the grid
  std::vector<Face> faces;
  std::vector<Face> neighbours;  ///< the face across each edge; edge i leads from corner i to the next
  Tree tree;
  MeshRepairs repairs;
};

/// A face thinner than this, its height over its longest edge, is refused: its normal and nearest places would be rounding.
inline constexpr double thinnest_face = 1e-6;

/// Faces that meet at less than this [rad], as on a knife or in a slit, are refused: which way is outward at their edge would be rounding.
/// The thinnest plate along the grid's axes has more.
inline constexpr double sharpest_edge = 1e-13;

/// Throws std::invalid_argument that names the face, where it is, what is wrong and what is expected, for triangles that are
/// open, not a manifold, one-sided, tangled (faces cross, touch or fold on to each other), too thin or sharp, or not finite.
ClosedTriangles close(const TriangleList& triangles);

}  // namespace limitcurve::godobject
