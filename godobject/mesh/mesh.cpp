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

Mesh::Mesh(const TriangleList& triangles, int body)
    : solid_(close(triangles, body)), vertex_normals_(solid_.vertices.size(), Vector3d::Zero()) {
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

bool Mesh::above(const MeshPlace& place, const Vector3d& point) const noexcept {
  if (!(height(place.face, point) > 0.0)) return false;
  if (place.part >= part::edge)
    return place.part == part::inside || height(opposite({place.face, place.part - part::edge}).face, point) > 0.0;
  for (Side side = around({place.face, place.part}); side.face != place.face; side = around(side)) {
    if (!(height(side.face, point) > 0.0)) return false;
  }
  return true;
}

MeshPlace Mesh::on(int face, const Vector3d& point) const noexcept {
  const auto& [a, b, c] = corners(face);
  const NearestOnTriangle nearest = nearest_on_triangle(vertex(a), vertex(b), vertex(c), point);
  return {face, nearest.part, nearest.point};
}

inline const Vector3d& Mesh::start(const Side& side) const noexcept {
  return vertex(corners(side.face)[index(side.number)]);
}

/// The same edge as a side of the face beyond, where it runs in the opposite sense.
inline Mesh::Side Mesh::opposite(const Side& side) const noexcept {
  const int beyond = solid_.neighbours[index(side.face)][index(side.number)];
  const int end = corners(side.face)[index((side.number + 1) % 3)];
  return {beyond, static_cast<int>(corners(beyond)[1] == end) + 2 * static_cast<int>(corners(beyond)[2] == end)};
}

/// How far a point is before a side, along the face and times the side's length; negative beyond
/// it.
inline double Mesh::before(const Side& side, const Vector3d& point) const noexcept {
  return normal(side.face).cross(way(side)).dot(point - start(side));
}

/// The side at which the straight way on a face, from `here` to the foot of the point on its
/// plane, ends; moves `here` there. None: the foot is on the face.
inline std::optional<Mesh::Side> Mesh::leave(int face, Vector3d& here, const Vector3d& point) const noexcept {
  const Vector3d descent = point - here - normal(face) * height(face, point);
  if (!(descent.squaredNorm() > 1e-24 * solid_.grid.reach() * solid_.grid.reach())) return std::nullopt;
  std::optional<Side> through;
  double share = 1.0;
  for (const int number : {0, 1, 2}) {
    const Side side{face, number};
    const Vector3d inward = normal(face).cross(way(side));
    const double end = inward.dot(point - start(side));
    if (end >= 0.0) continue;
    const double begin = std::max(inward.dot(here - start(side)), 0.0);
    if (begin <= share * (begin - end)) {
      through = side;
      share = begin / (begin - end);
    }
  }
  here += share * descent;
  return through;
}

/// The steepest way down from the vertex where `side` starts: on a face, as its side that starts
/// there, or in a valley, as one of its sides.
std::optional<Mesh::Side> Mesh::steepest(Side side, const Vector3d& point, bool& in_valley) const noexcept {
  const int first = side.face;
  const Vector3d down = point - start(side);
  std::optional<Side> best;
  double most = 0.0;  // the square of the way to the place nearest to the point
  do {
    const bool within = before(side, point) >= 0.0;
    double fall = 0.0;
    if (within && before(next(side, 2), point) >= 0.0) {
      fall = down.squaredNorm() - std::pow(height(side.face, point), 2);
    } else if (!within && before(opposite(side), point) < 0.0) {
      fall = std::pow(std::max(way(side).dot(down), 0.0), 2) / way(side).squaredNorm();
    }
    if (fall > most) {
      most = fall;
      best = side;
      in_valley = !within;
    }
    side = around(side);
  } while (side.face != first);
  return best;
}

// Steepest descent depends on the solid, not on how its surface is divided. On a face it leads
// straight to the foot of the point on the face's plane, the same foot for all faces in that
// plane. At an edge it goes on beyond if the foot on the plane there is beyond the edge, too. This
// does not depend on the place at the edge, so no edge is crossed both ways. Otherwise both faces
// lead to the edge, a valley: it goes along it to the place nearest to the point, or to a vertex,
// and from there the steepest way.
MeshPlace Mesh::settle(int face, const Vector3d& from, const Vector3d& point) const noexcept {
  const MeshPlace aim = on(face, point);
  if (aim.part == part::inside && height(face, point) <= 0.0) return aim;
  const MeshPlace begin = on(face, from);
  Vector3d here = begin.point;
  Side side{face, begin.part};
  bool at_vertex = begin.part < part::edge;
  bool in_valley = false;
  if (!at_vertex && begin.part != part::inside) {
    // In a crease the wall holds that the point is beneath.
    const int beyond = opposite({face, begin.part - part::edge}).face;
    if (height(beyond, point) < height(face, point)) side.face = beyond;
  }
  for (std::size_t left = solid_.faces.size(); left > 0; --left) {
    if (!at_vertex && !in_valley) {
      const auto through = leave(side.face, here, point);
      if (!through) break;
      const Side beyond = opposite(*through);
      in_valley = before(beyond, point) < 0.0;
      side = in_valley ? *through : beyond;
      if (!in_valley) continue;
    }
    if (in_valley) {
      const double along = way(side).dot(point - start(side));
      if (along > 0.0 && along < way(side).squaredNorm()) break;
      if (along > 0.0) side = next(side);
    }
    const auto down = steepest(side, point, in_valley);
    if (!down) break;
    side = *down;
    here = start(side);
    at_vertex = false;
  }
  return on(side.face, point);
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
    if (along > after && (!first || along < first->along) && passes(start, end, face) > 0)
      first = Entry{face, along, start + along * (end - start)};
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
