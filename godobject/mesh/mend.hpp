// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/grid.hpp"
#include "godobject/mesh/triangle_list.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// The number of a vertex, a face or a side, from 0, as an index.
inline std::size_t index(int number) noexcept {
  return static_cast<std::size_t>(number);
}

/// Repairs of a list of triangles. Only faults with a unique repair are repaired.
struct MeshRepairs {
  int welded = 0;   ///< vertices at the grid point of another, merged with it, as in every STL
  int dropped = 0;  ///< faces with two corners at the same grid point, left out
  int slivers = 0;  ///< no higher than two spacings of a float at the farthest coordinate, taken out
  int turned = 0;   ///< faces with an inward normal, turned outward
};

/// The smallest height of a face divided by its longest edge. In a thinner face the normal and
/// nearest points would be rounding.
inline constexpr double thinnest_face = 1e-6;

/// Triangles on a grid, each vertex once.
struct MendedTriangles {
  Grid grid;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Face> faces;
  std::vector<std::size_t> given_vertex;  ///< in the list, of each vertex; of merged ones the first
  std::vector<std::size_t> given_face;    ///< in the list, of each face
  std::vector<int> body;                  ///< of each face, from 0 in the order of first faces
  int bodies = 0;
  MeshRepairs repairs;
};

/// Snaps and merges vertices, and takes out the faces that a file's rounding has made: those
/// without area, and slivers. A sliver with a short edge is taken out by collapsing that, another
/// by flipping its long edge, which moves the surface by no more than its height. Then leaves out
/// all bodies but one, counted from 1 (0: keeps all). Throws std::invalid_argument, with the face,
/// for vertices that are missing, not finite or too far out, for fewer than four faces, and for a
/// body that there is not.
MendedTriangles mend(const TriangleList& triangles, int body);

/// One side of a face: its edge from corner `side` to the next, between the vertices `low` <
/// `high`.
struct EdgeSide {
  int low, high;
  int face, side;
};

/// The sides of all faces, sorted by edges.
std::vector<EdgeSide> sorted_sides(std::span<const Face> faces);

/// The height of a face divided by its longest edge.
double thinness(const Grid& grid, std::span<const Eigen::Vector3d> vertices, const Face& face);

}  // namespace limitcurve::godobject
