// SPDX-License-Identifier: MIT
#pragma once

#include "estimate.hpp"
#include "measurements.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace limitcurve::fit {

/// Growth of a contact with the load: a(P) = c P^γ, and so the moment of a pure twist is Γ(P) = μ_r P^{1+γ}.
enum class LoadModel {
  linear,  ///< γ = 0: constant radius, the paper's Γ = μ_r P
  hertz,   ///< γ = 1/3: elastic sphere
  power,   ///< γ free, −0.5 to 1.5 (physical: 0 to 1/3)
  best,    ///< of these, by AIC
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

/// Least squares of the values in units of their sigmas. Without sigmas, least squares of their logarithms: errors are
/// relative, and `report.rms` is their size, from the scatter. Starting values come from the data. Cost: below 1 ms.
/// Throws std::invalid_argument that names a bad sample, or the parameters that the data do not determine (γ from one
/// load).
LoadFit fit_load(const LoadSamples& samples, LoadModel model, const Loss& loss = {});

/// The fits of the three models, best first by AIC; `aic_difference` in the same order. The report of the best warns
/// of every model that the data cannot distinguish from it (difference below 2). Its standard errors are those of the
/// power law, which contains the other two, and the difference from it. Fewer than 5 rows are too few
/// for a choice, and give the power law.
struct LoadSelection {
  std::vector<LoadFit> candidates;
  std::vector<double> aic_difference;
};
LoadSelection select_load(const LoadSamples& samples, const Loss& loss = {});

}  // namespace limitcurve::fit
