// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limitcurve::fit {

/// One fitted (or derived) quantity.
struct Estimate {
  /// The property of the contact that is estimated, so that programs need not know names and units.
  enum class Role {
    force,   ///< mu, force_max
    moment,  ///< mu_r, moment_max
    ratio,
    radius,  ///< radius, or c if the radius grows with the load
    shape,   ///< n or k of a family of laws
    gamma,
    other,  ///< a property of the data or the fit
  };
  std::string name;  ///< such as "mu"; the function that fits lists the names
  double value = 0.0;
  /// Standard error, in the unit of the value: 0 for a fixed parameter, NaN in a fit to a curve, because a curve has
  /// no noise.
  double std_error = 0.0;
  std::string unit;  ///< SI, "1" if none
  Role role = Role::other;
};

/// The report of a fit. The standard errors come from the curvature of the cost at the solution. This is a linear
/// approximation, so the coverage tests of this module measure how often the intervals hold.
struct FitReport {
  std::vector<Estimate> estimates;
  /// Correlations of the estimates, row by row, estimates.size() squared; 0 where a standard error is 0.
  std::vector<double> correlation;
  /// Root mean square of the residuals, in the unit the fit documents.
  double rms = 0.0;
  /// Number of residuals, and of free parameters.
  std::size_t residuals = 0;
  std::size_t free_parameters = 0;
  /// Akaike's information criterion up to a constant of the data: compare only fits of the same data. If the noise is
  /// unknown, the criterion includes the correction for few samples (AICc), and is ∞ if the correction is undefined.
  double aic = 0.0;
  bool converged = false;
  int iterations = 0;
  /// Ceres' message about convergence.
  std::string message;
  /// The model and its assumptions, in a few words.
  std::string note;
  /// What a user must know before using the numbers: a sentence for each warning.
  std::vector<std::string> warnings;
  /// Whether the samples reject the assumed γ, and whether they scatter more than their sigmas say. If so, `warnings`
  /// says it, too.
  bool gamma_refused = false;
  bool scatter_refused = false;

  /// The estimate with this name; throws std::out_of_range if there is none.
  [[nodiscard]] const Estimate& at(std::string_view name) const;
  /// The estimate with this role; null if there is none.
  [[nodiscard]] const Estimate* find(Estimate::Role role) const noexcept;
  /// Correlation of two estimates by name; throws std::out_of_range if there is none.
  [[nodiscard]] double correlation_of(std::string_view first, std::string_view second) const;
};

}  // namespace limitcurve::fit
