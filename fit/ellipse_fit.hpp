// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/pressure_law.hpp"

#include <cstddef>

namespace limitcurve::fit {

/// An ellipse laid over the exact unit limit curve. Errors are radial and relative in the normalised plane of the
/// paper, x = f, y = m/m₀: ellipse radius over curve radius along the same ray, minus one. Positive is too strong.
struct EllipseFit {
  Ellipse ellipse;                  ///< in unit wrenches: semi-axes force_max, moment_max
  double max_over_estimate = 0.0;   ///< ≥ 0
  double max_under_estimate = 0.0;  ///< ≥ 0
  FitReport report{};               ///< estimates force_max [1], moment_max [1]; rms of the radial error
};

/// Points of the exact curve that a fit looks at, unless told otherwise: enough for 6 digits of the semi-axes.
inline constexpr std::size_t default_curve_points = 361;

/// The ellipse through the intercepts (paper, eq. 19), measured as the fitted ones are.
/// Throws std::invalid_argument if points < 3.
EllipseFit ellipse_through_intercepts(const Law& law, std::size_t points = default_curve_points);

/// The ellipse with the least sum of squared radial errors over `points` points of the exact curve, spread evenly in slip
/// angle atan(c/a) ∈ [0, π/2], by Ceres. No sample carries noise, so that the standard errors measure how badly
/// an ellipse fits, and shrink as points are added. Throws std::invalid_argument if points < 3.
/// Cost: below 1 ms for a law in closed form.
EllipseFit fit_ellipse(const Law& law, std::size_t points = default_curve_points);

}  // namespace limitcurve::fit
