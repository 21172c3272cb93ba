// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_curve.hpp"
#include "limitcurve/number.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

/// Limit curves of few parameters: ellipse, superellipse, quartic, box and diamond. `validate.hpp` says how wrong each is.
namespace limitcurve {

/// Refuses intercepts of a limit curve, in unit wrenches, that are not within 1e-100 … 1e100: throws std::invalid_argument
/// naming the one and its value.
void check_intercepts(double force_max, double moment_max);

/// The ellipse (f/A)² + (m/B)² = 1 (paper, eq. 19): the usual stand-in for the limit curve, and too strong by 4 to 8 %
/// in the middle when it runs through the intercepts (A = 1, B = m₀). A limit curve; no trigonometry.
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
    const double x = force_max_ * twist.slide;
    const double y = moment_max_ * twist.spin;
    const double length = std::sqrt(x * x + y * y);
    return {force_max_ * x / length, moment_max_ * y / length};
  }

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept;

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    const double x = wrench.force / force_max_;
    const double y = wrench.moment / moment_max_;
    return std::sqrt(x * x + y * y);
  }

 private:
  double force_max_;
  double moment_max_;
};

static_assert(LimitCurve<Ellipse>);

/// The superellipse (f/A)ⁿ + (m/B)ⁿ = 1, n > 1: 2 is the ellipse, n → 1 the diamond, n → ∞ the box. One exponent fitted
/// to a law (minimax_superellipse in validate.hpp) is off by some 0.9 %, where the ellipse is off by 4 to 8 %.
/// Its COR, though, is wrong without bound towards both ends unless n = 2: there the normal turns like xⁿ⁻¹, not like x.
///
/// A limit curve; no trigonometry, two powers a call. Relative error of both components ≤ 4 ε(1 + 1/(n−1)) for every
/// twist, the ends included: a flatter side turns a small change of the twist into a large step along it.
class Superellipse {
 public:
  /// Intercepts in unit wrenches, 1e-100 … 1e100, and the exponent, > 1 and finite; throws std::invalid_argument otherwise.
  Superellipse(double force_max, double moment_max, double exponent);

  /// Through (1, 0) and (0, m₀).
  static Superellipse through_intercepts(double moment_ratio, double exponent) { return {1.0, moment_ratio, exponent}; }

  [[nodiscard]] double force_max() const noexcept { return force_max_; }
  [[nodiscard]] double moment_max() const noexcept { return moment_max_; }
  [[nodiscard]] double exponent() const noexcept { return exponent_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max_ / force_max_; }

  /// Support point. In the normalised plane x = f/A, y = m/B the normal is (p, q) = (Av, Bw) ∝ (xⁿ⁻¹, yⁿ⁻¹); hence the
  /// smaller of x, y is (smaller of p, q / larger)^{1/(n−1)} times the larger, which is (1 + ratioⁿ)^{−1/n}.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept;

  /// For n > 2 the slope is infinite at the ends; it is given as that of u = 1e-80 (large, finite).
  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept;

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept;

 private:
  /// Keeps u⁻¹ finite at the ends.
  static constexpr double end_distance = 1e-80;

  /// (1 + ratioⁿ)^{1/n}: length of (1, ratio).
  [[nodiscard]] double unit_length(double ratio) const noexcept { return std::pow(1.0 + std::pow(ratio, exponent_), 1.0 / exponent_); }

  double force_max_;
  double moment_max_;
  double exponent_;
  double inverse_;  // 1/(n−1)
};

static_assert(LimitCurve<Superellipse>);

/// The quartic x⁴ + y⁴ + κx²y² = 1 with x = f/A, y = m/B and 0 ≤ κ ≤ 6, where it is convex: 2 is the ellipse, 6 is nearly
/// a diamond (flat on the diagonal), 0 nearly a box (flat at the ends). Fitted to a law (minimax_quartic in
/// validate.hpp) it is off by some 0.65 %, and unlike the superellipse it turns as it should at both ends.
///
/// A limit curve; no trigonometry, no iteration: two square roots and a cube root at most. Relative error of both
/// components ≤ 16 ε for κ away from 0 and 6; where a side is flat (κ = 6 at the diagonal) the place on it is as
/// uncertain as the twist makes it, the distance along the normal is not.
class Quartic {
 public:
  /// Intercepts in unit wrenches, 1e-100 … 1e100, and κ ∈ [0, 6]; throws std::invalid_argument otherwise.
  Quartic(double force_max, double moment_max, double kappa);

