// SPDX-License-Identifier: MIT
#include "godobject/mesh/closed_triangles.hpp"

#include "godobject/mesh/self_intersection.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve::godobject {

namespace {

using Eigen::Vector3d;

/// One side of a face: its edge from corner `side` to the next.
struct Side {
  int low, high;  // the edge's vertices
  int face, side;
};

class Closing {
 public:
  explicit Closing(const TriangleList& triangles) : given_(triangles) {}

  ClosedTriangles run() {
    weld();
    drop_and_measure();
    join();
    orient();
    check_fans();
    check_folds();
    result_.tree = Tree(result_.vertices, result_.faces);
    if (const auto pair = find_self_intersection(result_)) {
      fail(pair->first, {"meets face ", std::to_string(origin_[index(pair->second)]),
                         " where they share neither edge nor vertex, expected a surface that does not cross or touch itself"});
    }
    turn_outward();
    return std::move(result_);
  }

 private:
  static std::size_t index(int value) { return static_cast<std::size_t>(value); }

  using Parts = std::initializer_list<std::string_view>;

  [[noreturn]] void fail(int face, Parts what) const {
    throw std::invalid_argument(joined({given_.place(origin_[index(face)]), " ", joined(what)}));
  }
  [[noreturn]] void fail(Parts what) const { throw std::invalid_argument(joined({given_.name, ": ", joined(what)})); }

