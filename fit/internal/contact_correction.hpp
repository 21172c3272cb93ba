// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/internal/contact_residuals.hpp"
#include "fit/internal/report.hpp"

#include <span>
#include <vector>

/// Corrections for the curvature of a sample fit, to second order in the noise.
namespace limitcurve::fit::internal {

/// The reported quantities φ(θ), their derivatives row by row, and for the bias the scale S where φ = S exp(λ(θ)) + constant
/// (0: φ is linear in θ) and ½ d²λ/dβ², β being the shape.
struct Reported {
  std::vector<Quantity> quantities;
  std::vector<double> jacobian;
  std::vector<double> scales;
  std::vector<double> bends;
};

/// The bias of the parameters and their covariance at some values of the parameters.
struct Stray {
  std::vector<double> bias;
  std::vector<double> covariance;
};

/// A solution and its minimisation problem.
struct FittedContact {
  const ContactResiduals& residuals;
  const Solution& solution;
  std::span<const Parameter> parameters;
  const Loss& loss;
  double variance;  ///< of one residual
};

/// At the solution. Each parameter's bias is limited to half its standard error; beyond that a second-order correction is meaningless.
Stray stray_of(const FittedContact& fit);

/// The same at the expected truth, that is after subtracting the bias at the solution: the bias grows fast with the shape, and so
/// would its error. The reported shape is the exponential of its coordinate.
Stray expected_stray(const FittedContact& fit, const Stray& at_solution);

/// Subtracts from each estimate the bias due to curvature; b is the bias of the parameters θ:
///   bias(φ) = ∇φ·b + ½ tr(∇²φ V) = S (∇λ·b + ½ ∇λᵀV∇λ + ½ tr(∇²λ V)),
/// as a factor exp(−bias/S), so that positive values stay positive. V is the covariance of the first `bent` parameters: without gamma,
/// the last one, the correction is that at the reference load and does not depend on the unit of load.
void unbias(FitReport& report, const Reported& reported, const Stray& stray, std::size_t bent);

/// The standard error of the shape (an exponential of its coordinate), averaged over its own 95 % interval by Simpson's rule. If it
/// grows along the interval (for k like k^2.4), the value at the estimate is too small whenever the estimate is too small.
double mean_shape_error(const FittedContact& fit, std::span<const double> covariance, const UnitCurve& curve);

/// d² log m₀/dβ². Leaves the curve at `shape`.
double log_moment_ratio_curvature(UnitCurve& curve, double shape);

}  // namespace limitcurve::fit::internal
