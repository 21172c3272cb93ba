// SPDX-License-Identifier: MIT
#include "godobject/mesh/self_intersection.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

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

/// The box of a direction or of several, with room for what lies between them on the unit sphere and for rounding.
struct DirectionBox {
  Vector3d low, high;

  explicit DirectionBox(std::span<const Vector3d> directions) : low(directions[0]), high(directions[0]) {
    double cosine = 1.0;  // the least between two directions
    for (const Vector3d& one : directions) {
      low = low.cwiseMin(one);
      high = high.cwiseMax(one);
      for (const Vector3d& other : directions) cosine = std::min(cosine, one.dot(other));
    }
    // A mean of n unit vectors is at least this long, and its direction farther out by the rest.
    const auto n = static_cast<double>(directions.size());
    const double room = 1.0 - std::sqrt(std::max((1.0 + (n - 1.0) * cosine) / n, 0.0)) + 1e-12;
    low.array() -= room;
    high.array() += room;
  }
};

class Search {
 public:
  explicit Search(const ClosedTriangles& triangles)
      : triangles_(triangles), meeting_(triangles.grid), compared_(triangles.faces.size(), 0) {}

  std::optional<std::pair<int, int>> run() {
    std::vector<std::vector<int>> around(triangles_.vertices.size());
    for (int i = 0; i < static_cast<int>(triangles_.faces.size()); ++i) {
      for (const int vertex : face(i)) around[static_cast<std::size_t>(vertex)].push_back(i);
    }
    for (std::size_t i = 0; i < around.size() && !found_; ++i) {
      if (around[i].size() <= hub) continue;
      search_hub(static_cast<int>(i), around[i]);
      for (const int one : around[i]) compared_[static_cast<std::size_t>(one)] = 1;
    }
    std::vector<int> others;
    std::vector<Face> faces;
    for (int i = 0; i < static_cast<int>(triangles_.faces.size()); ++i) {
      if (compared_[static_cast<std::size_t>(i)] != 0) continue;
      others.push_back(i);
      faces.push_back(face(i));
    }
    if (!others.empty()) search_boxes(others, Tree(triangles_.vertices, faces));
    return found_;
  }

 private:
  /// Vertices of more faces are hubs. The boxes of all faces around a hub overlap: they would be compared with each other, in pairs, and with
  /// many others. Seen from the hub they are short arcs side by side, and faces that meet are in the same direction.
  static constexpr std::size_t hub = 64;

  [[nodiscard]] const Face& face(int which) const { return triangles_.faces[static_cast<std::size_t>(which)]; }
  [[nodiscard]] const Vector3d& vertex(int which) const { return triangles_.vertices[static_cast<std::size_t>(which)]; }
  [[nodiscard]] bool has(int which, int vertex) const {
    return std::find(face(which).begin(), face(which).end(), vertex) != face(which).end();
  }

  void compare(int i, int j) {
    if (found_) return;
    const Face& one = face(i);
    const Face& other = face(j);
    const auto shared = std::count_if(one.begin(), one.end(), [&](int v) { return has(j, v); });
    const bool meet = shared == 3   ? true
                      : shared == 2 ? folded(triangles_, meeting_, one, other)
                                    : edges_meet(triangles_, meeting_, one, other) || edges_meet(triangles_, meeting_, other, one);
    if (meet) found_ = std::minmax(i, j);
  }

  /// Compares faces whose boxes overlap; the tree has their indices in `which`.
  void search_boxes(const std::vector<int>& which, const Tree& tree) {
    for (int i = 0; i < static_cast<int>(which.size()) && !found_; ++i) {
      const int one = which[static_cast<std::size_t>(i)];
      const Corners t = corners(triangles_, face(one));
      tree.overlapping(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]), [&](int j) {
        if (j > i) compare(one, which[static_cast<std::size_t>(j)]);
      });
    }
  }

  /// Compares the faces around a hub with each other, and with all others.
  void search_hub(int centre, const std::vector<int>& around) {
    const auto direction = [&](int to) { return Vector3d((vertex(to) - vertex(centre)).normalized()); };
    std::vector<Vector3d> ends;  // the low and the high corner of each arc's box
    std::vector<Face> boxes;
    Vector3d low = vertex(centre);
    Vector3d high = low;
    for (const int one : around) {
      std::vector<Vector3d> arc;
      for (const int corner : face(one)) {
        low = low.cwiseMin(vertex(corner));
        high = high.cwiseMax(vertex(corner));
        if (corner != centre) arc.push_back(direction(corner));
      }
      const DirectionBox box(arc);
      const int first = static_cast<int>(ends.size());
      ends.insert(ends.end(), {box.low, box.high});
      boxes.push_back({first, first + 1, first + 1});
    }
    const Tree arcs(ends, boxes);
    const auto at = [&](int which) { return around[static_cast<std::size_t>(which)]; };
    for (std::size_t i = 0; i < around.size() && !found_; ++i) {
      arcs.overlapping(ends[2 * i], ends[2 * i + 1], [&](int j) {
        if (at(j) > around[i]) compare(around[i], at(j));
      });
    }
    triangles_.tree.overlapping(low, high, [&](int other) {
      if (found_ || has(other, centre) || compared_[static_cast<std::size_t>(other)] != 0) return;
      Corners t = corners(triangles_, face(other));
      for (Vector3d& corner : t) corner -= vertex(centre);
      // In its plane the hub may be on the face; else the face is in the cone of the three planes through the hub and its edges.
      const int side = triangles_.grid.sign(t[0], t[1], t[2]);
      if (side == 0) compare(other, around[0]);
      const DirectionBox seen(Corners{t[0].normalized(), t[1].normalized(), t[2].normalized()});
      const Corners planes{side * t[0].cross(t[1]), side * t[1].cross(t[2]), side * t[2].cross(t[0])};
      const auto meets = [&](const Vector3d& from, const Vector3d& to) {
        if (((from - seen.high).array() > 0.0).any() || ((seen.low - to).array() > 0.0).any()) return false;
        for (std::size_t i = 0; i < 3; ++i) {
          const double rounding = 1e-14 * t[i].norm() * t[(i + 1) % 3].norm();
          if (planes[i].dot(from + to) + planes[i].cwiseAbs().dot(to - from) < -rounding) return false;
        }
        return true;
      };
      arcs.where(meets, [&](int j) { compare(other, at(j)); });
    });
  }

  const ClosedTriangles& triangles_;
  Meeting meeting_;
  std::vector<char> compared_;  // faces that were compared with all others
  std::optional<std::pair<int, int>> found_;
};

}  // namespace

std::optional<std::pair<int, int>> find_self_intersection(const ClosedTriangles& triangles) {
  return Search(triangles).run();
}

}  // namespace limitcurve::godobject