  [[nodiscard]] std::string at(int vertex) const {
    const Vector3d& v = given_.vertices[given_vertex_[index(vertex)]];
    return joined({"(", format_number(v.x()), ", ", format_number(v.y()), ", ", format_number(v.z()), ")"});
  }

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
    if (given_.faces.size() < 4) fail({std::to_string(given_.faces.size()), " faces, expected at least 4 (a tetrahedron)"});
    if (given_.faces.size() > index(std::numeric_limits<int>::max() / 4)) fail({"too many faces, expected up to 5e8"});
    if (!(largest >= 1e-6)) fail({"its farthest coordinate is ", format_number(largest), " m, expected at least 1e-6 m"});
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
        given_vertex_.push_back(i);
      } else {
        ++result_.repairs.welded;
      }
      number[i] = found->second;
    }
    for (const Face& face : given_.faces) result_.faces.push_back({number[index(face[0])], number[index(face[1])], number[index(face[2])]});
  }

  void drop_and_measure() {
    std::vector<Face> kept;
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      const Face& face = result_.faces[i];
      if (face[0] == face[1] || face[1] == face[2] || face[2] == face[0]) {
        ++result_.repairs.dropped;
        continue;
      }
      kept.push_back(face);
      origin_.push_back(i);
    }
    result_.faces = std::move(kept);
    if (result_.faces.size() < 4) fail({std::to_string(result_.faces.size()), " faces with an area, expected at least 4 (a tetrahedron)"});
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      const auto& [a, b, c] = result_.faces[i];
      const Vector3d u = result_.vertices[index(b)] - result_.vertices[index(a)];
      const Vector3d v = result_.vertices[index(c)] - result_.vertices[index(a)];
      const double area = result_.grid.cross(u, v).norm();
      const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
      if (area == 0.0) fail(static_cast<int>(i), {"has no area: its corners ", at(a), ", ", at(b), ", ", at(c), " are on one line"});
      if (!(area >= thinnest_face * longest)) {
        fail(static_cast<int>(i), {"is a sliver: its height is ", format_number(area / longest), " of its longest edge, expected >= 1e-6"});
      }
    }
  }

  /// Finds the face across every edge.
  void join() {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      for (int side = 0; side < 3; ++side) {
        const int from = result_.faces[i][index(side)];
        const int to = result_.faces[i][index((side + 1) % 3)];
        sides.push_back({std::min(from, to), std::max(from, to), static_cast<int>(i), side});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::array{a.low, a.high, a.face} < std::array{b.low, b.high, b.face};
    });
    result_.neighbours.resize(result_.faces.size());
    std::vector<Side> open;
    for (std::size_t first = 0; first < sides.size();) {
      std::size_t end = first;
      while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) ++end;
      const Side& side = sides[first];
      if (end - first > 2) fail(side.face, {"is one of ", std::to_string(end - first), " faces at the ", edge(side), ", expected two"});
      if (end - first == 1) open.push_back(side);
      const Side& other = sides[end - 1];
      result_.neighbours[index(side.face)][index(side.side)] = other.face;
      result_.neighbours[index(other.face)][index(other.side)] = side.face;
      first = end;
    }
    if (!open.empty()) refuse_open(open);
  }

  [[nodiscard]] std::string edge(const Side& side) const { return joined({"edge from ", at(side.low), " to ", at(side.high)}); }

  /// Names some of the open edges, and what closes them.
  [[noreturn]] void refuse_open(const std::vector<Side>& open) const {
    std::string others;
    for (std::size_t i = 1; i < open.size() && i < 4; ++i) {
      others +=
          joined({i == 1 ? "; open are also the " : ", the ", edge(open[i]), " of face ", std::to_string(origin_[index(open[i].face)])});
    }
    if (open.size() > 4) others += joined({" and ", std::to_string(open.size() - 4), " more"});
    fail(open[0].face, {"has nothing beyond its ", edge(open[0]), ", expected a closed surface", others,
                        ". MeshLab (Filters, Close Holes) or Blender (Mesh, Clean Up, Fill Holes) closes them"});
  }

  /// Whether two faces run along their shared edge (`side` of `one`) in the same sense, which is a fault.
  [[nodiscard]] bool same_sense(int one, int side, int other) const {
    const int from = result_.faces[index(one)][index(side)];
    const int to = result_.faces[index(one)][index((side + 1) % 3)];
    const Face& face = result_.faces[index(other)];
    for (std::size_t i = 0; i < 3; ++i) {
      if (face[i] == from && face[(i + 1) % 3] == to) return true;
    }
    return false;
  }

  void turn(int face) {
    Face& corners = result_.faces[index(face)];
    Face& beyond = result_.neighbours[index(face)];
    std::swap(corners[1], corners[2]);
    std::swap(beyond[0], beyond[2]);
    turned_[index(face)] ^= 1;
  }

  /// Gives all faces of a shell the same orientation as its first face.
  void orient() {
    const std::size_t count = result_.faces.size();
    shell_.assign(count, -1);
    turned_.assign(count, 0);
    for (std::size_t start = 0; start < count; ++start) {
      if (shell_[start] >= 0) continue;
      std::vector<int> reached{static_cast<int>(start)};
      shell_[start] = shells_;
      for (std::size_t next = 0; next < reached.size(); ++next) {
        const int face = reached[next];
        for (int side = 0; side < 3; ++side) {
          const int other = result_.neighbours[index(face)][index(side)];
          if (shell_[index(other)] < 0) {
            shell_[index(other)] = shells_;
            if (same_sense(face, side, other)) turn(other);
            reached.push_back(other);
          } else if (same_sense(face, side, other)) {
            fail(face,
                 {"and face ", std::to_string(origin_[index(other)]), " cannot both look outward: expected a surface with two sides"});
          }
        }
      }
      ++shells_;
    }
  }

  /// Checks that the faces at a vertex are one fan: a walk around the vertex by neighbours must meet them all.
  void check_fans() {
    std::vector<int> faces_at(result_.vertices.size(), 0);
    std::vector<std::pair<int, int>> first(result_.vertices.size(), {-1, 0});
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const int vertex = result_.faces[i][index(corner)];
        ++faces_at[index(vertex)];
        first[index(vertex)] = {static_cast<int>(i), corner};
      }
    }
    for (std::size_t vertex = 0; vertex < first.size(); ++vertex) {
      auto [face, corner] = first[vertex];
      if (face < 0) continue;
      int met = 0;
      do {
        // Cross the edge that ends at the vertex. In the face beyond, this edge starts at the vertex.
        face = result_.neighbours[index(face)][index((corner + 2) % 3)];
        const Face& corners = result_.faces[index(face)];
        corner = static_cast<int>(std::find(corners.begin(), corners.end(), static_cast<int>(vertex)) - corners.begin());
        ++met;
      } while (face != first[vertex].first && met <= faces_at[vertex]);
      if (met != faces_at[vertex]) {
        fail(first[vertex].first,
             {"has a corner ", at(static_cast<int>(vertex)), " where parts of the surface touch in a point, expected one fan of faces"});
      }
    }
  }

  /// Refuses two faces that lie back to back or face to face: the surface has no outward direction at their edge.
  void check_folds() const {
    const auto normal = [&](int face) -> Vector3d {
      const auto& [a, b, c] = result_.faces[index(face)];
      const Vector3d& origin = result_.vertices[index(a)];
      return result_.grid.cross(result_.vertices[index(b)] - origin, result_.vertices[index(c)] - origin).normalized();
    };
    for (int face = 0; face < static_cast<int>(result_.faces.size()); ++face) {
      for (const int other : result_.neighbours[index(face)]) {
        const double angle = other > face ? (normal(face) + normal(other)).norm() : 1.0;
        if (angle >= sharpest_edge) continue;
        fail(face, {"folds back on to face ", std::to_string(origin_[index(other)]), ": the angle between them is ", format_number(angle),
                    " rad, expected >= 1e-13"});
      }
    }
  }

  /// Turns shells outward. A shell inside an even number of other shells is the outside of a solid, one inside an odd number is a hollow.
  void turn_outward() {
    std::vector<Volume> volume(index(shells_));
    std::vector<int> member(index(shells_), -1);
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      const auto& [a, b, c] = result_.faces[i];
      // The volume is computed about a vertex of the shell.
      int& known = member[index(shell_[i])];
      if (known < 0) known = a;
      const Vector3d& origin = result_.vertices[index(known)];
      volume[index(shell_[i])].add(result_.grid, result_.vertices[index(a)] - origin, result_.vertices[index(b)] - origin,
                                   result_.vertices[index(c)] - origin);
    }
    std::vector<char> inward(index(shells_), 0);
    for (std::size_t shell = 0; shell < volume.size(); ++shell) {
      inward[shell] =
          (volume[shell].value(result_.grid) > 0.0) == (shells_ > 1 && surrounding(static_cast<int>(shell), member[shell]) % 2 != 0);
    }
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      if (inward[index(shell_[i])] != 0) turn(static_cast<int>(i));
    }
    result_.repairs.turned = std::accumulate(turned_.begin(), turned_.end(), 0);
  }

  /// The number of faces of other shells that a ray from a vertex of this shell passes. Its parity is that of the number of shells around.
  [[nodiscard]] int surrounding(int shell, int vertex) const {
    const Vector3d& from = result_.vertices[index(vertex)];
    Vector3d to = from;
    to.x() = Grid::room * result_.grid.reach();
    int count = 0;
    result_.tree.along(from, to, result_.grid.step(), [&](int face) {
      const auto& [a, b, c] = result_.faces[index(face)];
      if (shell_[index(face)] != shell &&
          crossing(result_.grid, from, to, result_.vertices[index(a)], result_.vertices[index(b)], result_.vertices[index(c)]) != 0) {
        ++count;
      }
      return 1.0;
    });
    return count;
  }

  const TriangleList& given_;
  ClosedTriangles result_;
  std::vector<std::size_t> origin_;        // index of each face in the input
  std::vector<std::size_t> given_vertex_;  // index of each vertex in the input; of merged ones the first
  std::vector<int> shell_;                 // index of the connected part of each face
  std::vector<char> turned_;
  int shells_ = 0;
};

}  // namespace

ClosedTriangles close(const TriangleList& triangles) {
  return Closing(triangles).run();
}

}  // namespace limitcurve::godobject
