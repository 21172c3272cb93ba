// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch.hpp"
#include "limitcurve/pressure_law.hpp"

#include <cmath>
#include <limits>
#include <memory>

namespace limitcurve::patch {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// The lengths that a patch may have [m].
inline constexpr double least_length = 1e-100;
inline constexpr double most_length = 1e100;

/// Central second moments of the pressure [m²].
struct SecondMoments {
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
};

/// One kind of patch, under isotropic friction of coefficient 1 and load 1. Twists are scaled by the caller, so that no square overflows; they
/// are finite and not zero.
struct Shape {
  virtual ~Shape() = default;

  /// H and its gradient at a twist of the centre of pressure, and moments about it; `error` is left alone.
  [[nodiscard]] virtual PatchFriction evaluate(const PatchTwist& twist) const noexcept = 0;
  /// Bound of the error of `evaluate`.
  [[nodiscard]] virtual double error(const PatchTwist& twist) const noexcept = 0;
  /// Both at a twist of the origin.
  [[nodiscard]] virtual PatchFriction about_origin(const PatchTwist& twist) const noexcept;

  [[nodiscard]] virtual std::shared_ptr<Shape> moved(double x, double y) const = 0;
  /// All coordinates times (sx, sy), the loads kept.
  [[nodiscard]] virtual std::shared_ptr<Shape> stretched(double sx, double sy) const = 0;
  /// See Patch::smoothed; nothing where the shape is smooth as it is.
  [[nodiscard]] virtual std::shared_ptr<Shape> smoothed(double) const { return nullptr; }

  /// Of `evaluate`, as measured on one machine.
  [[nodiscard]] virtual double nanoseconds() const noexcept = 0;
  [[nodiscard]] virtual double area() const { return 0.0; }
  [[nodiscard]] virtual SecondMoments second_moments() const = 0;
  /// The law of an ellipse; none for others.
  [[nodiscard]] virtual Law law() const { return nullptr; }

  PatchPoint centre;          ///< of pressure
  double radius = 0.0;        ///< largest distance from there
  double moment_ratio = 0.0;  ///< H(0, 0, 1)

 protected:
  /// At the end of construction, with `centre` and `radius` known.
  void measure_moment_ratio() { moment_ratio = evaluate({0.0, 0.0, 1.0}).power; }
};

/// The velocity of the point (x, y), seen from where the twist is told; each component is rounded once.
[[nodiscard]] inline PatchPoint velocity_at(const PatchTwist& twist, double x, double y) noexcept {
  return {std::fma(-twist.omega, y, twist.vx), std::fma(twist.omega, x, twist.vy)};
}

/// Whether the COR is so far away that the patch only slides, to rounding.
[[nodiscard]] inline bool only_slides(const PatchTwist& twist, double radius) noexcept {
  return std::hypot(twist.vx, twist.vy) > 1e17 * radius * std::fabs(twist.omega);
}
[[nodiscard]] inline PatchFriction sliding(const PatchTwist& twist) noexcept {
  const double speed = std::hypot(twist.vx, twist.vy);
  return {speed, {twist.vx / speed, twist.vy / speed, 0.0}, 0.0};
}

/// From what a patch whose COR is at c has in D = ⟨|x − c|⟩, the mean direction g = ⟨(x − c)/|x − c|⟩ = −∇D and M = ⟨x·(x − c)/|x − c|⟩ = D + c·g:
/// for ω > 0 the velocity of x is ω ẑ × (x − c).
[[nodiscard]] inline PatchFriction from_distance(double omega, double mean_distance, PatchPoint direction, double moment) noexcept {
  const double sense = std::copysign(1.0, omega);
  return {std::fabs(omega) * mean_distance, {-sense * direction.y, sense * direction.x, sense * moment}, 0.0};
}

std::shared_ptr<Shape> make_points(std::span<const PatchLoad> loads);
std::shared_ptr<Shape> make_polygon(std::span<const PatchPoint> vertices);
std::shared_ptr<Shape> make_ellipse(const Law& law, double a, double b);
std::shared_ptr<Shape> make_image(std::span<const double> pressures, std::size_t columns, double pixel);
std::shared_ptr<Shape> make_sum(std::vector<std::pair<double, std::shared_ptr<const Shape>>> parts);

/// Points with a radius: |u| becomes √(|u|² + ε²ω²).
std::shared_ptr<Shape> make_soft_points(std::vector<PatchLoad> loads, double radius);

/// Throws unless the vertices bound a simple polygon: names two edges that meet, or the vertex of an edge that turns back on itself.
void check_simple(std::span<const PatchPoint> vertices);

}  // namespace limitcurve::patch
