// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/mesh_file.hpp"
#include "tests/godobject/scene.hpp"

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

/// Meshes made here, and what is true of a mesh found by looking at every face.
namespace limitcurve::godobject::test {

inline std::string data_mesh(const std::string& name) {
  return LIMITCURVE_MESHES "/" + name;
}

inline Eigen::Vector3d anywhere(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

inline TriangleList box_triangles(const Eigen::Vector3d& half) {
  TriangleList list;
  for (int i = 0; i < 8; ++i)
    list.vertices.push_back({half.x() * (i & 4 ? 1 : -1), half.y() * (i & 2 ? 1 : -1), half.z() * (i & 1 ? 1 : -1)});
  for (const std::array<int, 4>& face : {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    list.faces.push_back({face[0], face[1], face[2]});
    list.faces.push_back({face[0], face[2], face[3]});
  }
  return list;
}

/// Adds the triangles of another list, moved.
inline void add(TriangleList& list, const TriangleList& other, const Eigen::Vector3d& by = Eigen::Vector3d::Zero()) {
  const int first = static_cast<int>(list.vertices.size());
  for (const Eigen::Vector3d& vertex : other.vertices) list.vertices.push_back(vertex + by);
  for (const auto& [a, b, c] : other.faces) list.faces.push_back({first + a, first + b, first + c});
}

/// The same solid with each face divided into n² parts, of equal size for a power of 1, and
/// `change`d: turned, mirrored (a mirror turns the faces), rounded.
template <class Change>
TriangleList divided(const TriangleList& list, int n, double power, Change&& change, bool mirrors = false) {
  TriangleList result;
  for (const auto& face : list.faces) {
    const auto place = [&](int i, int j) {
      const Eigen::Vector3d share = Eigen::Array3d(n - i - j, i, j).pow(power);
      const auto at = [&](std::size_t corner) { return list.vertices[static_cast<std::size_t>(face.at(corner))]; };
      result.vertices.push_back(change((at(0) * share[0] + at(1) * share[1] + at(2) * share[2]) / share.sum()));
      return static_cast<int>(result.vertices.size()) - 1;
    };
    const auto add = [&](int one, int two, int three) {
      if (mirrors) std::swap(two, three);
      result.faces.push_back({one, two, three});
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        add(place(i, j), place(i + 1, j), place(i, j + 1));
        if (i + j + 1 < n) add(place(i + 1, j), place(i + 1, j + 1), place(i, j + 1));
      }
    }
  }
  return result;
}

/// A sphere of 8·4ⁿ faces: an octahedron whose faces are quartered, corners on the sphere.
inline TriangleList ball_triangles(double radius, int times) {
  TriangleList list;
  list.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  list.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (; times > 0; --times) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int i, int j) {
      const auto [found, is_new] = middles.try_emplace(std::minmax(i, j), static_cast<int>(list.vertices.size()));
      if (is_new) {
        list.vertices.push_back((list.vertices[static_cast<std::size_t>(i)] + list.vertices[static_cast<std::size_t>(j)]).normalized());
      }
      return found->second;
    };
    std::vector<Face> finer;
    for (const auto& [a, b, c] : list.faces) {
      const int d = middle(a, b), e = middle(b, c), f = middle(c, a);
      for (const Face& part : {Face{a, d, f}, Face{d, b, e}, Face{f, e, c}, Face{d, e, f}}) finer.push_back(part);
    }
    list.faces = std::move(finer);
  }
  for (Eigen::Vector3d& vertex : list.vertices) vertex *= radius;
  return list;
}

/// The distance of a point from a triangle by minimising over its inside and its edges, each with its own formula; shares no
/// code with the library.
inline double distance_to_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) {
    const Eigen::Vector3d way = to - from;
    const double share = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - from - share * way).norm());
  }
  const Eigen::Vector3d n = (b - a).cross(c - a).normalized();
  const bool over = n.dot((b - a).cross(p - a)) >= 0 && n.dot((c - b).cross(p - b)) >= 0 && n.dot((a - c).cross(p - c)) >= 0;
  return over ? std::min(least, std::fabs(n.dot(p - a))) : least;
}

inline double distance_by_search(const Mesh& mesh, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.faces()) {
    const auto v = [&](int i) { return mesh.vertices()[static_cast<std::size_t>(i)]; };
    least = std::min(least, distance_to_triangle(p, v(a), v(b), v(c)));
  }
  return least;
}

/// How often the surface goes round a point, from the solid angles of its faces: 1 inside, 0 outside.
/// Source: A. Van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30:125–126, 1983.
inline double winding_by_search(const Mesh& mesh, const Eigen::Vector3d& p) {
  double angle = 0.0;
  for (const auto& [i, j, k] : mesh.faces()) {
    const auto v = [&](int n) -> Eigen::Vector3d { return mesh.vertices()[static_cast<std::size_t>(n)] - p; };
    const Eigen::Vector3d a = v(i), b = v(j), c = v(k);
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

/// Whether a segment passes through a face, not within rounding of its edges or of the segment's ends.
inline bool clearly_crosses(const Mesh& mesh, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  for (const auto& [i, j, k] : mesh.faces()) {
    const auto v = [&](int n) { return mesh.vertices()[static_cast<std::size_t>(n)]; };
    Eigen::Matrix3d system;
    system << v(j) - v(i), v(k) - v(i), from - to;
    const Eigen::Vector3d solution = system.fullPivLu().solve(from - v(i));
    if ((system * solution - (from - v(i))).norm() > 1e-12) continue;
    const double first = 1.0 - solution[0] - solution[1];
    if (std::min({solution[0], solution[1], first, solution[2], 1.0 - solution[2]}) > 1e-6) return true;
  }
  return false;
}

}  // namespace limitcurve::godobject::test
