// SPDX-License-Identifier: MIT
#include "godobject/mesh/mend.hpp"

#include "limitcurve/internal/number.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace limitcurve::godobject {

namespace {

using Eigen::Vector3d;

class Mending {
 public:
  explicit Mending(const TriangleList& triangles) : given_(triangles) {}

  MendedTriangles run(int body) {
    weld();
    result_.repairs.dropped = drop();
    // One pass or two, but for slivers in a row.
    for (int pass = 0; pass < 100 && take_out_slivers();) ++pass;
    number_bodies();
    if (body != 0) keep(body);
    if (result_.faces.size() < 4) {
      fail(joined({std::to_string(result_.faces.size()), " faces with an area, expected at least 4 (a tetrahedron)"}));
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw std::invalid_argument(joined({given_.name, ": ", what})); }

  [[nodiscard]] const Vector3d& vertex(int which) const { return result_.vertices[index(which)]; }

  /// Snaps the vertices that faces use to the grid, and merges vertices at the same grid point.
  void weld() {
    double largest = 0.0;
    for (std::size_t i = 0; i < given_.faces.size(); ++i) {
      for (const int corner : given_.faces[i]) {
        if (corner < 0 || index(corner) >= given_.vertices.size()) {
          throw std::invalid_argument(joined({given_.place(i), " has the vertex ", std::to_string(corner), ", of ",
                                              std::to_string(given_.vertices.size()), " counted from 0"}));
        }
        const double size = given_.vertices[index(corner)].cwiseAbs().maxCoeff();
        if (!(size <= 1e6) || !given_.vertices[index(corner)].allFinite()) {
          throw std::invalid_argument(joined({given_.place(i), " has a vertex that is not within 1e6 m of the origin"}));
        }
        largest = std::max(largest, size);
      }
    }
    if (given_.faces.size() < 4) fail(joined({std::to_string(given_.faces.size()), " faces, expected at least 4 (a tetrahedron)"}));
    if (given_.faces.size() > index(std::numeric_limits<int>::max() / 4)) fail("too many faces, expected up to 5e8");
    if (!(largest >= 1e-6)) fail(joined({"its farthest coordinate is ", format_number(largest), " m, expected at least 1e-6 m"}));
    result_.grid = Grid(largest);

    const auto before = [](const Vector3d& a, const Vector3d& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::vector<char> used(given_.vertices.size(), 0);
    for (const Face& face : given_.faces) {
      for (const int corner : face) used[index(corner)] = 1;
    }
    // In order of first use, so that vertices keep their order.
    std::map<Vector3d, int, decltype(before)> known(before);
    std::vector<int> number(given_.vertices.size(), -1);
    for (std::size_t i = 0; i < given_.vertices.size(); ++i) {
      if (used[i] == 0) continue;
      // Adding 0 turns −0 into 0.
      const Vector3d place = result_.grid.snap(given_.vertices[i]) + Vector3d::Zero();
      const auto [found, is_new] = known.try_emplace(place, static_cast<int>(result_.vertices.size()));
      if (is_new) {
        result_.vertices.push_back(place);
        result_.given_vertex.push_back(i);
      } else {
        ++result_.repairs.welded;
      }
      number[i] = found->second;
    }
    for (std::size_t i = 0; i < given_.faces.size(); ++i) {
      const auto& [a, b, c] = given_.faces[i];
      result_.faces.push_back({number[index(a)], number[index(b)], number[index(c)]});
      result_.given_face.push_back(i);
    }
  }

  /// Leaves out faces with two equal corners; returns their number.
  int drop() {
    std::vector<char> dropped;
    for (const auto& [a, b, c] : result_.faces) dropped.push_back(a == b || b == c || c == a);
    leave_out(dropped);
    return static_cast<int>(std::count(dropped.begin(), dropped.end(), 1));
  }

  void leave_out(const std::vector<char>& dropped) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < dropped.size(); ++i) {
      if (dropped[i] != 0) continue;
      result_.faces[kept] = result_.faces[i];
      result_.given_face[kept++] = result_.given_face[i];
    }
    result_.faces.resize(kept);
    result_.given_face.resize(kept);
  }

  [[nodiscard]] double length(int one, int other) const { return (vertex(one) - vertex(other)).norm(); }

  [[nodiscard]] bool is_thin(const Face& face) const { return thinness(result_.grid, result_.vertices, face) < thinnest_face; }

  /// The corners of a sliver that is no higher than two spacings of a float, its longest edge
  /// first; nothing for another face.
  [[nodiscard]] std::optional<Face> sliver(Face face) const {
    if (!is_thin(face)) return std::nullopt;
    for (int turns = 0; length(face[0], face[1]) < std::max(length(face[1], face[2]), length(face[2], face[0])) && turns < 2; ++turns) {
      std::rotate(face.begin(), face.begin() + 1, face.end());
    }
    const double height = thinness(result_.grid, result_.vertices, face) * length(face[0], face[1]);
    return height <= rounding() ? std::optional(face) : std::nullopt;
  }

