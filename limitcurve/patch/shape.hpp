// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/patch.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limitcurve::patch {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// The range of lengths of a patch [m].
inline constexpr double least_length = 1e-100;
inline constexpr double most_length = 1e100;

/// Throws if places differ, but by less than `least_length` along both axes: the squares of their distances would
/// vanish.
template <class Place>
void require_size(std::span<const Place> places) {
  double size = 0.0;
  for (const Place& place : places)
    size = std::max({size, std::fabs(place.x - places.front().x), std::fabs(place.y - places.front().y)});
  if (size > 0.0 && size < least_length) throw out_of_range("size", size, "m", "0, or from 1e-100 to 1e100");
}

/// A kind of patch, under isotropic friction of coefficient 1 and load 1. The caller passes finite twists, not zero,
/// scaled so that no square overflows.
struct Shape {
  virtual ~Shape() = default;

  /// H and its gradient; twist and moment refer to the centre of pressure. Does not set `error`.
  [[nodiscard]] virtual PatchFriction evaluate(const PatchTwist& twist) const noexcept = 0;
  /// Bound on the error of `evaluate`.
  [[nodiscard]] virtual double error(const PatchTwist& twist) const noexcept = 0;
  /// Under orthotropic friction `factors` = (mx, my): H, its gradient and the error at the user's twist, where this
  /// shape is the patch with x times my and y times mx, and `middle` the patch's centre. Twist and moment refer to the
  /// origin. The caller scales as for `evaluate`.
  [[nodiscard]] virtual PatchFriction about_origin(const PatchTwist& twist, PatchPoint factors,
                                                   PatchPoint middle) const noexcept;

  /// The shape with coordinates times (sx, sy) and the same loads.
  [[nodiscard]] virtual std::shared_ptr<Shape> stretched(double sx, double sy) const = 0;
  /// See Patch::smoothed; null if the shape is smooth already.
  [[nodiscard]] virtual std::shared_ptr<Shape> smoothed(double) const { return nullptr; }

  /// Cost of `evaluate` [ns], the mean over CORs within a tenth and ten times the moment arm; measured where a table's
  /// wrench costs 9 ns.
  [[nodiscard]] virtual double nanoseconds() const noexcept = 0;
  [[nodiscard]] virtual double area() const { return 0.0; }
  /// Where much load is on little area: H may have a sharp minimum with the COR there. `load`: of a point, which bears
  /// any force up to it; 0 of the middle of a pixel or of a disc.
  [[nodiscard]] virtual std::vector<PatchLoad> concentrations() const { return {}; }
  /// The law of an ellipse; null for other shapes.
  [[nodiscard]] virtual Law law() const { return nullptr; }
  [[nodiscard]] virtual std::vector<std::string> remarks() const { return {}; }

  PatchPoint centre;          ///< of pressure
  double radius = 0.0;        ///< largest distance from there
  double moment_ratio = 0.0;  ///< H(0, 0, 1)

 protected:
  /// Constructors call this last, after setting `centre` and `radius`.
  void measure_moment_ratio() { moment_ratio = evaluate({0.0, 0.0, 1.0}).power; }
};

/// The velocity of the point at (x, y) from the reference point of the twist; each component is rounded once.
[[nodiscard]] inline PatchPoint velocity_at(const PatchTwist& twist, double x, double y) noexcept {
#ifdef _WIN32
  using Fused = long double;  // that of double rounds the product in mingw-w64's library
#else
  using Fused = double;
#endif
  return {static_cast<double>(std::fma(Fused{-twist.omega}, Fused{y}, Fused{twist.vx})),
          static_cast<double>(std::fma(Fused{twist.omega}, Fused{x}, Fused{twist.vy}))};
}

/// Whether the COR is so far away that the patch only slides, to rounding.
[[nodiscard]] inline bool only_slides(const PatchTwist& twist, double radius) noexcept {
  return std::hypot(twist.vx, twist.vy) > 1e17 * radius * std::fabs(twist.omega);
}
[[nodiscard]] inline PatchFriction sliding(const PatchTwist& twist) noexcept {
  const double speed = std::hypot(twist.vx, twist.vy);
  return {speed, {twist.vx / speed, twist.vy / speed, 0.0}, 0.0};
}

/// Friction of a patch with its COR at c, from the mean distance D = ⟨|x − c|⟩, the mean direction g = ⟨(x − c)/|x −
/// c|⟩ = −∇D and the moment M = ⟨x·(x − c)/|x − c|⟩ = D + c·g. For ω > 0 the velocity of x is ω ẑ × (x − c).
[[nodiscard]] inline PatchFriction from_distance(double omega, double mean_distance, PatchPoint direction,
                                                 double moment) noexcept {
  const double sense = std::copysign(1.0, omega);
  return {std::fabs(omega) * mean_distance, {-sense * direction.y, sense * direction.x, sense * moment}, 0.0};
}

std::shared_ptr<Shape> make_points(std::span<const PatchLoad> loads);
std::shared_ptr<Shape> make_polygon(std::span<const PatchPoint> vertices);
std::shared_ptr<Shape> make_ellipse(const Law& law, double a, double b);
std::shared_ptr<Shape> make_image(std::vector<double> pressures, std::size_t columns, double width, double height,
                                  std::optional<double> floor);

/// Points with a radius: |u| becomes √(|u|² + ε²ω²).
std::shared_ptr<Shape> make_soft_points(std::vector<PatchLoad> loads, double radius);

/// Throws std::invalid_argument unless the vertices bound a simple polygon; names two edges that meet, or the vertex
/// where an edge turns back.
void check_simple(std::span<const PatchPoint> vertices);

}  // namespace limitcurve::patch
