// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/internal/least_squares.hpp"

#include <algorithm>
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
  Estimate::Role role;
};

/// The exception for fewer samples than a fit of `free` parameters, `names`, needs: one more than parameters, unless
/// the columns `sigmas` tell the noise.
std::invalid_argument too_few_samples(std::size_t count, std::size_t free, const std::string& names,
                                      const std::string& sigmas);

double root_mean_square(std::span<const double> residuals) noexcept;

/// Median of the values, and of their sizes; values must not be empty.
double median_of(std::vector<double> values);
double median_size(std::vector<double> values);

/// The exception for a number of the sample at `index`, of which the first is 0.
std::invalid_argument bad_sample(std::size_t index, const char* name, double value, const std::string& expected);

/// Variance of one residual from the scatter: Σr²/(N − p), 0 if N = p.
double residual_variance(const Solution& solution) noexcept;

/// Copies counts, convergence, message and rms of the solution into the report.
void describe(FitReport& report, const Solution& solution);

/// Estimates with standard errors and correlations by linear propagation: the quantities' derivatives with respect to
/// the free parameters are the rows of `jacobian`, `covariance` is that of the parameters.
void set_estimates(FitReport& report, std::span<const Quantity> quantities, std::span<const double> jacobian,
                   std::span<const double> covariance);

/// Of the estimates, in rows; and back, to standard errors and correlations (0 with an estimate of unknown error).
std::vector<double> covariances_of(const FitReport& report);
void set_covariances(FitReport& report, std::span<const double> covariances);

/// Adds an error that all estimates share: by `offs` they may be off together.
void add_error(FitReport& report, std::span<const double> offs);

/// Residuals below this, in units of the limits or of standard deviations, are rounding: the curves are exact to 1e-11.
inline constexpr double perfect = 1e-10;

/// Akaike's criterion of a fit whose residuals r have known unit variance (`known_variance`), χ² + 2p, or a common
/// unknown one, N log(χ²/N) + 2(p+1) with the correction for few samples (AICc), ∞ where that is undefined. `cost` is
/// ½ Σ loss(r²). Residuals below `perfect` count as `perfect`: perfect fits then differ only in their number of
/// parameters.
double akaike(double cost, std::size_t residuals, std::size_t free_parameters, bool known_variance) noexcept;

/// What a note says of few rows whose scatter is the only measure of noise: "" from 30 rows more than parameters on.
std::string note_of_few_rows(std::size_t spare);

/// So few rows a choice between models of up to `free` parameters takes: AICc is defined from there on.
constexpr std::size_t least_rows_of_choice(std::size_t free) noexcept {
  return free + 3;
}

/// The covariances of a chosen model include the choice: with Akaike's weights w ∝ exp(−AIC/2) (Buckland, Burnham &
/// Augustin 1997, Biometrics 53:603–618), for each pair of quantities of all candidates, Σ w (cov_i + δ_i δ_iᵀ), δ_i
/// the difference from the value of the best. A candidate without a value for a quantity is left out; the shapes n and
/// k are.
template <class Fit>
void include_choice(FitReport& report, const std::vector<Fit>& candidates) {
  const std::vector<Estimate> best = report.estimates;
  const std::size_t count = best.size();
  const auto is_shared = [](const Estimate& one) {
    return one.role != Estimate::Role::shape && std::isfinite(one.value) && std::isfinite(one.std_error);
  };
  std::vector<double> covariances = covariances_of(report);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      if (!is_shared(best[i]) || !is_shared(best[j])) continue;
      double sum = 0.0;
      double covariance = 0.0;
      for (const Fit& candidate : candidates) {
        const std::vector<Estimate>& others = candidate.report.estimates;
        for (std::size_t a = 0; a < others.size(); ++a) {
          for (std::size_t b = 0; b < others.size(); ++b) {
            if (others[a].role != best[i].role || others[b].role != best[j].role) continue;
            if (!is_shared(others[a]) || !is_shared(others[b])) continue;
            const double weight = std::exp(0.5 * (report.aic - candidate.report.aic));
            const double correlation = a == b ? 1.0 : candidate.report.correlation[a * others.size() + b];
            sum += weight;
            covariance += weight * (correlation * others[a].std_error * others[b].std_error +
                                    (others[a].value - best[i].value) * (others[b].value - best[j].value));
          }
        }
      }
      if (sum > 0.0) covariances[i * count + j] = covariance / sum;
    }
  }
  set_covariances(report, covariances);
}

}  // namespace limitcurve::fit::internal
