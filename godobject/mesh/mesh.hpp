// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/closed_triangles.hpp"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// A point of a mesh: its face, and the part of the face that it is on (triangle.hpp).
struct MeshPlace {
  int face = 0;
  int part = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [m]
};

/// The surface of a solid as triangles, checked by the constructor. Immutable: many fingers and threads may share one. Queries are
/// noexcept, and do not allocate or lock.
class Mesh {
 public:
  /// Checks and repairs the triangles with `close`: all, or those of one body; throws
  /// std::invalid_argument.
  explicit Mesh(const TriangleList& triangles, int body = 0);

  /// Those of the faces, and those that mending or the choice of a body has left unused.
  [[nodiscard]] std::span<const Eigen::Vector3d> vertices() const noexcept { return solid_.vertices; }
  [[nodiscard]] std::span<const Face> faces() const noexcept { return solid_.faces; }
  [[nodiscard]] const MeshRepairs& repairs() const noexcept { return solid_.repairs; }
  [[nodiscard]] const Grid& grid() const noexcept { return solid_.grid; }
  [[nodiscard]] double volume() const noexcept { return volume_; }  ///< [m³] > 0
  /// The outward unit normal of a face.
  [[nodiscard]] const Eigen::Vector3d& normal(int face) const noexcept { return normals_[static_cast<std::size_t>(face)]; }

  /// The outward unit normal at a point of the mesh: the face's normal, at an edge the mean of both, at a vertex the mean weighted by the
  /// faces' angles. For the surface point nearest to any point, its sign tells the side of that point.
  /// Source: J. A. Bærentzen, H. Aanæs, IEEE Trans. Vis. Comput. Graph. 11:243–253, 2005.
  [[nodiscard]] Eigen::Vector3d outward(const MeshPlace& place) const noexcept;
  /// Whether a point of the mesh is inside a face, or on an edge between two faces in one plane.
  [[nodiscard]] bool flat(const MeshPlace& place) const noexcept;
  /// The height of a point above a face's plane [m], negative below.
  [[nodiscard]] double height(int face, const Eigen::Vector3d& point) const noexcept;

  /// Whether a point is above the planes of all faces that meet at a point of the mesh.
  [[nodiscard]] bool above(const MeshPlace& place, const Eigen::Vector3d& point) const noexcept;

  /// The point of a face nearest to `point`.
  [[nodiscard]] MeshPlace on(int face, const Eigen::Vector3d& point) const noexcept;

  /// Slides from the place of `face` that is nearest to `from` to a local minimum of the distance
  /// to `point`, by steepest descent on the surface. So the way depends on the solid, not on how
  /// its surface is divided. At most one step for each face, usually one to five, of 10 to 40 ns.
  [[nodiscard]] MeshPlace settle(int face, const Eigen::Vector3d& from, const Eigen::Vector3d& point) const noexcept;

  /// The point of the mesh nearest to `point`; `guess` is a face near it. Opens at most `node_limit` boxes of the tree (0: no limit, there
  /// are at most two for each face), and returns the nearest point found.
  [[nodiscard]] MeshPlace nearest(const Eigen::Vector3d& point, int guess, int node_limit = 0) const noexcept;

  /// Where a segment enters the solid.
  struct Entry {
    int face;
    double along;  ///< the segment within `Grid::room`, 0 to 1
    Eigen::Vector3d point;
  };
  /// The first entry along the segment beyond `after`. Exact on the grid: a segment from outside to inside always has one. Opens at most 2
  /// boxes for each face, usually some dozens.
  [[nodiscard]] std::optional<Entry> entry(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double after = -1.0) const noexcept;
  /// Whether the point is inside. Exact on the grid.
  [[nodiscard]] bool holds(const Eigen::Vector3d& point) const noexcept;

 private:
  [[nodiscard]] const Face& corners(int face) const noexcept { return solid_.faces[static_cast<std::size_t>(face)]; }
  [[nodiscard]] const Eigen::Vector3d& vertex(int which) const noexcept { return solid_.vertices[static_cast<std::size_t>(which)]; }
  /// A side of a face, from its corner of this number to the next.
  struct Side {
    int face;
    int number;
  };
  [[nodiscard]] static Side next(const Side& side, int steps = 1) noexcept { return {side.face, (side.number + steps) % 3}; }
  [[nodiscard]] Side opposite(const Side& side) const noexcept;
  /// Of the sides that start at a vertex, the next one around it.
  [[nodiscard]] Side around(const Side& side) const noexcept { return opposite(next(side, 2)); }
  [[nodiscard]] const Eigen::Vector3d& start(const Side& side) const noexcept;
  [[nodiscard]] Eigen::Vector3d way(const Side& side) const noexcept { return start(next(side)) - start(side); }
  [[nodiscard]] std::optional<Side> leave(int face, Eigen::Vector3d& here, const Eigen::Vector3d& point) const noexcept;
  [[nodiscard]] std::optional<Side> steepest(Side side, const Eigen::Vector3d& point, bool& in_valley) const noexcept;
  [[nodiscard]] double before(const Side& side, const Eigen::Vector3d& point) const noexcept;
  [[nodiscard]] int passes(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int face) const noexcept;

  ClosedTriangles solid_;
  std::vector<Eigen::Vector3d> normals_;         // of faces
  std::vector<Eigen::Vector3d> vertex_normals_;  // weighted by angle
  double volume_ = 0.0;
};

}  // namespace limitcurve::godobject
