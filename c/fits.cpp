// SPDX-License-Identifier: MIT
#include "c/limitcurve_fit.h"

#include "c/handles.hpp"
#include "fit/model_fit.hpp"
#include "limitcurve/internal/names.hpp"

#include <vector>

using namespace limitcurve;
using namespace limitcurve::c;

struct limitcurve_fit {
  fit::ModelFit found;
};

namespace {

limitcurve_fit converged(fit::ModelFit found) {
  if (!found.report.converged) throw std::runtime_error("the fit did not converge: " + found.report.message);
  return {std::move(found)};
}

}  // namespace

limitcurve_status limitcurve_fit_slips(const char* model, const double* loads, const double* forces,
                                       const double* moments, const double* sigma_forces, const double* sigma_moments,
                                       size_t count, const limitcurve_law* law, double gamma, limitcurve_fit** fit) {
  if (is_missing("model", model) || (law != nullptr && is_no_handle("law", law))) return LIMITCURVE_INVALID;
  if (count > 0 && any_missing({{"loads", loads}, {"forces", forces}, {"moments", moments}})) return LIMITCURVE_INVALID;
  if ((sigma_forces == nullptr) != (sigma_moments == nullptr))
    return refuse("sigma_forces", "got one of sigma_forces and sigma_moments, expected both or none");
  return make_handle(fit, [&] {
    std::vector<fit::Sample> samples;
    for (std::size_t i = 0; i < count; ++i) {
      samples.push_back({loads[i], forces[i], moments[i]});
      if (sigma_forces == nullptr) continue;
      samples.back().sigma_force = sigma_forces[i];
      samples.back().sigma_moment = sigma_moments[i];
    }
    fit::FitOptions options;
    options.gamma = gamma;
    if (law != nullptr) options.law = law->law;
    return converged(fit::fit(fit::parse_kind(model), samples, options));
  });
}

limitcurve_status limitcurve_fit_radii(const char* model, const double* loads, const double* radii,
                                       const double* sigmas, size_t count, limitcurve_fit** fit) {
  if (is_missing("model", model) || (count > 0 && any_missing({{"loads", loads}, {"radii", radii}})))
    return LIMITCURVE_INVALID;
  return make_handle(fit, [&] {
    fit::LoadSamples samples;
    for (std::size_t i = 0; i < count; ++i)
      samples.samples.push_back({loads[i], radii[i], sigmas == nullptr ? 0.0 : sigmas[i]});
    fit::FitOptions options;
    options.load_model = parse_name<fit::LoadModel>(fit::load_model_names, "model", model);
    return converged(fit::fit(fit::Kind::load, samples, options));
  });
}

void limitcurve_fit_free(limitcurve_fit* fit) {
  free_handle(fit);
}

const char* limitcurve_fit_model(const limitcurve_fit* fit) {
  return is_no_handle("fit", fit) ? nullptr : fit->found.model.c_str();
}

const char* limitcurve_fit_note(const limitcurve_fit* fit) {
  return is_no_handle("fit", fit) ? nullptr : fit->found.report.note.c_str();
}

const char* limitcurve_fit_warning(const limitcurve_fit* fit, size_t index) {
  if (is_no_handle("fit", fit) || index >= fit->found.report.warnings.size()) return nullptr;
  return fit->found.report.warnings[index].c_str();
}

size_t limitcurve_fit_count(const limitcurve_fit* fit) {
  return is_no_handle("fit", fit) ? 0 : fit->found.report.estimates.size();
}

limitcurve_status limitcurve_fit_estimate(const limitcurve_fit* fit, size_t index, const char** name, double* value,
                                          double* std_error, const char** unit) {
  if (is_no_handle("fit", fit)) return LIMITCURVE_INVALID;
  if (index >= limitcurve_fit_count(fit)) return refuse("index", "expected less than limitcurve_fit_count()");
  const fit::Estimate& estimate = fit->found.report.estimates[index];
  if (name != nullptr) *name = estimate.name.c_str();
  if (value != nullptr) *value = estimate.value;
  if (std_error != nullptr) *std_error = estimate.std_error;
  if (unit != nullptr) *unit = estimate.unit.c_str();
  return LIMITCURVE_OK;
}
