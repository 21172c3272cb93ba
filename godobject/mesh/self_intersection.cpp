// SPDX-License-Identifier: MIT
#include "godobject/mesh/self_intersection.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace limitcurve::godobject {

namespace {

using Eigen::Vector3d;
using Corners = std::array<Vector3d, 3>;

/// Exact intersection tests of closed segments and triangles with corners on the grid; touching counts as meeting.
class Meeting {
 public:
  explicit Meeting(const Grid& grid) : grid_(grid) {}

  [[nodiscard]] int side(const Vector3d& point, const Corners& t) const { return grid_.sign(point - t[0], t[1] - t[0], t[2] - t[0]); }

  [[nodiscard]] bool segment_and_triangle(const Vector3d& p, const Vector3d& q, const Corners& t) const {
    const int at_p = side(p, t);
    const int at_q = side(q, t);
    if (at_p == 0 && at_q == 0) return in_one_plane(p, q, t);
    if (at_p == at_q) return false;
    // The segment reaches the plane. It meets the triangle if its line has all edges on the same side.
    const Vector3d way = q - p;
    bool left = false;
    bool right = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const int passes = grid_.sign(way, t[i] - p, t[(i + 1) % 3] - p);
      left = left || passes > 0;
      right = right || passes < 0;
    }
    return !(left && right);
  }

 private:
  /// The turn of the corner a, b, c, seen along the axis: 1, −1, or 0 for a straight line.
  [[nodiscard]] int turn(const Vector3d& a, const Vector3d& b, const Vector3d& c, int axis) const {
    const double component = grid_.cross(b - a, c - a)[axis];
    return component > 0.0 ? 1 : component < 0.0 ? -1 : 0;
  }

  [[nodiscard]] bool segments(const Vector3d& p, const Vector3d& q, const Vector3d& a, const Vector3d& b, int axis) const {
    const int a_side = turn(p, q, a, axis);
    const int b_side = turn(p, q, b, axis);
    const int p_side = turn(a, b, p, axis);
    const int q_side = turn(a, b, q, axis);
    if (a_side == 0 && b_side == 0) {
      // Both on one line: they meet if their boxes do.
      return ((p.cwiseMin(q) - a.cwiseMax(b)).array() <= 0.0).all() && ((a.cwiseMin(b) - p.cwiseMax(q)).array() <= 0.0).all();
    }
    return a_side * b_side <= 0 && p_side * q_side <= 0;
  }

  [[nodiscard]] bool in_one_plane(const Vector3d& p, const Vector3d& q, const Corners& t) const {
    int axis = 0;
    grid_.cross(t[1] - t[0], t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
    bool left = false;
    bool right = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d& next = t[(i + 1) % 3];
      if (segments(p, q, t[i], next, axis)) return true;
      const int turns = turn(t[i], next, p, axis);
      left = left || turns > 0;
      right = right || turns < 0;
    }
    return !(left && right);  // the whole segment is inside
  }

  const Grid& grid_;
};

Corners corners(const ClosedTriangles& triangles, const Face& face) {
  Corners result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = triangles.vertices[static_cast<std::size_t>(face[i])];
  return result;
}

/// Whether an edge of `one` meets the triangle `other`, except at vertices that both share.
bool edges_meet(const ClosedTriangles& triangles, const Meeting& meeting, const Face& one, const Face& other) {
  const Corners t = corners(triangles, one);
  const Corners u = corners(triangles, other);
  const auto shared = [&](int vertex) { return std::find(other.begin(), other.end(), vertex) != other.end(); };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    // An edge from a shared vertex meets `other` there. If both meet elsewhere, the opposite edge meets it, too.
    if (!shared(one[i]) && !shared(one[next]) && meeting.segment_and_triangle(t[i], t[next], u)) return true;
  }
  return false;
}

bool folded(const ClosedTriangles& triangles, const Meeting& meeting, const Face& one, const Face& other) {
  const Corners t = corners(triangles, one);
  const Corners u = corners(triangles, other);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool shared = std::find(one.begin(), one.end(), other[i]) != one.end();
    if (!shared && meeting.side(u[i], t) != 0) return false;
  }
  // Both are in one plane. They overlap if their other corners are on the same side of the shared edge: then the normals are opposite if
  // both run along the edge in opposite senses.
  const Vector3d normal = triangles.grid.cross(t[1] - t[0], t[2] - t[0]);
  const Vector3d other_normal = triangles.grid.cross(u[1] - u[0], u[2] - u[0]);
  // Faces may not be oriented consistently yet: compare their senses along the shared edge.
  int senses = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (one[i] == other[j] && one[(i + 1) % 3] == other[(j + 1) % 3]) senses = 1;
    }
  }
  const bool same_way = normal.dot(other_normal) > 0.0;
  return senses == 1 ? same_way : !same_way;
}

}  // namespace

std::optional<std::pair<int, int>> find_self_intersection(const ClosedTriangles& triangles) {
  const Meeting meeting(triangles.grid);
  const int count = static_cast<int>(triangles.faces.size());
  std::optional<std::pair<int, int>> found;
  for (int i = 0; i < count && !found; ++i) {
    const Face& one = triangles.faces[static_cast<std::size_t>(i)];
    const Corners t = corners(triangles, one);
    const Vector3d low = t[0].cwiseMin(t[1]).cwiseMin(t[2]);
    const Vector3d high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    triangles.tree.overlapping(low, high, [&](int j) {
      if (found || j <= i) return;
      const Face& other = triangles.faces[static_cast<std::size_t>(j)];
      const auto shared =
          std::count_if(one.begin(), one.end(), [&](int v) { return std::find(other.begin(), other.end(), v) != other.end(); });
      const bool meet = shared == 3   ? true
                        : shared == 2 ? folded(triangles, meeting, one, other)
                                      : edges_meet(triangles, meeting, one, other) || edges_meet(triangles, meeting, other, one);
      if (meet) found = std::pair(i, j);
    });
  }
  return found;
}

}  // namespace limitcurve::godobject