  /// Through (1, 0) and (0, m₀).
  static Quartic through_intercepts(double moment_ratio, double kappa) { return {1.0, moment_ratio, kappa}; }

  [[nodiscard]] double force_max() const noexcept { return force_max_; }
  [[nodiscard]] double moment_max() const noexcept { return moment_max_; }
  [[nodiscard]] double kappa() const noexcept { return kappa_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max_ / force_max_; }

  /// Support point: with t the smaller of (Av, Bw) over the larger, r = smaller of (x, y) over the larger solves
  /// t = r(2r² + κ)/(2 + κr²), and the larger is (1 + κr² + r⁴)^{−1/4}.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept;

  /// Where a side is flat (κ = 0 at the ends, κ = 6 at the diagonal) the slope is infinite; given large but finite.
  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept;

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept;

 private:
  /// Least dt/dr that is divided by: what remains of it one rounding away from a flat place.
  static constexpr double flattest = 1e-32;

  /// (1 + κr² + r⁴)^{1/4}: length of (1, r).
  [[nodiscard]] double unit_length(double ratio) const noexcept {
    const double square = ratio * ratio;
    return std::sqrt(std::sqrt(1.0 + square * (kappa_ + square)));
  }

  /// r ∈ [0, 1] with 2r³ − κt r² + κr − 2t = 0 for t ∈ [0, 1]. With r = κt/6 + z: z³ + Pz = Q, P ≥ 0, whose one real root
  /// is Cardano's U − V; as Q/(U² + UV + V²) it does not cancel. Relative error ≤ 12 ε.
  [[nodiscard]] double ratio_of(double t) const noexcept;

  double force_max_;
  double moment_max_;
  double kappa_;
};

static_assert(LimitCurve<Quartic>);

/// Refuses vertices of a `Polygon` that do not make one: throws std::invalid_argument.
void check_vertices(std::span<const UnitWrench> vertices);

/// A convex polygonal curve: vertices from (A, 0) to (0, B), joined by straight faces. `box` and `diamond` make the two
/// that engines use: uncoupled limits, and the friction pyramid.
///
/// A limit curve with corners, where one wrench has many normals, and faces, where one normal has many wrenches.
/// `wrench` gives the vertex that supports the twist (at a face's normal either of its vertices); at pure sliding
/// always (A, 0) and at pure spin (0, B). A projection that must be exact on faces takes `vertices`. No rounding but
/// that of `along` and `gauge` (≤ 4 ε).
template <std::size_t count>
class Polygon {
  static_assert(count >= 2);

 public:
  /// Throws std::invalid_argument unless the vertices are finite, begin on the force axis, end on the moment axis and
  /// turn left all the way, with force not rising and moment not falling.
  explicit Polygon(const std::array<UnitWrench, count>& vertices) : vertices_(vertices) { check_vertices(vertices_); }

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
  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept { return {wrench(twist), {0.0, 0.0}}; }

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

/// Uncoupled limits f ≤ A, m ≤ B: 1.4 to 1.5 times too strong in the corner. A, B within 1e-100 … 1e100, else
/// std::invalid_argument.
inline Box box(double force_max, double moment_max) {
  return Box({UnitWrench{force_max, 0.0}, UnitWrench{force_max, moment_max}, UnitWrench{0.0, moment_max}});
}

/// The friction pyramid f/A + m/B ≤ 1: too weak everywhere but at its ends. A, B within 1e-100 … 1e100, else std::invalid_argument.
inline Diamond diamond(double force_max, double moment_max) {
  return Diamond({UnitWrench{force_max, 0.0}, UnitWrench{0.0, moment_max}});
}

static_assert(LimitCurve<Box>);
static_assert(LimitCurve<Diamond>);

}  // namespace limitcurve
