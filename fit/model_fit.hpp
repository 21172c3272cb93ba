// SPDX-License-Identifier: MIT
#pragma once

#include "contact_fit.hpp"
#include "curve_fit.hpp"
#include "load_fit.hpp"
#include "ratio_fit.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// Fits selected by name, for programs that get the name from a user.
namespace limitcurve::fit {

/// The result of a fit of any kind: `report.estimates` are the rows parameter, value, std_error, unit.
struct ModelFit {
  std::string model;  ///< the fitted model, or the best one
  FitReport report;
  std::optional<CurveError> error;  ///< against the exact curve, for fits to a law
  /// For fits to slips: distance of each sample from the curve in standard deviations, positive outside.
  std::vector<double> residuals = {};
};

/// Fits `ellipse` to the exact curve of a law, in unit wrenches.
/// All four throw std::invalid_argument that lists the models for an unknown name.
ModelFit fit_model(std::string_view model, const Law& law, Criterion criterion = Criterion::least_squares);

/// Fits `ellipse`, `ratio` or `law` to samples. `ratio` reports mu, mu_r, ratio, radius under the
/// law (default Hertz), with a warning that lists the radius under each other common law; `law`
/// does the same for the given law, or finds the law that explains the samples best.
ModelFit fit_model(std::string_view model, std::span<const Sample> samples, const Law& law = nullptr,
                   const ContactFitOptions& options = {});

/// Fits `ratio` to published ratios of several materials, under the law (default Hertz).
ModelFit fit_model(std::string_view model, std::span<const RatioSample> samples, const Law& law = nullptr);

/// Fits `load` to radii or moments at several loads: the best of linear, hertz and power.
ModelFit fit_model(std::string_view model, const LoadSamples& samples, const Loss& loss = {});

}  // namespace limitcurve::fit
