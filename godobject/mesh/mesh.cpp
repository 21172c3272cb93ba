// SPDX-License-Identifier: MIT
#include "godobject/mesh/mesh.hpp"

#include "godobject/mesh/triangle.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve::godobject {

using Eigen::Vector3d;

namespace {

std::size_t index(int value) {
  return static_cast<std::size_t>(value);
}

/// The part of a segment within |x|, |y|, |z| ≤ bound; false if there is none.
bool clip(Vector3d& from, Vector3d& to, double bound) noexcept {
  if ((from.cwiseAbs().array() <= bound).all() && (to.cwiseAbs().array() <= bound).all()) return true;
  const Vector3d way = to - from;
  double begin = 0.0;
  double end = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {1.0, -1.0}) {
      const double before = side * from[axis] - bound;
      const double after = side * to[axis] - bound;
      if (before > 0.0 && after > 0.0) return false;
      if (before > 0.0) begin = std::max(begin, before / (before - after));
      if (after > 0.0) end = std::min(end, before / (before - after));
    }
  }
  if (begin > end) return false;
  const Vector3d start = from;
  if (begin > 0.0) from = (start + begin * way).cwiseMax(-bound).cwiseMin(bound);
  if (end < 1.0) to = (start + end * way).cwiseMax(-bound).cwiseMin(bound);
  return true;
}

}  // namespace

Mesh::Mesh(const TriangleList& triangles) : solid_(close(triangles)), vertex_normals_(solid_.vertices.size(), Vector3d::Zero()) {
  normals_.reserve(solid_.faces.size());
  Volume volume;
  for (const Face& face : solid_.faces) {
    const Vector3d& a = vertex(face[0]);
    normals_.push_back(solid_.grid.cross(vertex(face[1]) - a, vertex(face[2]) - a).normalized());
    volume.add(solid_.grid, a - vertex(0), vertex(face[1]) - vertex(0), vertex(face[2]) - vertex(0));
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d one = vertex(face[(i + 1) % 3]) - vertex(face[i]);
      const Vector3d other = vertex(face[(i + 2) % 3]) - vertex(face[i]);
      vertex_normals_[index(face[i])] += std::atan2(one.cross(other).norm(), one.dot(other)) * normals_.back();
    }
  }
  for (Vector3d& normal : vertex_normals_) normal.normalize();
  volume_ = volume.value(solid_.grid);
}

Vector3d Mesh::outward(const MeshPlace& place) const noexcept {
  if (place.part == part::inside) return normal(place.face);
  if (place.part < part::edge) return vertex_normals_[index(corners(place.face)[index(place.part)])];
  const int beyond = solid_.neighbours[index(place.face)][index(place.part - part::edge)];
  return (normal(place.face) + normal(beyond)).normalized();
}

bool Mesh::flat(const MeshPlace& place) const noexcept {
  if (place.part == part::inside) return true;
  if (place.part < part::edge) return false;
  const int beyond = solid_.neighbours[index(place.face)][index(place.part - part::edge)];
  return (normal(place.face) - normal(beyond)).squaredNorm() < 1e-20;
}

double Mesh::height(int face, const Vector3d& point) const noexcept {
  return normal(face).dot(point - vertex(corners(face)[0]));
}

MeshPlace Mesh::on(int face, const Vector3d& point) const noexcept {
  const auto& [a, b, c] = corners(face);
  const NearestOnTriangle nearest = nearest_on_triangle(vertex(a), vertex(b), vertex(c), point);
  return {face, nearest.part, nearest.point};
}

