// SPDX-License-Identifier: MIT
#pragma once

#include "fit/contact_fit.hpp"
#include "fit/curve_fit.hpp"
#include "fit/load_fit.hpp"
#include "fit/ratio_fit.hpp"

#include <optional>
#include <span>
#include <string_view>

/// The fits by name, for those who take the name from a user.
namespace limitcurve::fit {

/// What a fit of any kind reports: `report.estimates` are the rows parameter, value, std_error, unit.
struct ModelFit {
  std::string model;  ///< the model that was fitted, or that won
  FitReport report;
  std::optional<CurveError> error;  ///< against the exact curve, for fits to one
};

/// `ellipse`, `superellipse` or `quartic` to the exact curve of a law, in unit wrenches.
/// These throw std::invalid_argument that lists what was expected for an unknown model.
ModelFit fit_model(std::string_view model, const Law& law, Criterion criterion = Criterion::least_squares);

/// `ellipse`, `superellipse`, `quartic`, `ratio` or `law` to samples. `ratio` reports mu, mu_r, ratio, radius under the law
/// (Hertz if none is given), its report warning of the radius that each other common law implies; `law` does the
/// same for the law given, or else finds the law that explains the samples best.
ModelFit fit_model(std::string_view model, std::span<const Sample> samples, const Law& law = nullptr,
                   const ContactFitOptions& options = {});

/// `ratio` to published ratios of several materials, under the law (Hertz if none is given).
ModelFit fit_model(std::string_view model, std::span<const RatioSample> samples, const Law& law = nullptr);

/// `load` to radii or moments over the load: the best of linear, hertz and power.
ModelFit fit_model(std::string_view model, const LoadSamples& samples, const Loss& loss = {});

}  // namespace limitcurve::fit
