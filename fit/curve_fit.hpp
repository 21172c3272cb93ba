// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/approximations.hpp"
#include "../limitcurve/pressure_law.hpp"
#include "../limitcurve/validate.hpp"
#include "estimate.hpp"

#include <cstddef>

namespace limitcurve::fit {

/// Criterion for an approximation of the exact unit limit curve. Errors are radial and relative: the approximation's radius divided by the
/// curve's along the same ray of the normalised plane (x = f, y = m/m₀), minus one.
enum class Criterion {
  intercepts,     ///< through (1, 0) and (0, m₀), as in the paper: too strong everywhere between
  least_squares,  ///< least rms error over the rays, `CurveError::rms_error`, by Ceres
  minimax,        ///< least largest error, of either sign
  inner,          ///< largest area inside the exact curve: never holds what slips
  outer,          ///< smallest area outside the exact curve: never slips what holds
};

/// The criterion's name: intercepts, least-squares, minimax, inner, outer.
const char* to_string(Criterion criterion) noexcept;

/// An approximation of the exact unit limit curve of a law, with its errors against that curve over all rays.
/// The report's rms is over the points of the least-squares fit. Its standard errors measure the misfit of the shape (the curve has no
/// noise) and are 0 for the other criteria.
template <class Curve>
struct CurveFit {
  Curve curve;  ///< in unit wrenches
  CurveError error;
  FitReport report;
};

/// Number of points of a least-squares fit, evenly spaced in the normalised slip angle atan(c/(m₀a)) from pure twist to pure slide; the
/// weight of a point is its share of rays.
inline constexpr std::size_t default_curve_points = 361;

/// Ellipse of two semi-axes; estimates force_max [1], moment_max [1] in unit wrenches.
/// These three throw std::invalid_argument if points < 3 or the shape does not support the criterion (superellipse and
/// quartic: least_squares and minimax only). Cost: 1 to 2 ms for a law in closed form, most of it to measure the error.
CurveFit<Ellipse> fit_ellipse(const Law& law, Criterion criterion = Criterion::least_squares, std::size_t points = default_curve_points);

/// Superellipse through the intercepts; estimates force_max, moment_max (both fixed), exponent [1].
CurveFit<Superellipse> fit_superellipse(const Law& law, Criterion criterion = Criterion::least_squares,
                                        std::size_t points = default_curve_points);

/// Quartic through the intercepts; estimates force_max, moment_max (both fixed), kappa [1].
CurveFit<Quartic> fit_quartic(const Law& law, Criterion criterion = Criterion::least_squares, std::size_t points = default_curve_points);

}  // namespace limitcurve::fit
