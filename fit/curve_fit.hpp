// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/validate.hpp"

#include <cstddef>

namespace limitcurve::fit {

/// What is asked of an approximation of the exact unit limit curve. Errors are radial and relative: approximation's
/// radius over the curve's along the same ray of the normalised plane (x = f, y = m/m₀), minus one.
enum class Criterion {
  intercepts,     ///< through (1, 0) and (0, m₀), as the paper draws it: too strong everywhere between
  least_squares,  ///< least rms error over the rays, `CurveError::rms_error`, by Ceres
  minimax,        ///< least largest error, of either sign
  inner,          ///< largest area that never promises a hold that slips
  outer,          ///< smallest area that never calls slipping what holds
};

/// The criterion as a word: intercepts, least-squares, minimax, inner, outer.
const char* to_string(Criterion criterion) noexcept;

/// An approximation of the exact unit limit curve of a law, with its errors against that curve over all rays.
/// The report's rms is over the points that a least-squares fit looks at; its standard errors measure how badly the shape
/// fits (the curve carries no noise) and are 0 for the other criteria.
template <class Curve>
struct CurveFit {
  Curve curve;  ///< in unit wrenches
  CurveError error;
  FitReport report;
};

/// Points of the exact curve, spread evenly in the normalised slip angle atan(c/(m₀a)) from pure twist to pure slide, that a least-squares fit
/// looks at; each counts by the rays that it stands for.
inline constexpr std::size_t default_curve_points = 361;

/// Ellipse of two semi-axes; estimates force_max [1], moment_max [1] in unit wrenches.
/// These three throw std::invalid_argument if points < 3 or the criterion is not one the shape has (superellipse and
/// quartic: least_squares and minimax). Cost: 1 to 2 ms for a law in closed form, most of it to measure the error.
CurveFit<Ellipse> fit_ellipse(const Law& law, Criterion criterion = Criterion::least_squares, std::size_t points = default_curve_points);

/// Superellipse through the intercepts; estimates force_max, moment_max (both fixed), exponent [1].
CurveFit<Superellipse> fit_superellipse(const Law& law, Criterion criterion = Criterion::least_squares,
                                        std::size_t points = default_curve_points);

/// Quartic through the intercepts; estimates force_max, moment_max (both fixed), kappa [1].
CurveFit<Quartic> fit_quartic(const Law& law, Criterion criterion = Criterion::least_squares, std::size_t points = default_curve_points);

}  // namespace limitcurve::fit
