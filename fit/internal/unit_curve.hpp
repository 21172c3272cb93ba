// SPDX-License-Identifier: MIT
#pragma once

#include "fit/internal/chebyshev_curve.hpp"

#include <memory>
#include <string>

namespace limitcurve::fit::internal {

/// A family of convex curves from (1, 0) to (0, 1) in the normalised plane, parametrised by t ∈ [0, 1] from pure slide
/// to pure twist, with at most one shape parameter. The sample fits use a limit curve only through this interface.
class UnitCurve {
 public:
  struct Place {
    PlanePoint point;
    PlanePoint tangent;  ///< of any length, towards the twist: x ≤ 0 ≤ y, not both 0
  };

  virtual ~UnitCurve() = default;

  /// The shape parameter's name ("" if there is none), and, in a coordinate for the minimiser, its
  /// bounds, its start and the inverse. The coordinate of a law's family is a logarithm of the
  /// parameter, up to a shift.
  [[nodiscard]] virtual std::string shape_name() const { return {}; }
  [[nodiscard]] virtual double low() const noexcept { return 0.0; }
  [[nodiscard]] virtual double high() const noexcept { return 0.0; }
  [[nodiscard]] virtual double start() const noexcept { return 0.0; }
  [[nodiscard]] virtual double parameter(double coordinate) const noexcept { return coordinate; }
  [[nodiscard]] virtual double parameter_slope(double) const noexcept { return 1.0; }

  /// Sets the shape coordinate for the calls that follow.
  virtual void bend(double) noexcept {}
  [[nodiscard]] virtual Place at(double t) const noexcept = 0;
  /// d(point)/d(shape coordinate) at fixed t.
  [[nodiscard]] virtual PlanePoint shape_slope(double) const noexcept { return {0.0, 0.0}; }
  /// t of the curve's point near the ray through (x, y).
  [[nodiscard]] virtual double guess(PlanePoint ray) const noexcept = 0;

  /// m₀ and dm₀/d(shape coordinate) if the curve belongs to a law; otherwise 0, and no radius is known.
  [[nodiscard]] virtual double moment_ratio() const noexcept { return 0.0; }
  [[nodiscard]] virtual double moment_ratio_slope() const noexcept { return 0.0; }
};

std::unique_ptr<UnitCurve> make_ellipse();
/// One free shape that comes within 1 % of the curves of all common laws: where robust fits start.
std::unique_ptr<UnitCurve> make_flexible();
std::unique_ptr<UnitCurve> make_law(const PressureLaw& law);
std::unique_ptr<UnitCurve> make_family(const ShapeFamily& family, std::string shape_name, double start);

}  // namespace limitcurve::fit::internal
