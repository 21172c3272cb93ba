// SPDX-License-Identifier: MIT
#include "fit/model_fit.hpp"

#include "limitcurve/internal/names.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <stdexcept>

namespace limitcurve::fit {

namespace {

using Slips = std::span<const Sample>;
using Ratios = std::span<const RatioSample>;

template <class Wanted>
const Wanted& only(Kind kind, const Data& data, const char* expected) {
  if (const auto* const found = std::get_if<Wanted>(&data)) return *found;
  throw std::invalid_argument("fit " + std::string(kind_names[static_cast<std::size_t>(kind)]) + ": expected " +
                              expected);
}

ModelFit of_contact(ContactFit fit) {
  return {std::move(fit.model), std::move(fit.report), std::nullopt, std::move(fit.residuals)};
}

ModelFit best_law(Slips slips, const FitOptions& options) {
  LawSelection selection = select_law(slips, options);
  std::vector<std::pair<std::string, double>> candidates;
  for (std::size_t i = 0; i < selection.candidates.size(); ++i)
    candidates.emplace_back(selection.candidates[i].model, selection.aic_difference[i]);
  ModelFit best = of_contact(std::move(selection.candidates.front()));
  best.candidates = std::move(candidates);
  return best;
}

ModelFit growth(const LoadSamples& samples, const FitOptions& options) {
  const bool compares = options.load_model == LoadModel::best || options.load_model == LoadModel::power;
  const LoadSelection selection = compares ? select_load(samples, options.loss) : LoadSelection{};
  const LoadFit found = options.load_model == LoadModel::best ? selection.candidates.front()
                                                              : fit_load(samples, options.load_model, options.loss);
  ModelFit fit{to_string(found.model), found.report, std::nullopt};
  for (std::size_t i = 0; i < selection.candidates.size() && selection.candidates.size() > 1; ++i)
    fit.candidates.emplace_back(to_string(selection.candidates[i].model), selection.aic_difference[i]);
  return fit;
}

}  // namespace

Kind parse_kind(std::string_view text) {
  return parse_name<Kind>(kind_names, "model", text);
}

ModelFit fit(Kind kind, const Data& data, const FitOptions& options) {
  const Law law = options.law ? options.law : hertz();
  switch (kind) {
    case Kind::ellipse: {
      if (const Law* const curve = std::get_if<Law>(&data)) {
        const CurveFit found = fit_ellipse(checked(*curve), options.criterion);
        return {"ellipse", found.report, found.error};
      }
      return of_contact(fit_contact(only<Slips>(kind, data, "slips or a law"), {ContactModel::Kind::ellipse}, options));
    }
    case Kind::ratio: {
      if (const auto* const ratios = std::get_if<Ratios>(&data))
        return {"ratio", fit_ratio(*ratios, *law), std::nullopt};
      return of_contact(
          fit_contact(only<Slips>(kind, data, "slips or published ratios"), ContactModel::of(law), options));
    }
    case Kind::law: {
      const Slips measured = only<Slips>(kind, data, "slips of load, force and moment");
      return options.law ? of_contact(fit_contact(measured, ContactModel::of(law), options))
                         : best_law(measured, options);
    }
    case Kind::load:
      return growth(only<LoadSamples>(kind, data, "radii or moments at several loads"), options);
    case Kind::friction: {
      const auto& [patch, pushes, load] = only<Pushes>(kind, data, "pushes of a patch");
      FrictionFit found = fit_friction(patch, pushes, load.value_or(1.0), load ? "1" : "N");
      ModelFit fit{"friction", {}, std::nullopt};
      fit.report.estimates = std::move(found.estimates);
      fit.report.warnings = std::move(found.warnings);
      fit.report.note = std::move(found.note);
      fit.report.converged = true;
      return fit;
    }
  }
  return {};
}

}  // namespace limitcurve::fit
