// SPDX-License-Identifier: MIT
#pragma once

#include "limit_curve.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

/// Limit curves with few parameters: ellipse, superellipse, quartic, box and diamond. `validate.hpp` computes their errors.
namespace limitcurve {

/// Throws std::invalid_argument, with the name and value, unless both intercepts of a limit curve [unit wrenches] are within 1e-100 …
/// 1e100.
void check_intercepts(double force_max, double moment_max);

/// The ellipse (f/A)² + (m/B)² = 1 (paper, eq. 19): the usual approximation of the limit curve. Through the intercepts (A = 1, B = m₀) it
/// is too strong by 4 to 8 % for the laws of law_examples(). Models LimitCurve; one square root a call, no trigonometry.
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
    twist = twist.magnitudes();
    double x = force_max_ * twist.slide;
    double y = moment_max_ * twist.spin;
    double square = x * x + y * y;
    if (!(square > 1e-250 && square < 1e250)) [[unlikely]] {  // a twist whose square underflows has a direction, too
      const double larger = (std::max)(x, y);
      if (larger == 0.0) return {};
      x /= larger;
      y /= larger;
      square = x * x + y * y;
    }
    const double scale = 1.0 / std::sqrt(square);
    return {force_max_ * x * scale, moment_max_ * y * scale};
  }

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept;

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return std::hypot(wrench.force / force_max_, wrench.moment / moment_max_);
  }

 private:
  double force_max_;
  double moment_max_;
};

static_assert(LimitCurve<Ellipse>);

/// The superellipse (f/A)ⁿ + (m/B)ⁿ = 1, n > 1: n = 2 is the ellipse, n → 1 the diamond, n → ∞ the box. With an exponent fitted to a law
/// (minimax_superellipse in validate.hpp) its error is about 0.9 %.
/// The error of its COR has no bound towards both ends, unless n = 2: there the normal turns like xⁿ⁻¹, not like x.
///
/// Models LimitCurve; two powers a call, no trigonometry. Relative rounding error of both components ≤ 4 ε(1 + 1/(n−1)) for every twist,
/// the ends included. It grows as n → 1, because on a flat side a small change of the twist moves the point far.
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

  /// For n > 2 the slope is infinite at the ends; the result there is the slope at u = 1e-80, large but finite.
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

/// The quartic x⁴ + y⁴ + κx²y² = 1 with x = f/A, y = m/B. It is convex for 0 ≤ κ ≤ 6: κ = 2 is the ellipse, κ = 6 is nearly a diamond (flat
/// on the diagonal), κ = 0 nearly a box (flat at the ends). Fitted to a law (minimax_quartic in validate.hpp) its error is about 0.65 %,
/// and its COR has a bounded error at both ends, unlike the superellipse's.
///
/// Models LimitCurve; at most three square roots and a cube root a call, no trigonometry, no iteration. Relative rounding error of both
/// components ≤ 16 ε for κ away from 0 and 6. On a flat side (κ = 6 at the diagonal) the position along the side is sensitive to the twist;
/// the distance along the normal is not.
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

  /// On a flat side (κ = 0 at the ends, κ = 6 at the diagonal) the slope is infinite; the result there is large but finite.
  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept;

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept;

 private:
  /// Lower bound of dt/dr, a divisor: its size one rounding away from a flat point.
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

/// Throws std::invalid_argument, with the vertex, unless the vertices make a `Polygon`.
void check_vertices(std::span<const UnitWrench> vertices);

/// A convex polygon as limit curve: vertices from (A, 0) to (0, B), joined by straight faces. `box` and `diamond` make the two that physics
/// engines use: uncoupled limits, and the friction pyramid.
///
/// Models LimitCurve. At a corner one wrench has many normals, on a face one normal has many wrenches. `wrench` returns the vertex that
/// supports the twist (for the normal of a face either of its vertices); for pure sliding (A, 0), for pure spin (0, B). `vertices` gives
/// the exact faces. Rounding: `along` and `gauge` ≤ 4 ε, `wrench` none. Cost: nanoseconds, linear in the number of vertices.
template <std::size_t count>
class Polygon {
  static_assert(count >= 2);

 public:
  /// Throws std::invalid_argument unless the vertices are finite, begin on the force axis, end on the moment axis, turn left at every
  /// corner, and force never rises and moment never falls from one to the next.
  explicit Polygon(const std::array<UnitWrench, count>& vertices) : vertices_(vertices) { check_vertices(vertices_); }

  /// From (A, 0) to (0, B), counter-clockwise.
  [[nodiscard]] const std::array<UnitWrench, count>& vertices() const noexcept { return vertices_; }

  [[nodiscard]] double force_max() const noexcept { return vertices_.front().force; }
  [[nodiscard]] double moment_max() const noexcept { return vertices_.back().moment; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max() / force_max(); }

  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    if (twist.is_zero()) return {};
    twist = twist.magnitudes();
    if (twist.slide == 0.0) return vertices_.back();
    std::size_t i = 0;
    if (twist.spin == 0.0) return vertices_[i];
    // Go on while the next vertex is farther along the normal. Compare by c = slide/spin, because products underflow: the box's corner
    // supports every twist with a spin, however small.
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

/// Uncoupled limits f ≤ A, m ≤ B. In the corner they are 1.4 to 1.5 times too strong. A, B within 1e-100 … 1e100, else
/// std::invalid_argument.
inline Box box(double force_max, double moment_max) {
  return Box({UnitWrench{force_max, 0.0}, UnitWrench{force_max, moment_max}, UnitWrench{0.0, moment_max}});
}

/// The friction pyramid f/A + m/B ≤ 1. It is too weak everywhere except at its ends. A, B within 1e-100 … 1e100, else
/// std::invalid_argument.
inline Diamond diamond(double force_max, double moment_max) {
  return Diamond({UnitWrench{force_max, 0.0}, UnitWrench{0.0, moment_max}});
}

static_assert(LimitCurve<Box>);
static_assert(LimitCurve<Diamond>);

}  // namespace limitcurve