MeshPlace Mesh::settle(int face, const Vector3d& point) const noexcept {
  MeshPlace here = on(face, point);
  double least = (point - here.point).squaredNorm();
  // Each face has one nearest point, and the next one is nearer: so no face is come to twice, except by rounding.
  for (std::size_t left = solid_.faces.size(); left > 0 && here.part != part::inside; --left) {
    MeshPlace next = here;
    if (here.part >= part::edge) {
      const int beyond = solid_.neighbours[index(here.face)][index(here.part - part::edge)];
      const MeshPlace there = on(beyond, point);
      const int from = corners(here.face)[index((here.part - part::edge + 1) % 3)];
      const Face& there_corners = corners(beyond);
      // In the face beyond, the shared edge runs in the opposite sense.
      const int side = static_cast<int>(std::find(there_corners.begin(), there_corners.end(), from) - there_corners.begin());
      // Both faces have their nearest point on the shared edge: a local minimum.
      if (part::on_edge(there.part, side)) break;
      next = there;
    } else {
      // Once around the vertex: the nearest point that is not the vertex itself.
      const int centre = corners(here.face)[index(here.part)];
      double best = std::numeric_limits<double>::infinity();
      int around = here.face;
      int corner = here.part;
      do {
        around = solid_.neighbours[index(around)][index((corner + 2) % 3)];
        const Face& at = corners(around);
        corner = static_cast<int>(std::find(at.begin(), at.end(), centre) - at.begin());
        if (around == here.face) break;
        const MeshPlace there = on(around, point);
        const double square = (point - there.point).squaredNorm();
        if (there.part != corner && square < best) {
          best = square;
          next = there;
        }
      } while (true);
      if (next.face == here.face) break;
    }
    // By rounding the next point may be farther by 1e-12; stop if it is more.
    const double square = (point - next.point).squaredNorm();
    if (!(square <= least * (1.0 + 1e-12))) break;
    least = std::min(least, square);
    here = next;
  }
  return here;
}

MeshPlace Mesh::nearest(const Vector3d& point, int guess, int node_limit) const noexcept {
  MeshPlace best = on(guess, point);
  double least = (point - best.point).squaredNorm();
  const int limit = node_limit > 0 ? node_limit : std::numeric_limits<int>::max();
  solid_.tree.near(point, least, limit, [&](int face) {
    const MeshPlace place = on(face, point);
    const double square = (point - place.point).squaredNorm();
    if (square < least) {
      least = square;
      best = place;
    }
    return least;
  });
  return best;
}

int Mesh::passes(const Vector3d& from, const Vector3d& to, int face) const noexcept {
  const auto& [a, b, c] = corners(face);
  return crossing(solid_.grid, from, to, vertex(a), vertex(b), vertex(c));
}

std::optional<Mesh::Entry> Mesh::entry(const Vector3d& from, const Vector3d& to, double after) const noexcept {
  const Grid& grid = solid_.grid;
  Vector3d start = from;
  Vector3d end = to;
  if (!clip(start, end, Grid::room * grid.reach())) return std::nullopt;
  start = grid.snap(start);
  end = grid.snap(end);
  std::optional<Entry> first;
  solid_.tree.along(start, end, grid.step(), [&](int face) {
    const double before = height(face, start);
    const double now = height(face, end);
    const double along = before > now ? std::clamp(before / (before - now), 0.0, 1.0) : 0.0;
    if (along > after && (!first || along < first->along) && passes(start, end, face) > 0) first = Entry{face, along};
    return first ? first->along : 1.0;
  });
  return first;
}

bool Mesh::holds(const Vector3d& point) const noexcept {
  const Tree& tree = solid_.tree;
  // Snap to the grid first, as `entry` does: a point just outside the boxes may be rounded on to a face, and then the tie-break decides.
  const Vector3d start = solid_.grid.snap(point);
  if (((start - tree.high()).array() > 0.0).any() || ((tree.low() - start).array() > 0.0).any()) return false;
  Vector3d end = start;
  end.x() = std::copysign(Grid::room * solid_.grid.reach(), start.x() - 0.5 * (tree.low().x() + tree.high().x()));
  int left = 0;  // exits minus entries of a ray from the point
  tree.along(start, end, solid_.grid.step(), [&](int face) {
    left -= passes(start, end, face);
    return 1.0;
  });
  return left > 0;
}

}  // namespace limitcurve::godobject
