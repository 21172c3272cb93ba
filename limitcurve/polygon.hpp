// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/intercepts.hpp"
#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/number.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace limitcurve {

/// A convex polygonal boundary: vertices from (A, 0) to (0, B), joined by straight faces. `box` and `diamond` make the two
/// that engines use: uncoupled limits, and the friction pyramid.
///
/// A limit boundary with corners, where one wrench has many normals, and faces, where one normal has many wrenches.
/// `wrench` gives the vertex that supports the twist (at a face's normal either of its vertices); at pure sliding
/// always (A, 0) and at pure spin (0, B). A projection that must be exact on faces takes `vertices`. No rounding but
/// that of `along` and `gauge` (≤ 4 ε).
template <std::size_t count>
class Polygon {
  static_assert(count >= 2);

 public:
  /// Throws std::invalid_argument unless the vertices are finite, begin on the force axis, end on the moment axis and
  /// turn left all the way, with force not rising and moment not falling.
  explicit Polygon(const std::array<UnitWrench, count>& vertices) : vertices_(vertices) {
    const auto [force_max, no_moment] = vertices_.front();
    const auto [no_force, moment_max] = vertices_.back();
    check_intercepts(force_max, moment_max);
    if (no_moment != 0.0) throw out_of_range("moment of the first vertex", no_moment, "1", "0");
    if (no_force != 0.0) throw out_of_range("force of the last vertex", no_force, "1", "0");
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const SlipTwist here = face_normal(i);
      if (!(here.slide >= 0.0 && here.spin >= 0.0 && here.slide + here.spin > 0.0)) {
        throw std::invalid_argument("vertex " + std::to_string(i + 1) + ": expected force not above and moment not below those of vertex " +
                                    std::to_string(i));
      }
      if (i == 0) continue;
      const SlipTwist before = face_normal(i - 1);
      if (!(before.slide * here.spin > before.spin * here.slide)) {
        throw std::invalid_argument("vertex " + std::to_string(i) + " is not a convex corner");
      }
    }
  }

  /// From (A, 0) to (0, B), counter-clockwise.
  [[nodiscard]] const std::array<UnitWrench, count>& vertices() const noexcept { return vertices_; }

  [[nodiscard]] double force_max() const noexcept { return vertices_.front().force; }
  [[nodiscard]] double moment_max() const noexcept { return vertices_.back().moment; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max() / force_max(); }

  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    if (twist.slide == 0.0) return vertices_.back();
    std::size_t i = 0;
    if (twist.spin == 0.0) return vertices_[i];
    // Up the chain while the next vertex is further along the normal. By c = slide/spin, not by products, which
    // underflow: the box's corner supports every twist with a spin, however small.
    const double cor = twist.cor();
    while (i + 1 < count) {
      const auto [rise, retreat] = face_normal(i);
      if (retreat > 0.0 && !(rise > cor * retreat)) break;
      ++i;
    }
    return vertices_[i];
  }

  /// The slope is 0: between the jumps at face normals the wrench rests at a vertex.
  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept { return {wrench(twist), {0.0, 0.0}}; }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    const std::size_t face = face_along(direction);
    const double length = length_on(face, direction);
    return {{direction.force / length, direction.moment / length}, face_normal(face)};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept { return length_on(face_along(wrench), wrench); }

 private:
  /// Outward normal of the face from vertex i to i + 1.
  [[nodiscard]] SlipTwist face_normal(std::size_t i) const noexcept {
    return {vertices_[i + 1].moment - vertices_[i].moment, vertices_[i].force - vertices_[i + 1].force};
  }

  /// `wrench` in units of the point of face i (extended to a line) on the same ray.
  [[nodiscard]] double length_on(std::size_t i, UnitWrench wrench) const noexcept {
    const auto [slide, spin] = face_normal(i);
    return (slide * wrench.force + spin * wrench.moment) / (slide * vertices_[i].force + spin * vertices_[i].moment);
  }

  /// The face that the ray crosses: of all faces' lines the first it meets.
  [[nodiscard]] std::size_t face_along(UnitWrench direction) const noexcept {
    std::size_t best = 0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
      if (length_on(i, direction) > length_on(best, direction)) best = i;
    }
    return best;
  }

  std::array<UnitWrench, count> vertices_;
};

using Box = Polygon<3>;
using Diamond = Polygon<2>;

/// Uncoupled limits f ≤ A, m ≤ B: 1.4 to 1.5 times too strong in the corner. A, B > 0 and finite, else
/// std::invalid_argument.
inline Box box(double force_max, double moment_max) {
  return Box({UnitWrench{force_max, 0.0}, UnitWrench{force_max, moment_max}, UnitWrench{0.0, moment_max}});
}

/// The friction pyramid f/A + m/B ≤ 1: too weak everywhere but at its ends. A, B > 0 and finite, else std::invalid_argument.
inline Diamond diamond(double force_max, double moment_max) {
  return Diamond({UnitWrench{force_max, 0.0}, UnitWrench{0.0, moment_max}});
}

static_assert(LimitBoundary<Box>);
static_assert(LimitBoundary<Diamond>);

}  // namespace limitcurve
