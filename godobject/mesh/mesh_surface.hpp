// SPDX-License-Identifier: MIT
#pragma once

#include "../surface.hpp"
#include "triangle_list.hpp"

#include <memory>
#include <string>

namespace limitcurve::godobject {

class Mesh;

/// A triangle mesh as a Surface. The contact memory has the finger's position, and in contact the
/// face on which its god-object rests, at the face's point nearest to the finger. The god-object
/// slides over the surface towards the finger, and it, not the finger, determines the side: a
/// finger pressed through a thin plate stays on the side from which it came (mesh/README.md).
///
/// For a finger with a coordinate beyond `farthest`, or not finite, the depth is NaN, which makes
/// a SoftFinger `invalid`, and the memory does not change. Copies share the mesh. `contact` does
/// not allocate or lock. It makes at most `rounds` flights and landings, usually one. Each slides
/// over the faces on its way (`Mesh::settle`), one to five at the pace of a hand, and opens up to
/// 2 boxes for each face, usually some dozens. For a finger outside it opens up to `near_limit`
/// boxes.
class MeshSurface {
 public:
  /// Largest number of flights from the surface that end on it again, in one step.
  static constexpr int rounds = 16;
  /// Largest number of boxes opened for the distance of a finger outside; then the nearest point found so far is used.
  static constexpr int near_limit = 1024;

  /// The surface of the solid that the triangles bound. Throws std::invalid_argument, with the face, if they bound none.
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
