// SPDX-License-Identifier: MIT
#pragma once

#include "estimate.hpp"
#include "measurements.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace limitcurve::fit {

/// How a contact grows with the load: a(P) = c P^γ, so the moment of a pure twist is Γ(P) = μ_r P^{1+γ}.
enum class LoadModel {
  linear,  ///< γ = 0: constant radius, the paper's Γ = μ_r P
  hertz,   ///< γ = 1/3: elastic sphere
  power,   ///< γ free, −0.5 to 1.5 (physical: 0 to 1/3)
  best,    ///< the best of these by AIC
};

/// In the order of LoadModel.
inline constexpr std::array<std::string_view, 4> load_model_names{"linear", "hertz", "power", "best"};
constexpr const char* to_string(LoadModel model) noexcept {
  return load_model_names[static_cast<std::size_t>(model)].data();
}

/// Estimates c [m/N^γ] (from radii) or mu_r [m/N^γ] (from moments), then gamma [1]; the standard error of a fixed γ is
/// 0.
struct LoadFit {
  LoadModel model;  ///< never `best`
  FitReport report;
};

/// Fits by least squares of the values in units of their sigmas. If there are no sigmas, errors are taken as relative:
/// the fit is by least squares of the logarithms, and `report.rms` is the size of the errors, from the scatter.
/// Starting values come from the data. Cost: below 1 ms. Throws std::invalid_argument that names a bad sample, or the
/// parameters that the data do not determine (γ from one load).
LoadFit fit_load(const LoadSamples& samples, LoadModel model, const Loss& loss = {});

/// The fits of the three models and their `aic_difference`, best first by AIC. The report of the best model warns of
/// every model that the data cannot distinguish from it (difference below 2). The standard errors are those of the
/// power law, which contains the other models, and the difference from the power law. Fewer than 5 rows are too few for
/// a choice, so they give the power law.
struct LoadSelection {
  std::vector<LoadFit> candidates;
  std::vector<double> aic_difference;
};
LoadSelection select_load(const LoadSamples& samples, const Loss& loss = {});

}  // namespace limitcurve::fit
