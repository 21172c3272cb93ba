// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/mesh_surface.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/touch.hpp"

#include <cmath>

/// What the targets of mesh files share.
namespace limitcurve::fuzz {

/// Triangles that a reader let through: a solid or a complaint; and a solid is touched by fingers at, between and beyond its vertices
/// without falling through it.
inline void touch(const godobject::TriangleList& list) {
  using Eigen::Vector3d;
  require(list.lines.empty() || list.lines.size() == list.faces.size(), "faces without their lines");
  // What takes long is no finding here.
  if (list.faces.size() > 2000) return;
  std::optional<godobject::MeshSurface> surface;
  if (complaint_of([&] { surface.emplace(godobject::Mesh(list)); }) && complaint_of([&] { surface.emplace(godobject::Mesh(list, 1)); })) {
    return;
  }
  const godobject::Mesh& mesh = surface->mesh();
  require(mesh.volume() > 0.0 && is_finite(mesh.volume()), "a solid without a volume");

  godobject::ContactMemory memory;
  Vector3d last = Vector3d::Constant(1.9 * mesh.grid().reach());
  require(!mesh.holds(last), "a place beyond all vertices is inside");
  static_cast<void>(godobject::touch(*surface, last, memory));
#ifdef LIMITCURVE_SEARCHES
  // The reader is what a search is for, and most of the time would go here.
  constexpr std::size_t touches = 50;
#else
  constexpr std::size_t touches = 200;
#endif
  for (std::size_t i = 0; i < touches; ++i) {
    const Vector3d& one = mesh.vertices()[i % mesh.vertices().size()];
    const Vector3d& other = mesh.vertices()[(7 * i + 3) % mesh.vertices().size()];
    const Vector3d finger = i % 3 == 0 ? one : i % 3 == 1 ? Vector3d(0.5 * (one + other)) : Vector3d(1.5 * one - 0.3 * other);
    const bool was_free = memory.face < 0;
    const godobject::ContactMemory before = memory;
    const godobject::Contact contact = godobject::touch(*surface, finger, memory);
    if (finger.cwiseAbs().maxCoeff() > godobject::farthest) {
      // Vertices may be as far out as fingers may, so what is beyond them may be out of range.
      require(contact.depth != contact.depth, "a finger out of range that is not refused");
      require(memory.face == before.face && memory.finger == before.finger && memory.known == before.known, "a refusal that is remembered");
      continue;
    }
    require(contact.point.allFinite() && is_finite(contact.depth), "a contact that is not finite");
    require(std::fabs(contact.normal.norm() - 1.0) < 1e-9, "a normal that is not of unit length");
    require(memory.face >= 0 || !mesh.holds(finger), "a free finger inside");
    require(!was_free || !mesh.holds(finger) || mesh.entry(last, finger), "a way in without an entry");
    last = godobject::vector(memory.finger);
  }
}

}  // namespace limitcurve::fuzz
