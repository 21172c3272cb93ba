// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace limitcurve::fit::internal {

/// A point of a curve in the normalised plane x = f, y = m/m₀.
struct PlanePoint {
  double x;
  double y;
  [[nodiscard]] PlanePoint operator-(PlanePoint other) const noexcept { return {x - other.x, y - other.y}; }
  /// Each component by its own factor, or both by one.
  [[nodiscard]] PlanePoint operator*(PlanePoint other) const noexcept { return {x * other.x, y * other.y}; }
  [[nodiscard]] PlanePoint operator*(double factor) const noexcept { return {x * factor, y * factor}; }
  void operator+=(PlanePoint other) noexcept { x += other.x, y += other.y; }
  [[nodiscard]] double length() const noexcept { return std::hypot(x, y); }
};

/// An exact unit limit curve as two Chebyshev series (COR inside the rim, outside the rim), 40 terms each, and their
/// derivative with respect to a shape parameter. No quadrature, about 50 ns an evaluation. Absolute error ≤ 1e-11 for
/// the closed-form laws (Gaussian 1e-9) and moderate shapes; about 1e-6 for laws with kinks between centre and rim.
class ChebyshevCurve {
 public:
  static constexpr std::size_t terms = 40;
  /// x and y, two coefficients an order.
  using Series = std::array<PlanePoint, terms>;

  ChebyshevCurve() = default;
  /// The curve of one law; its derivative with respect to the shape is 0. Cost: 80 evaluations of the law, 160 if its
  /// pressure vanishes before the rim.
  explicit ChebyshevCurve(const PressureLaw& law);

  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }
  /// d m₀/d(shape coordinate).
  [[nodiscard]] double moment_ratio_slope() const noexcept { return moment_ratio_slope_; }

  /// The point at spin fraction u ∈ [0, 1] (1 pure twist, ½ COR on the rim), and d(point)/d(shape coordinate) at the
  /// same u.
  [[nodiscard]] PlanePoint at(double u) const noexcept { return sum(value_, u); }
  [[nodiscard]] PlanePoint shape_slope(double u) const noexcept { return sum(slope_, u); }

 private:
  friend class ShapeFamily;
  [[nodiscard]] PlanePoint sum(const std::array<Series, 2>& sides, double u) const noexcept;

  /// Leaves out the last terms, which only add rounding.
  void trim() noexcept;

  std::array<Series, 2> value_{};
  std::array<Series, 2> slope_{};
  std::array<std::size_t, 2> used_{terms, terms};  // significant terms on each side
  double split_ = 1.0;                             // s where the series meet, usually the rim
  double moment_ratio_ = 0.0;
  double moment_ratio_slope_ = 0.0;
};

/// A family of pressure laws with one shape parameter, as a Chebyshev tensor in the shape's coordinate and the position
/// on the curve. Built at first use (20 to 70 ms, with the laws' own evaluators); then immutable and shared by all
/// threads.
class ShapeFamily {
 public:
  /// p ∝ (1−ρ²)ⁿ, n ∈ [−0.75, 6]; coordinate log(n + 3/2). Error of the curve ≤ 1e-11.
  static const ShapeFamily& power();
  /// p ∝ (1−ρᵏ)^{1/k}, k ∈ [0.8, 12]; coordinate log k. Error of the curve ≤ 1e-11.
  static const ShapeFamily& xydas_kao();

  [[nodiscard]] double low() const noexcept { return low_; }    ///< least coordinate
  [[nodiscard]] double high() const noexcept { return high_; }  ///< largest coordinate
  /// The law's own parameter at a coordinate, its derivative, and the inverse.
  [[nodiscard]] double parameter(double coordinate) const noexcept;
  [[nodiscard]] double parameter_slope(double coordinate) const noexcept;
  [[nodiscard]] double coordinate(double parameter) const noexcept;

  /// The curve of one member, with its derivative. Cost: about 10 µs.
  [[nodiscard]] ChebyshevCurve member(double coordinate) const noexcept;

 private:
  static constexpr std::size_t shape_terms = 24;
  ShapeFamily(const std::function<Law(double)>& make, double shift, double lowest, double highest);

  double shift_;
  double low_;
  double high_;
  std::array<std::array<ChebyshevCurve::Series, 2>, shape_terms> tensor_{};
  std::array<double, shape_terms> moment_ratio_{};
};

}  // namespace limitcurve::fit::internal
