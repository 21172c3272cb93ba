// SPDX-License-Identifier: MIT
#include "godobject/mesh/closed_triangles.hpp"

#include "godobject/mesh/self_intersection.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve::godobject {

namespace {

using Eigen::Vector3d;

class Closing {
 public:
  Closing(const TriangleList& triangles, int body) : given_(triangles), mended_(mend(triangles, body)), body_(mended_.body) {
    result_.grid = mended_.grid;
    result_.vertices = std::move(mended_.vertices);
    result_.faces = std::move(mended_.faces);
    result_.repairs = mended_.repairs;
  }

  ClosedTriangles run() {
    check_thinness();
    join();
    orient();
    check_fans();
    check_folds();
    result_.tree = Tree(result_.vertices, result_.faces);
    if (const auto pair = find_self_intersection(result_)) refuse_meeting(pair->first, pair->second);
    turn_outward();
    return std::move(result_);
  }

 private:
  using Parts = std::initializer_list<std::string_view>;

  /// Throws; of several bodies it names one that may load alone: another than the face's.
  [[noreturn]] void fail(int face, Parts what) const { fail(face, body_[index(face)] == 0 ? 1 : 0, what); }
  [[noreturn]] void fail(int face, int body, Parts what) const {
    const int bodies = mended_.bodies;
    const std::string way = joined({", or load one alone, as body=", std::to_string(body + 1), " of ", std::to_string(bodies)});
    throw std::invalid_argument(
        joined({given_.place(mended_.given_face[index(face)]), " ", joined(what), body < bodies ? way : std::string()}));
  }

  [[nodiscard]] std::string at(int vertex) const {
    const Vector3d& v = given_.vertices[mended_.given_vertex[index(vertex)]];
    return joined({"(", format_number(v.x()), ", ", format_number(v.y()), ", ", format_number(v.z()), ")"});
  }

  void check_thinness() const {
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      const double thin = thinness(result_.grid, result_.vertices, result_.faces[i]);
      if (thin >= thinnest_face) continue;
      const auto& [a, b, c] = result_.faces[i];
      fail(static_cast<int>(i),
           {thin == 0.0 ? "has no area"
                        : joined({"is a sliver: its height is ", format_number(thin, 3), " of its longest edge, expected >= 1e-6"}),
            "; its corners are ", at(a), ", ", at(b), ", ", at(c),
            ". MeshLab (Filters, Remove T-Vertices) or Blender (Mesh, Clean Up, Degenerate Dissolve) takes it out"});
    }
  }

