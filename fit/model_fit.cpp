// SPDX-License-Identifier: MIT
#include "fit/model_fit.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve::fit {

namespace {

std::invalid_argument unknown(std::string_view model, const char* expected) {
  return std::invalid_argument("model '" + std::string(model) + "': expected " + expected);
}

/// A sentence with the radius that the ratio implies under each common law.
std::string radii(const Estimate& ratio) {
  std::string text = "the ratio implies a contact radius of";
  const char* separator = " ";
  for (const Law& law : {flat_punch(), hertz(), uniform(), parabolic()}) {
    text += separator + format_number(1e3 * implied_radius(ratio, *law).value, 3) + " mm (" + law->name() + ")";
    separator = ", ";
  }
  return text;
}

}  // namespace

ModelFit fit_model(std::string_view model, const Law& law, Criterion criterion) {
  if (model != "ellipse") throw unknown(model, "ellipse for the curve of a law");
  const CurveFit fit = fit_ellipse(law, criterion);
  return {std::string(model), fit.report, fit.error};
}

ModelFit fit_model(std::string_view model, std::span<const Sample> samples, const Law& law,
                   const ContactFitOptions& options) {
  using Kind = ContactModel::Kind;
  const auto done = [](ContactFit fit) {
    return ModelFit{std::move(fit.model), std::move(fit.report), std::nullopt, std::move(fit.residuals)};
  };
  if (model == "ellipse") return done(fit_contact(samples, {Kind::ellipse}, options));
  if (model == "law") {
    if (law) return done(fit_contact(samples, ContactModel::of(law), options));
    return done(std::move(select_law(samples, options).candidates.front()));
  }
  if (model == "ratio") {
    ModelFit fit = done(fit_contact(samples, ContactModel::of(law ? law : hertz()), options));
    if (options.gamma == 0.0 && !options.fit_gamma) fit.report.warnings.push_back(radii(fit.report.at("ratio")));
    return fit;
  }
  throw unknown(model, "ellipse, ratio or law for samples of load, force and moment");
}

ModelFit fit_model(std::string_view model, std::span<const RatioSample> samples, const Law& law) {
  if (model != "ratio") throw unknown(model, "ratio for published ratios");
  return {"ratio", fit_ratio(samples, *(law ? law : hertz())), std::nullopt};
}

ModelFit fit_model(std::string_view model, const LoadSamples& samples, const Loss& loss) {
  if (model != "load") throw unknown(model, "load for samples of radius or moment over the load");
  LoadSelection selection = select_load(samples, loss);
  LoadFit& best = selection.candidates.front();
  return {to_string(best.model), std::move(best.report), std::nullopt};
}

}  // namespace limitcurve::fit
