// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/internal/least_squares.hpp"

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve::fit::internal {

/// A quantity to report, a function of the free parameters.
struct Quantity {
  std::string name;
  double value;
  std::string unit;
};

/// The exception for fewer samples than a fit of `free` parameters, `names`, needs: one more than parameters, unless the columns `sigmas`
/// tell the noise.
std::invalid_argument too_few_samples(std::size_t count, std::size_t free, const std::string& names, const std::string& sigmas);

double root_mean_square(std::span<const double> residuals) noexcept;

/// Median of the absolute values; values must not be empty.
double median_size(std::vector<double> values);

/// Variance of one residual from the scatter: Σr²/(N − p), 0 if N = p.
double residual_variance(const Solution& solution) noexcept;

/// Copies counts, convergence, message and rms of the solution into the report.
void describe(FitReport& report, const Solution& solution);

/// Estimates with standard errors and correlations by linear propagation: the quantities' derivatives with respect to the free
/// parameters are the rows of `jacobian`, `covariance` is that of the parameters.
void set_estimates(FitReport& report, std::span<const Quantity> quantities, std::span<const double> jacobian,
                   std::span<const double> covariance);

/// Residuals below this, in units of the limits or of standard deviations, are rounding: the curves are exact to 1e-11.
inline constexpr double perfect = 1e-10;

/// AICc of a fit whose residuals r have known unit variance (`known_variance`), χ² + 2p + …, or a common unknown one, N log(χ²/N) + 2(p+1) + ….
/// `cost` is ½ Σ loss(r²). Residuals below `perfect` count as `perfect`: perfect fits then differ only in their number of parameters.
double akaike(double cost, std::size_t residuals, std::size_t free_parameters, bool known_variance) noexcept;

}  // namespace limitcurve::fit::internal
