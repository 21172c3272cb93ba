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
  /// Checks and repairs the triangles with `close`; throws std::invalid_argument.
  explicit Mesh(const TriangleList& triangles);

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

  /// Slides from a face along the surface to a local minimum of the distance to the point, from face to face, never away from the point and
  /// never through the surface. It comes to each face once at most, and so always arrives. 5 to 20 ns for each face on the way, and for
  /// those around a vertex on it.
  [[nodiscard]] MeshPlace settle(int face, const Eigen::Vector3d& point) const noexcept;

  /// The point of the mesh nearest to `point`; `guess` is a face near it. Opens at most `node_limit` boxes of the tree (0: no limit, there
  /// are at most two for each face), and returns the nearest point found.
  [[nodiscard]] MeshPlace nearest(const Eigen::Vector3d& point, int guess, int node_limit = 0) const noexcept;

  /// The face through which a segment enters the solid, and the position along the segment, 0 to 1.
  struct Entry {
    int face;
    double along;
  };
  /// The first entry along the segment beyond `after`. Exact on the grid: a segment from outside to inside always has one. Opens at most 2
  /// boxes for each face, usually some dozens.
  [[nodiscard]] std::optional<Entry> entry(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double after = -1.0) const noexcept;
  /// Whether the point is inside. Exact on the grid.
  [[nodiscard]] bool holds(const Eigen::Vector3d& point) const noexcept;

 private:
  [[nodiscard]] const Face& corners(int face) const noexcept { return solid_.faces[static_cast<std::size_t>(face)]; }
  [[nodiscard]] const Eigen::Vector3d& vertex(int which) const noexcept { return solid_.vertices[static_cast<std::size_t>(which)]; }
  [[nodiscard]] MeshPlace on(int face, const Eigen::Vector3d& point) const noexcept;
  [[nodiscard]] int passes(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int face) const noexcept;

  ClosedTriangles solid_;
  std::vector<Eigen::Vector3d> normals_;         // of faces
  std::vector<Eigen::Vector3d> vertex_normals_;  // weighted by angle
  double volume_ = 0.0;
};

}  // namespace limitcurve::godobject
