// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/internal/contact_residuals.hpp"
#include "fit/internal/report.hpp"

#include <span>
#include <vector>

/// What curvature does to the estimates of a sample fit, to second order in the noise.
namespace limitcurve::fit::internal {

/// What is reported: the quantities φ(θ), their derivatives row by row, and for the bias the scale S where φ = S exp(λ(θ)) + constant
/// (0: φ is linear in θ) and ½ d²λ/dβ², β being the shape.
struct Reported {
  std::vector<Quantity> quantities;
  std::vector<double> jacobian;
  std::vector<double> scales;
  std::vector<double> bends;
};

/// How a fit strays at some place: the bias of the parameters, and their covariance.
struct Stray {
  std::vector<double> bias;
  std::vector<double> covariance;
};

/// A solution and what was minimised to get it.
struct FittedContact {
  const ContactResiduals& residuals;
  const Solution& solution;
  std::span<const Parameter> parameters;
  const Loss& loss;
  double variance;  ///< of one residual
};

/// At the solution; no parameter's bias is more than half its standard error: beyond, a second order is no longer a correction.
Stray stray_of(const FittedContact& fit);

/// The same where the truth is to be expected, once the bias at the solution is taken off: it grows fast with the shape, and so
/// would its own error. The shape's reported parameter is its exponential if `logarithmic`.
Stray expected_stray(const FittedContact& fit, const Stray& at_solution, bool logarithmic);

/// Takes off each estimate the bias that curvature causes, b being that of the parameters θ:
///   bias(φ) = ∇φ·b + ½ tr(∇²φ V) = S (∇λ·b + ½ ∇λᵀV∇λ + ½ tr(∇²λ V)),
/// as a factor exp(−bias/S), so that what is positive stays so. V is that of the first `bent` parameters: with all but gamma, which comes last,
/// the correction is the one at the reference load, and a newton of another size changes nothing.
void unbias(FitReport& report, const Reported& reported, const Stray& stray, std::size_t bent);

/// The standard error of the shape (an exponential of its coordinate), averaged over its own 95 % interval by Simpson's rule: where
/// it grows along the interval, as that of k does like k^2.4, the one at the estimate is too small whenever the estimate is.
double mean_shape_error(const FittedContact& fit, std::span<const double> covariance, const UnitCurve& curve);

/// d² log m₀/dβ². Leaves the curve bent to `shape`.
double log_moment_ratio_curvature(UnitCurve& curve, double shape);

}  // namespace limitcurve::fit::internal