  /// Two spacings of a float at the farthest coordinate [m].
  [[nodiscard]] double rounding() const { return std::ldexp(result_.grid.reach(), -23); }

  /// Takes out slivers that have no corner in common, and with them faces that this leaves without
  /// area. False if there are none that can be.
  bool take_out_slivers() {
    std::vector<Face>& faces = result_.faces;
    std::vector<EdgeSide> sides;
    const auto at_edge = [&](int one, int other) {
      if (sides.empty()) sides = sorted_sides(faces);
      const auto before = [](const EdgeSide& p, const EdgeSide& q) { return std::pair(p.low, p.high) < std::pair(q.low, q.high); };
      const auto [first, last] =
          std::equal_range(sides.begin(), sides.end(), EdgeSide{std::min(one, other), std::max(one, other), 0, 0}, before);
      return std::span(first, last);
    };
    std::vector<char> touched(result_.vertices.size(), 0);
    const auto touch = [&](std::initializer_list<int> corners) {
      if (std::any_of(corners.begin(), corners.end(), [&](int corner) { return touched[index(corner)] != 0; })) return false;
      for (const int corner : corners) touched[index(corner)] = 1;
      return true;
    };
    std::vector<int> into(result_.vertices.size());  // what each vertex is merged with
    std::iota(into.begin(), into.end(), 0);
    int taken = 0;
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
      const auto found = sliver(faces[index(i)]);
      if (!found) continue;
      const auto [a, b, c] = *found;
      const int near = length(a, c) < length(b, c) ? a : b;
      if (length(near, c) <= rounding()) {
        if (!touch({a, b, c})) continue;
        into[index(std::max(near, c))] = std::min(near, c);
      } else {
        // The face beyond the long edge gets the corner c there. If that is a sliver, too, only
        // towards shorter edges: or they might be flipped to and fro.
        const auto both = at_edge(a, b);
        if (both.size() != 2) continue;
        const EdgeSide& beyond = both[0].face == i ? both[1] : both[0];
        Face& other = faces[index(beyond.face)];
        const int d = other[index((beyond.side + 2) % 3)];
        if (!at_edge(c, d).empty() || (is_thin(other) && length(c, d) >= length(a, b)) || !touch({a, b, c, d})) continue;
        faces[index(i)] = {a, d, c};
        other = {d, b, c};
      }
      ++taken;
    }
    for (Face& face : faces) {
      for (int& corner : face) corner = into[index(corner)];
    }
    static_cast<void>(drop());
    result_.repairs.slivers += taken;
    return taken > 0;
  }

  /// Numbers the connected parts of the surface.
  void number_bodies() {
    // Of each face one of its part with a lower index; of the first itself.
    std::vector<int> earlier(result_.faces.size());
    std::iota(earlier.begin(), earlier.end(), 0);
    const auto first = [&](int face) {
      while (earlier[index(face)] != face) face = earlier[index(face)] = earlier[index(earlier[index(face)])];
      return face;
    };
    const std::vector<EdgeSide> sides = sorted_sides(result_.faces);
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i].low != sides[i - 1].low || sides[i].high != sides[i - 1].high) continue;
      const auto [low, high] = std::minmax({first(sides[i - 1].face), first(sides[i].face)});
      earlier[index(high)] = low;
    }
    for (int face = 0; face < static_cast<int>(earlier.size()); ++face) {
      result_.body.push_back(first(face) == face ? result_.bodies++ : result_.body[index(first(face))]);
    }
  }

  void keep(int body) {
    if (body < 1 || body > result_.bodies) {
      fail(joined({"body = ", std::to_string(body), " is out of range: expected 1 to ", std::to_string(result_.bodies),
                   ", the number of its bodies"}));
    }
    std::vector<char> dropped;
    for (const int of_face : result_.body) dropped.push_back(of_face != body - 1);
    leave_out(dropped);
    result_.body.assign(result_.faces.size(), 0);
    result_.bodies = 1;
  }

  const TriangleList& given_;
  MendedTriangles result_;
};

}  // namespace

MendedTriangles mend(const TriangleList& triangles, int body) {
  return Mending(triangles).run(body);
}

std::vector<EdgeSide> sorted_sides(std::span<const Face> faces) {
  std::vector<EdgeSide> sides;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (int side = 0; side < 3; ++side) {
      const int from = faces[i][index(side)];
      const int to = faces[i][index((side + 1) % 3)];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i), side});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::array{a.low, a.high, a.face} < std::array{b.low, b.high, b.face};
  });
  return sides;
}

double thinness(const Grid& grid, std::span<const Vector3d> vertices, const Face& face) {
  const Vector3d u = vertices[index(face[1])] - vertices[index(face[0])];
  const Vector3d v = vertices[index(face[2])] - vertices[index(face[0])];
  return grid.cross(u, v).norm() / std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
}

}  // namespace limitcurve::godobject
