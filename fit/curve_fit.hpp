// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/approximations.hpp"
#include "../limitcurve/pressure_law.hpp"
#include "../limitcurve/validate/validate.hpp"
#include "estimate.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace limitcurve::fit {

/// Criterion for an ellipse that approximates the exact unit limit curve. Errors are radial and
/// relative: on a ray of the normalised plane (x = f, y = m/m₀), the radius of the ellipse divided by the radius of the
/// curve, minus 1.
enum class Criterion {
  intercepts,     ///< through (1, 0) and (0, m₀), as in the paper; between them, too strong for common laws
  least_squares,  ///< least rms error over the rays, `CurveError::rms_error`, by Ceres
  minimax,        ///< smallest largest error, of either sign
  inner,          ///< minimax inside the exact curve, so that the ellipse never holds what slips
};

/// In the order of Criterion.
inline constexpr std::array<std::string_view, 4> criterion_names{"intercepts", "least-squares", "minimax", "inner"};

/// An ellipse that approximates the exact unit limit curve of a law, with its errors against that
/// curve over all rays. The report's rms is over the points of the least-squares fit. The
/// standard errors are NaN, because the curve has no noise.
struct CurveFit {
  Ellipse curve;  ///< in unit wrenches
  CurveError error;
  FitReport report;
};

/// Number of points of a least-squares fit, evenly spaced in the normalised slip angle atan(c/(m₀a)) from pure twist to
/// pure slide; the weight of a point is its share of rays.
inline constexpr std::size_t default_curve_points = 361;

/// Ellipse of two semi-axes; estimates force_max [1], moment_max [1] in unit wrenches. Throws
/// std::invalid_argument if points < 3. Cost: 1 to 2 ms for a law in closed form, most of it to
/// measure the error.
CurveFit fit_ellipse(const Law& law, Criterion criterion = Criterion::least_squares,
                     std::size_t points = default_curve_points);

}  // namespace limitcurve::fit
