// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace limitcurve::godobject {

/// The grid of places on which a mesh stands: 2^38 steps, a power of two each, from the origin to its farthest coordinate or
/// beyond (0.5 pm for a mesh of 10 cm). Between places of the grid the signs of determinants are exact, so a finger cannot slip
/// through the rounding at an edge or a vertex.
class Grid {
 public:
  /// Places up to this many times the mesh's reach are on the grid.
  static constexpr double room = 2.0;

  Grid() = default;
  /// For coordinates up to `largest` [m], finite and > 0.
  explicit Grid(double largest) noexcept;

  [[nodiscard]] double step() const noexcept { return step_; }    ///< [m]
  [[nodiscard]] double reach() const noexcept { return reach_; }  ///< [m] ≥ the largest coordinate, less than twice it
  /// The nearest place of the grid. Within `room`.
  [[nodiscard]] Eigen::Vector3d snap(const Eigen::Vector3d& place) const noexcept;

  /// The sign of u · (v × w), −1, 0 or 1, exact for differences of places of the grid (each < 2^40 steps).
  [[nodiscard]] int sign(const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w) const noexcept;
  /// u × v, exact but for one rounding of each component at the end.
  [[nodiscard]] Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) const noexcept;

 private:
  double step_ = 1.0;
  double per_step_ = 1.0;
  double reach_ = 1.0;
};

/// The volume of a closed surface as the sum of its triangles' determinants, exact but for one rounding when it is asked for: a sum in
/// doubles may have the wrong sign where a solid is thinner than their rounding.
class Volume {
 public:
  /// The tetrahedron of three edges from one place to the corners of a triangle, differences of places of the grid.
  void add(const Grid& grid, const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w) noexcept;
  /// [m³]
  [[nodiscard]] double value(const Grid& grid) const noexcept;

 private:
  std::int64_t high_ = 0;  // in 2^64 steps³
  std::uint64_t low_ = 0;  // and the rest
};

/// The sign of the first component that is not 0: on which side of a plane through a place, or of a line, a place on it falls when
/// it is moved by (ε, ε², ε³), ε → 0. So no place is ever on a plane, and no line meets an edge: what is counted has no ties.
int first_sign(const Eigen::Vector3d& value) noexcept;

/// How the segment passes the triangle a, b, c (anticlockwise seen from outside): 1 inward, −1 outward, 0 not at all. All are places
/// of the grid, the segment's ends moved by (ε, ε², ε³). Exact, and so consistent: over a closed surface the sum along a path depends
/// on its ends alone.
int crossing(const Grid& grid, const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
             const Eigen::Vector3d& c) noexcept;

}  // namespace limitcurve::godobject
