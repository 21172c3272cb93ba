// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/closed_triangles.hpp"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// A place on a mesh: on a face, and on which part of it (triangle.hpp).
struct MeshPlace {
  int face = 0;
  int part = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< [m]
};

/// The surface of a solid as triangles, checked when it is made and never changed: many fingers and threads may share one. Questions
/// are noexcept, allocate nothing and take no lock.
class Mesh {
 public:
  /// How many faces `settle` looks at, to which the faces around one vertex may come.
  static constexpr int walk_limit = 256;

  /// Throws std::invalid_argument; see `close`, which also says what is mended.
  explicit Mesh(const TriangleList& triangles);

  [[nodiscard]] std::span<const Eigen::Vector3d> vertices() const noexcept { return solid_.vertices; }
  [[nodiscard]] std::span<const Face> faces() const noexcept { return solid_.faces; }
  [[nodiscard]] const MeshRepairs& repairs() const noexcept { return solid_.repairs; }
  [[nodiscard]] const Grid& grid() const noexcept { return solid_.grid; }
  [[nodiscard]] double volume() const noexcept { return volume_; }  ///< [m³] > 0
  /// The outward unit normal of a face.
  [[nodiscard]] const Eigen::Vector3d& normal(int face) const noexcept { return normals_[static_cast<std::size_t>(face)]; }

  /// The outward direction at a place, of unit length: the face's normal, at an edge the mean of two, at a vertex the mean
  /// weighted by the faces' angles. Where the place is the nearest to a point, its sign says on which side that is.
  /// Source: J. A. Bærentzen, H. Aanæs, IEEE Trans. Vis. Comput. Graph. 11:243–253, 2005.
  [[nodiscard]] Eigen::Vector3d outward(const MeshPlace& place) const noexcept;
  /// Whether the place is inside a face, or on an edge where two faces lie in one plane.
  [[nodiscard]] bool flat(const MeshPlace& place) const noexcept;
  /// The height of a point over a face's plane [m].
  [[nodiscard]] double height(int face, const Eigen::Vector3d& point) const noexcept;

  /// Where a place that starts on a face and slides towards the point comes to rest: from face to face, never away from the
  /// point, never through the surface, to a place that has none nearer about it. It may rest early, after `walk_limit` faces.
  [[nodiscard]] MeshPlace settle(int face, const Eigen::Vector3d& point) const noexcept;

  /// The place nearest the point; `guess` is a face near it. Opens `node_limit` boxes of the tree at most (all of them, 2 a face,
  /// if 0) and gives the nearest found by then.
  [[nodiscard]] MeshPlace nearest(const Eigen::Vector3d& point, int guess, int node_limit = 0) const noexcept;

  /// A face by which a segment enters the solid, and where along it that is.
  struct Entry {
    int face;
    double along;
  };
  /// The first entry from outside beyond `after`, along the segment. Exact on the grid: from a point outside to one inside there is one
  /// always. Opens at most 2 boxes a face, as a rule some dozens.
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
