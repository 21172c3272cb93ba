// SPDX-License-Identifier: MIT
#pragma once

#include "fit/internal/least_squares.hpp"
#include "fit/measurements.hpp"

#include <span>
#include <vector>

namespace limitcurve::fit::internal {

/// How far, to second order in the noise, least squares lands from the truth on average because residuals r(θ) are curved
/// (Box 1971, "Bias in nonlinear estimation", J. R. Stat. Soc. B 33:171-201, eq. 2.6; Cook, Tsai & Wei 1986, Biometrika 73:615-623):
///   bias(θ) = −½ (Σ w g gᵀ)⁻¹ Σ w g tr(H V),
/// with g and H the gradient and Hessian of a residual, V the covariance of θ, w = 1. For a robust loss w = ψ(r)/r: where errors are
/// symmetric the same expansion holds of its estimating equation. H is the central difference of the analytic gradients, with
/// steps of a hundredth of a standard error. One entry a parameter; all 0 where V is 0, which is where there is no noise.
/// Cost: 2·parameters evaluations of each residual. Leaves the model at `solution.values`.
std::vector<double> second_order_bias(const ResidualModel& model, const Solution& solution, const Loss& loss,
                                      std::span<const double> covariance);

/// The solution as it would look at other values of the parameters: residuals and Jacobian are those there, the rest is kept.
Solution moved(const ResidualModel& model, const Solution& solution, std::vector<double> values);

}  // namespace limitcurve::fit::internal
