// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/internal/least_squares.hpp"

#include <cmath>
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

/// The exception for fewer samples than a fit of `free` parameters, `names`, needs: one more than parameters, unless
/// the columns `sigmas` tell the noise.
std::invalid_argument too_few_samples(std::size_t count, std::size_t free, const std::string& names,
                                      const std::string& sigmas);

double root_mean_square(std::span<const double> residuals) noexcept;

/// Median of the absolute values; values must not be empty.
double median_size(std::vector<double> values);

/// Variance of one residual from the scatter: Σr²/(N − p), 0 if N = p.
double residual_variance(const Solution& solution) noexcept;

/// Copies counts, convergence, message and rms of the solution into the report.
void describe(FitReport& report, const Solution& solution);

/// Estimates with standard errors and correlations by linear propagation: the quantities' derivatives with respect to
/// the free parameters are the rows of `jacobian`, `covariance` is that of the parameters.
void set_estimates(FitReport& report, std::span<const Quantity> quantities, std::span<const double> jacobian,
                   std::span<const double> covariance);

/// Residuals below this, in units of the limits or of standard deviations, are rounding: the curves are exact to 1e-11.
inline constexpr double perfect = 1e-10;

/// AICc of a fit whose residuals r have known unit variance (`known_variance`), χ² + 2p + …, or a common unknown one, N
/// log(χ²/N) + 2(p+1) + …. `cost` is ½ Σ loss(r²). Residuals below `perfect` count as `perfect`: perfect fits then
/// differ only in their number of parameters.
double akaike(double cost, std::size_t residuals, std::size_t free_parameters, bool known_variance) noexcept;

/// What a note says of few rows whose scatter is the only measure of noise: "" from 30 rows more than parameters on.
std::string note_of_few_rows(std::size_t spare);

/// The standard errors of a chosen model include the choice: with Akaike's weights w ∝ exp(−AICc/2) (Buckland, Burnham
/// & Augustin 1997, Biometrics 53:603–618), for each quantity of all candidates, se² = Σ w (se_i² + (value_i − value)²)
/// about the value of the best. A candidate without a value for a quantity is left out; the shapes n and k are.
template <class Fit>
void include_choice(FitReport& report, const std::vector<Fit>& candidates) {
  const std::size_t count = report.estimates.size();
  for (std::size_t i = 0; i < count; ++i) {
    Estimate& estimate = report.estimates[i];
    double sum = 0.0;
    double variance = 0.0;
    for (const Fit& candidate : candidates) {
      for (const Estimate& other : candidate.report.estimates) {
        if (other.name != estimate.name || !std::isfinite(other.value) || !std::isfinite(other.std_error)) continue;
        const double weight = std::exp(0.5 * (report.aic - candidate.report.aic));
        sum += weight;
        variance += weight * (other.std_error * other.std_error +
                              (other.value - estimate.value) * (other.value - estimate.value));
      }
    }
    const bool is_shape = estimate.name == "n" || estimate.name == "k";
    if (!is_shape && std::isfinite(estimate.value) && sum > 0.0) estimate.std_error = std::sqrt(variance / sum);
    if (estimate.std_error > 0.0) report.correlation[i * count + i] = 1.0;
  }
}

}  // namespace limitcurve::fit::internal