  /// Finds the face across every edge.
  void join() {
    const std::vector<EdgeSide> sides = sorted_sides(result_.faces);
    result_.neighbours.resize(result_.faces.size());
    std::vector<EdgeSide> open;
    for (std::size_t first = 0; first < sides.size();) {
      std::size_t end = first;
      while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) ++end;
      const EdgeSide& side = sides[first];
      if (end - first > 2) {
        fail(side.face, {"is one of ", std::to_string(end - first), " faces at the ", edge(side),
                         ", expected two. Parts that touch there are to be united (Blender: Modifiers, Boolean, Union) or moved apart"});
      }
      if (end - first == 1) open.push_back(side);
      const EdgeSide& other = sides[end - 1];
      result_.neighbours[index(side.face)][index(side.side)] = other.face;
      result_.neighbours[index(other.face)][index(other.side)] = side.face;
      first = end;
    }
    if (!open.empty()) refuse_open(open);
  }

  [[nodiscard]] std::string edge(const EdgeSide& side) const { return joined({"edge from ", at(side.low), " to ", at(side.high)}); }

  /// Names some of the open edges, and what closes them.
  [[noreturn]] void refuse_open(const std::vector<EdgeSide>& open) const {
    std::string others;
    for (std::size_t i = 1; i < open.size() && i < 4; ++i) {
      others += joined({i == 1 ? "; open are also the " : ", the ", edge(open[i]), " of face ",
                        std::to_string(mended_.given_face[index(open[i].face)])});
    }
    if (open.size() > 4) others += joined({" and ", std::to_string(open.size() - 4), " more"});
    std::vector<char> is_open(index(mended_.bodies), 0);
    for (const EdgeSide& side : open) is_open[index(body_[index(side.face)])] = 1;
    const auto closed = static_cast<int>(std::find(is_open.begin(), is_open.end(), 0) - is_open.begin());
    fail(open[0].face, closed,
         {"has nothing beyond its ", edge(open[0]), ", expected a closed surface", others,
          ". MeshLab (Filters, Close Holes) or Blender (Mesh, Clean Up, Fill Holes) closes them"});
  }

  [[noreturn]] void refuse_meeting(int one, int other) const {
    fail(one, {"meets face ", std::to_string(mended_.given_face[index(other)]),
               " where they share neither edge nor vertex, expected a surface that does not cross or touch itself. ",
               body_[index(one)] == body_[index(other)] ? "Blender (Modifiers, Remesh) makes one"
                                                        : "Its closed bodies overlap: unite them (Blender: Modifiers, Boolean, Union)"});
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

  /// Gives all faces of a body the same orientation as its first face.
  void orient() {
    const std::size_t count = result_.faces.size();
    std::vector<char> reached(count, 0);
    turned_.assign(count, 0);
    for (std::size_t start = 0; start < count; ++start) {
      if (reached[start] != 0) continue;
      std::vector<int> faces{static_cast<int>(start)};
      reached[start] = 1;
      for (std::size_t next = 0; next < faces.size(); ++next) {
        const int face = faces[next];
        for (int side = 0; side < 3; ++side) {
          const int other = result_.neighbours[index(face)][index(side)];
          const bool is_new = reached[index(other)] == 0;
          if (is_new) {
            reached[index(other)] = 1;
            faces.push_back(other);
          }
          if (!same_sense(face, side, other)) continue;
          if (!is_new) {
            fail(face, {"and face ", std::to_string(mended_.given_face[index(other)]),
                        " cannot both look outward: expected a surface with two sides"});
          }
          turn(other);
        }
      }
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
             {"has a corner ", at(static_cast<int>(vertex)),
              " where parts of the surface touch in a point, expected one fan of faces: unite them or move them apart"});
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
        fail(face,
             {"folds back on to face ", std::to_string(mended_.given_face[index(other)]), ": the angle between them is ",
              format_number(angle), " rad, expected >= 1e-13. A sheet is to be deleted, or made thick (Blender: Modifiers, Solidify)"});
      }
    }
  }

  /// Turns bodies outward. One inside an even number of others is the outside of a solid, one
  /// inside an odd number is a hollow.
  void turn_outward() {
    std::vector<Volume> volume(index(mended_.bodies));
    std::vector<int> member(index(mended_.bodies), -1);
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      const auto& [a, b, c] = result_.faces[i];
      // The volume is computed about a vertex of the body.
      int& known = member[index(body_[i])];
      if (known < 0) known = a;
      const Vector3d& origin = result_.vertices[index(known)];
      volume[index(body_[i])].add(result_.grid, result_.vertices[index(a)] - origin, result_.vertices[index(b)] - origin,
                                  result_.vertices[index(c)] - origin);
    }
    std::vector<char> inward(index(mended_.bodies), 0);
    for (std::size_t body = 0; body < volume.size(); ++body) {
      inward[body] =
          (volume[body].value(result_.grid) > 0.0) == (mended_.bodies > 1 && surrounding(static_cast<int>(body), member[body]) % 2 != 0);
    }
    for (std::size_t i = 0; i < result_.faces.size(); ++i) {
      if (inward[index(body_[i])] != 0) turn(static_cast<int>(i));
    }
    result_.repairs.turned = std::accumulate(turned_.begin(), turned_.end(), 0);
  }

  /// The number of faces of other bodies that a ray from a vertex of this body passes. Its parity
  /// is that of the number of bodies around.
  [[nodiscard]] int surrounding(int body, int vertex) const {
    const Vector3d& from = result_.vertices[index(vertex)];
    Vector3d to = from;
    to.x() = Grid::room * result_.grid.reach();
    int count = 0;
    result_.tree.along(from, to, result_.grid.step(), [&](int face) {
      const auto& [a, b, c] = result_.faces[index(face)];
      if (body_[index(face)] != body &&
          crossing(result_.grid, from, to, result_.vertices[index(a)], result_.vertices[index(b)], result_.vertices[index(c)]) != 0) {
        ++count;
      }
      return 1.0;
    });
    return count;
  }

  const TriangleList& given_;
  MendedTriangles mended_;  // what `result_` has not taken
  ClosedTriangles result_;
  const std::vector<int>& body_;  // of each face
  std::vector<char> turned_;
};

}  // namespace

ClosedTriangles close(const TriangleList& triangles, int body) {
  return Closing(triangles, body).run();
}

}  // namespace limitcurve::godobject
