// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <cstdint>

namespace limitcurve::godobject {

/// The grid of a mesh's coordinates. The step is a power of two, and 2^38 steps reach from the origin at least to the farthest coordinate
/// (0.5 pm for a mesh of 10 cm). For points of the grid the signs of determinants are exact, so that no finger passes through the surface
/// by rounding at an edge or a vertex.
class Grid {
 public:
  /// Points up to this many times the mesh's reach are on the grid.
  static constexpr double room = 2.0;

  Grid() = default;
  /// For coordinates up to `largest` [m], finite and > 0.
  explicit Grid(double largest) noexcept;

  [[nodiscard]] double step() const noexcept { return step_; }    ///< [m]
  [[nodiscard]] double reach() const noexcept { return reach_; }  ///< [m] ≥ the largest coordinate, less than twice it
  /// The nearest point of the grid, for a point within `room`.
  [[nodiscard]] Eigen::Vector3d snap(const Eigen::Vector3d& place) const noexcept;

  /// The sign of u · (v × w): −1, 0 or 1. Exact for differences of grid points (each < 2^40 steps).
  [[nodiscard]] int sign(const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w) const noexcept;
  /// u × v, each component rounded once.
  [[nodiscard]] Eigen::Vector3d cross(const Eigen::Vector3d& u, const Eigen::Vector3d& v) const noexcept;

 private:
  double step_ = 1.0;
  double per_step_ = 1.0;
  double reach_ = 1.0;
};

/// The volume of a closed surface as an exact sum of its triangles' determinants, rounded once in `value`. A sum in double may have the
/// wrong sign if the solid is thinner than its rounding.
class Volume {
 public:
  /// Adds the tetrahedron with the edges u, v, w from a common point to the corners of a triangle; differences of grid points.
  void add(const Grid& grid, const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w) noexcept;
  /// The sum [m³].
  [[nodiscard]] double value(const Grid& grid) const noexcept;

 private:
  std::int64_t high_ = 0;  // in 2^64 steps³
  std::uint64_t low_ = 0;  // and the rest
};

/// The sign of the first component that is not 0. It breaks ties: a point on a plane, or a line through an edge, counts as moved by (ε, ε²,
/// ε³), ε → 0 ("simulation of simplicity", Edelsbrunner, Mücke 1990).
int first_sign(const Eigen::Vector3d& value) noexcept;

/// The crossing of a segment and the triangle a, b, c (counter-clockwise seen from outside): 1 inward, −1 outward, 0 none. All are grid
/// points; the segment's ends count as moved by (ε, ε², ε³). Exact, and so consistent: over a closed surface the sum along a path depends
/// on its ends only.
int crossing(const Grid& grid, const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
             const Eigen::Vector3d& c) noexcept;

}  // namespace limitcurve::godobject
