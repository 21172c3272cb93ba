// SPDX-License-Identifier: MIT
#pragma once

#include "fit/internal/least_squares.hpp"
#include "fit/measurements.hpp"

#include <span>
#include <vector>

namespace limitcurve::fit::internal {

/// The bias of least squares due to the curvature of residuals r(θ), to second order in the noise (Box 1971, "Bias in nonlinear
/// estimation", J. R. Stat. Soc. B 33:171-201, eq. 2.6; Cook, Tsai & Wei 1986, Biometrika 73:615-623):
///   bias(θ) = −½ (Σ w g gᵀ)⁻¹ Σ w g tr(H V),
/// with g and H the gradient and Hessian of a residual, V the covariance of θ, w = 1. For a robust loss w = ψ(r)/r: if errors are
/// symmetric, the same expansion holds for its estimating equation. H is the central difference of the analytic gradients, with
/// steps of a hundredth of a standard error. One entry a parameter; all 0 if V is 0, that is without noise.
/// Cost: 2·parameters evaluations of each residual. Leaves the model at `solution.values`.
std::vector<double> second_order_bias(const ResidualModel& model, const Solution& solution, const Loss& loss,
                                      std::span<const double> covariance);

/// The solution at other values of the parameters: residuals and Jacobian are evaluated there, the rest is copied.
Solution moved(const ResidualModel& model, const Solution& solution, std::vector<double> values);

}  // namespace limitcurve::fit::internal
