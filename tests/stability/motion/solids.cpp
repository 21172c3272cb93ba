// SPDX-License-Identifier: MIT
#include "solids.hpp"
#include "tests/touch.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace limitcurve::stability {

using namespace godobject;
using Eigen::Vector3d;

namespace {

/// The point of a triangle nearest to a point: inside it, or on one of its edges.
Vector3d nearest_on(const Triangle& triangle, const Vector3d& point) {
  const auto& [a, b, c] = triangle;
  const Vector3d normal = (b - a).cross(c - a);
  bool over = true;
  Vector3d best = a;
  for (const auto& [from, to] : {std::pair(a, b), {b, c}, {c, a}}) {
    over = over && normal.dot((to - from).cross(point - from)) >= 0.0;
    const double along = std::clamp((point - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    const Vector3d place = from + along * (to - from);
    if ((point - place).squaredNorm() < (point - best).squaredNorm()) best = place;
  }
  return over ? Vector3d(point - normal * (normal.dot(point - a) / normal.squaredNorm())) : best;
}

}  // namespace

TriangleList box_triangles(const Vector3d& half, const Vector3d& at) {
  TriangleList list;
  for (int i = 0; i < 8; ++i) {
    list.vertices.push_back(at + half.cwiseProduct(Vector3d((i & 4) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 1) != 0 ? 1 : -1)));
  }
  for (const std::array<int, 4>& face : {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    list.faces.push_back({face[0], face[1], face[2]});
    list.faces.push_back({face[0], face[2], face[3]});
  }
  return list;
}

std::vector<Triangle> triangles_of(const TriangleList& list) {
  std::vector<Triangle> result;
  const auto vertex = [&](int i) { return list.vertices[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : list.faces) result.push_back({vertex(a), vertex(b), vertex(c)});
  return result;
}

bool beneath_nearest_face(const std::vector<Triangle>& triangles, const Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  double height = 0.0;
  for (const Triangle& triangle : triangles) {
    const double distance = (point - nearest_on(triangle, point)).norm();
    if (distance < least) {
      least = distance;
      height = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).dot(point - triangle[0]);
    }
  }
  return height < 0.0;
}

double winding(const std::vector<Triangle>& triangles, const Vector3d& point) {
  double angle = 0.0;
  for (const Triangle& triangle : triangles) {
    const Vector3d a = triangle[0] - point;
    const Vector3d b = triangle[1] - point;
    const Vector3d c = triangle[2] - point;
    const double above = a.dot(b.cross(c));
    const double below = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
    angle += 2.0 * std::atan2(above, below);
  }
  return angle / (4.0 * std::numbers::pi);
}

bool is_inside(const MeshSurface& surface, const Vector3d& point) {
  ContactMemory memory;
  return touch(surface, point, memory).depth > 0.0;
}

}  // namespace limitcurve::stability
