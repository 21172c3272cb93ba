// SPDX-License-Identifier: MIT
#pragma once

#include "limit_curve.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

/// What others use instead of the limit curve: ellipse, box, diamond and a Padé model. `curve_error` (validate.hpp)
/// measures their errors.
namespace limitcurve {

/// Throws std::invalid_argument, with the name and value, unless both intercepts of a limit curve [unit wrenches] are
/// within 1e-100 … 1e100.
void check_intercepts(double force_max, double moment_max);

/// The usual approximation of the limit curve (paper, eq. 19): the ellipse (f/A)² + (m/B)² = 1. Models LimitCurve.
/// Through the intercepts (A = 1, B = m₀) it is 3 to 8 % too strong for the laws of law_examples(). A call costs one
/// square root, no trigonometry.
class Ellipse {
 public:
  /// Semi-axes in unit wrenches, 1e-100 … 1e100; throws std::invalid_argument otherwise.
  Ellipse(double force_max, double moment_max);

  /// The paper's ellipse: through (1, 0) and (0, m₀).
  static Ellipse through_intercepts(double moment_ratio) { return {1.0, moment_ratio}; }

  [[nodiscard]] double force_max() const noexcept { return force_max_; }
  [[nodiscard]] double moment_max() const noexcept { return moment_max_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max_ / force_max_; }

  /// Support point: (A²v, B²w)/√(A²v² + B²w²).
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    if (twist.is_zero()) return {};
    twist = twist.direction();
    const double x = force_max_ * twist.slide;
    const double y = moment_max_ * twist.spin;
    const double scale = 1.0 / std::sqrt(x * x + y * y);
    return {force_max_ * x * scale, moment_max_ * y * scale};
  }

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept;

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    const double sum = std::fabs(wrench.force) + std::fabs(wrench.moment);
    return sum <= (std::numeric_limits<double>::max)()
               ? std::hypot(wrench.force / force_max_, wrench.moment / moment_max_)
               : sum;
  }

 private:
  double force_max_;
  double moment_max_;
};

static_assert(LimitCurve<Ellipse>);

/// Throws std::invalid_argument, with the vertex, unless the vertices make a `Polygon`.
void check_vertices(std::span<const UnitWrench> vertices);

/// A convex polygon as limit curve: vertices from (A, 0) to (0, B), joined by straight faces. `box` and `diamond` make
/// the two that physics engines use: uncoupled limits, and the friction pyramid.
///
/// Models LimitCurve. At a corner a wrench has many normals, and on a face a normal has many wrenches. `wrench`
/// therefore returns the vertex that supports the twist, which for the normal of a face may be either end of the face;
/// for pure sliding (A, 0), for pure spin (0, B). `vertices` gives the exact faces. Rounding: `along` and `gauge` ≤ 4
/// ε, `wrench` none. Cost: nanoseconds, linear in the number of vertices.
template <std::size_t count>
class Polygon {
  static_assert(count >= 2);

 public:
  /// Throws std::invalid_argument unless the vertices are finite, begin on the force axis, end on the moment axis, turn
  /// left at every corner, and force never rises and moment never falls from one to the next.
  explicit Polygon(const std::array<UnitWrench, count>& vertices) : vertices_(vertices) { check_vertices(vertices_); }

  /// From (A, 0) to (0, B), counter-clockwise.
  [[nodiscard]] const std::array<UnitWrench, count>& vertices() const noexcept { return vertices_; }

  [[nodiscard]] double force_max() const noexcept { return vertices_.front().force; }
  [[nodiscard]] double moment_max() const noexcept { return vertices_.back().moment; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max() / force_max(); }

  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    if (twist.is_zero()) return {};
    twist = twist.direction();
    if (std::isnan(twist.slide)) return {twist.slide, twist.slide};
    if (twist.slide == 0.0) return vertices_.back();
    std::size_t i = 0;
    if (twist.spin == 0.0) return vertices_[i];
    // Go on while the next vertex is farther along the normal. Compare by c = slide/spin, because products underflow:
    // the box's corner supports every twist with a spin, however small.
    const double cor = twist.cor();
    while (i + 1 < count) {
      const auto [rise, retreat] = face_normal(i);
      if (retreat > 0.0 && !(rise > cor * retreat)) break;
      ++i;
    }
    return vertices_[i];
  }

  /// The slope is 0: the wrench stays at a vertex, and jumps at the normal of a face.
  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept { return {wrench(twist), {0.0, 0.0}}; }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    direction = direction.magnitudes();
    const std::size_t face = face_along(direction);
    const double length = length_on(face, direction);
    return {{direction.force / length, direction.moment / length}, face_normal(face)};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    wrench = wrench.magnitudes();
    const double sum = wrench.force + wrench.moment;
    return sum <= (std::numeric_limits<double>::max)() ? length_on(face_along(wrench), wrench) : sum;
  }

 private:
  /// Outward normal of the face from vertex i to i + 1.
  [[nodiscard]] SlipTwist face_normal(std::size_t i) const noexcept {
    return {vertices_[i + 1].moment - vertices_[i].moment, vertices_[i].force - vertices_[i + 1].force};
  }

  /// Length of `wrench` divided by that of the point on the same ray and on the line of face i.
  [[nodiscard]] double length_on(std::size_t i, UnitWrench wrench) const noexcept {
    const auto [slide, spin] = face_normal(i);
    return (slide * wrench.force + spin * wrench.moment) / (slide * vertices_[i].force + spin * vertices_[i].moment);
  }

  /// The face that the ray crosses: the ray meets its line before the lines of all other faces.
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

/// Uncoupled limits f ≤ A, m ≤ B: about 50 % too strong in the corner. Throws std::invalid_argument unless A, B are in
/// 1e-100 … 1e100.
inline Box box(double force_max, double moment_max) {
  return Box({UnitWrench{force_max, 0.0}, UnitWrench{force_max, moment_max}, UnitWrench{0.0, moment_max}});
}

/// The friction pyramid f/A + m/B ≤ 1: too weak everywhere except at its ends. Throws like `box`.
inline Diamond diamond(double force_max, double moment_max) {
  return Diamond({UnitWrench{force_max, 0.0}, UnitWrench{0.0, moment_max}});
}

static_assert(LimitCurve<Box>);
static_assert(LimitCurve<Diamond>);

}  // namespace limitcurve
