// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/triangle_list.hpp"
#include "godobject/surface.hpp"

#include <memory>
#include <string>

namespace limitcurve::godobject {

class Mesh;

/// A mesh to touch. The finger's memory holds its god-object: while it touches, the place on the surface where it rests, which slides from
/// face to face towards the finger; else the finger itself. So the god-object decides on which side the finger is, not the
/// finger: pressed through a thin plate it stays on the side it came from (README, "Meshes").
///
/// Copies share the mesh. `contact` allocates nothing and takes no lock; it looks at up to `Mesh::walk_limit` faces and the faces around
/// one vertex for each of `rounds` flights and landings at most (one as a rule), and while the finger is not in the solid opens up
/// to `near_limit` boxes, and in each flight up to 2 boxes a face, as a rule some dozens.
class MeshSurface {
 public:
  /// A finger farther than this from the origin [m], or not finite, is refused: the depth is NaN, which a SoftFinger takes for
  /// `invalid`, and the memory is the one given.
  static constexpr double farthest = 1e6;
  /// Flights from the surface that end on it again, within one step.
  static constexpr int rounds = 16;
  /// Boxes opened for the distance of a finger that does not touch; then the nearest place found by then counts.
  static constexpr int near_limit = 1024;

  /// Of the solid that the triangles bound; throws std::invalid_argument where they bound none, naming the face.
  explicit MeshSurface(const TriangleList& triangles);
  explicit MeshSurface(Mesh mesh);
  explicit MeshSurface(std::shared_ptr<const Mesh> mesh);  ///< throws std::invalid_argument if there is none

  [[nodiscard]] const Mesh& mesh() const noexcept { return *mesh_; }
  [[nodiscard]] Contact contact(const Eigen::Vector3d& finger, const ContactMemory& memory) const noexcept;

 private:
  std::shared_ptr<const Mesh> mesh_;
};

static_assert(Surface<MeshSurface>);

}  // namespace limitcurve::godobject
