// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh_surface.hpp"

#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::godobject {

using Eigen::Vector3d;

namespace {

/// Code of the nearest face in the memory of a finger outside.
int remembered(int face) noexcept {
  return -2 - face;
}

/// The contact of a finger whose god-object rests at `place`; `landed`: after a flight from the surface.
Contact touched(const Mesh& mesh, const MeshPlace& place, const Vector3d& finger, bool landed) noexcept {
  const ContactMemory memory{place.face, numbers(finger), true};
  if (mesh.flat(place)) {
    const Vector3d& normal = mesh.normal(place.face);
    const double depth = -mesh.height(place.face, finger);
    return {finger + normal * depth, normal, depth, memory, landed};
  }
  // In a crease or a pit the normal is the direction from the finger to the god-object, which turns continuously from one face's normal to
  // the other's.
  const Vector3d way = place.point - finger;
  const double depth = way.norm();
  const Vector3d outward = mesh.outward(place);
  if (depth > 1e-9 * mesh.grid().reach()) {
    const double side = way.dot(outward) >= 0.0 ? 1.0 : -1.0;
    return {place.point, way * (side / depth), side * depth, memory, landed};
  }
  return {place.point, outward, way.dot(outward), memory, landed};
}

/// The contact of a finger outside; `guess` is a face near it.
Contact free_contact(const Mesh& mesh, const Vector3d& finger, int guess) noexcept {
  const MeshPlace place = mesh.nearest(finger, guess, MeshSurface::near_limit);
  const ContactMemory memory{remembered(place.face), numbers(finger), true};
  const Vector3d away = finger - place.point;
  const double gap = away.norm();
  // On the surface, within the grid, use the surface's normal.
  if (gap > 1e-9 * mesh.grid().reach()) return {place.point, away / gap, -gap, memory};
  return {place.point, mesh.outward(place), -gap, memory};
}

/// Whether a way leads out of the solid and in again.
bool reenters(const Mesh& mesh, const Vector3d& from, const Vector3d& to) noexcept {
  auto entry = mesh.entry(from, to);
  if (entry && !mesh.holds(from)) entry = mesh.entry(from, to, entry->along);
  return entry.has_value();
}

}  // namespace

MeshSurface::MeshSurface(Mesh mesh) : mesh_(std::make_shared<const Mesh>(std::move(mesh))) {}

MeshSurface::MeshSurface(const TriangleList& triangles) : MeshSurface(Mesh(triangles)) {}

MeshSurface::MeshSurface(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {
  if (!mesh_) throw std::invalid_argument("mesh: none given, expected one");
}

Contact MeshSurface::contact(const Vector3d& finger, const ContactMemory& memory) const noexcept {
  // NaN also fails this comparison.
  if (!(finger.cwiseAbs().array() <= farthest).all())
    return {Vector3d::Zero(), Vector3d::UnitZ(), std::numeric_limits<double>::quiet_NaN(), memory};
  const int faces = static_cast<int>(mesh_->faces().size());
  const double touching = 1e-9 * mesh_->grid().reach();
  const Vector3d last = vector(memory.finger);
  const bool held = memory.known && memory.face >= 0 && memory.face < faces;
  int face = memory.face;
  Vector3d from = last;
  bool landed = false;
  if (held) {
    // Landed is what left: the finger's own way, from its last place to this one, leads out of the
    // solid and in again. Then its god-object flies, even where a slide would lead to the same
    // place: from wall to wall of a corner.
    if (mesh_->height(face, finger) > 0.0 && reenters(*mesh_, last, finger)) {
      const MeshPlace rest = mesh_->on(face, last);
      const auto entry = mesh_->above(rest, finger) ? mesh_->entry(rest.point, finger) : std::nullopt;
      if (entry) {
        face = entry->face;
        from = entry->point;
        landed = true;
      }
    }
  } else if (memory.known && face < 0) {
    const auto entry = mesh_->entry(last, finger);
    if (!entry) return free_contact(*mesh_, finger, face <= remembered(0) && face >= remembered(faces - 1) ? remembered(face) : 0);
    face = entry->face;
    from = entry->point;
  } else {
    // Without memory: a finger inside counts as having entered through the nearest face.
    if (!mesh_->holds(finger)) return free_contact(*mesh_, finger, 0);
    face = mesh_->nearest(finger, 0).face;
  }
  MeshPlace place = mesh_->settle(face, from, finger);
  double after = -1.0;
  for (int round = 0; round < rounds; ++round) {
    const double depth = mesh_->flat(place) ? -mesh_->height(place.face, finger) : mesh_->outward(place).dot(place.point - finger);
    if (depth > 0.0) return touched(*mesh_, place, finger, landed);
    // The finger is outside the face: the god-object flies to the finger, or to the first face in between.
    const auto entry = mesh_->entry(place.point, finger, after);
    if (!entry) {
      if (!mesh_->holds(finger)) return free_contact(*mesh_, finger, place.face);
      break;  // inside, but not beneath the face: by less than the grid
    }
    const MeshPlace next = mesh_->settle(entry->face, entry->point, finger);
    // By rounding the god-object may seem to enter the face that it leaves: look for the next entry.
    const bool stays = (next.point - place.point).squaredNorm() <= touching * touching;
    after = stays ? entry->along : -1.0;
    landed = landed || (held && (entry->point - place.point).norm() > touching && mesh_->entry(last, finger));
    place = next;
  }
  Contact contact = touched(*mesh_, place, finger, landed);
  contact.depth = std::min(contact.depth, 0.0);
  return contact;
}

}  // namespace limitcurve::godobject
