// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/measurements.hpp"

#include <string>
#include <vector>

namespace limitcurve::fit {

/// How a contact grows with the load: a(P) = c P^γ, and with it the moment of a pure twist, Γ(P) = μ_r P^{1+γ}.
enum class LoadModel {
  linear,  ///< γ = 0: constant radius, the paper's Γ = μ_r P
  hertz,   ///< γ = 1/3: elastic sphere
  power,   ///< γ free, −0.5 to 1.5 (physical: 0 to 1/3)
};

/// linear, hertz, power.
const char* to_string(LoadModel model) noexcept;

/// Estimates c [m/N^γ] (from radii) or mu_r [m/N^γ] (from moments), then gamma [1]; γ's standard error is 0 where it is fixed.
struct LoadFit {
  LoadModel model;
  FitReport report;
};

/// Least squares of the values in units of their sigmas; without sigmas, of their logarithms, so that errors are
/// relative, of one size found from the scatter, which `report.rms` then is. Starting values come from the data. Cost: below 1 ms.
/// Throws std::invalid_argument that names the sample for bad ones, or the parameters that cannot be told (γ from one load).
LoadFit fit_load(const LoadSamples& samples, LoadModel model, const Loss& loss = {});

/// The three models against each other, best first by AICc; `aic_difference` in the same order. The best one's report warns
/// of every model that the data cannot tell from it (difference below 2).
struct LoadSelection {
  std::vector<LoadFit> candidates;
  std::vector<double> aic_difference;
};
LoadSelection select_load(const LoadSamples& samples, const Loss& loss = {});

}  // namespace limitcurve::fit
