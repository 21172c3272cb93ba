// SPDX-License-Identifier: MIT
#pragma once

#include "fit/contact_fit.hpp"
#include "fit/internal/contact_residuals.hpp"

#include <memory>
#include <span>
#include <vector>

namespace limitcurve::fit::internal {

struct Limits {
  double force;   // μ
  double moment;  // μ_r at the reference load
};

/// What all models fitted to the same samples share, so that their likelihoods can be compared.
struct ContactPreparation {
  bool with_sigma;
  double reference_load;  // geometric mean: there the moment's limit and its growth are least correlated
  Limits start;
  double noise;  // what a unit of the weighted samples is, in sigmas
  std::vector<WeightedSample> samples;
};

/// Checks the samples, finds starting values, and weighs. Throws std::invalid_argument as `fit_contact` does.
ContactPreparation prepare(std::span<const Sample> samples, const ContactFitOptions& options);

std::unique_ptr<UnitCurve> make_curve(const ContactModel& model);
/// Whether the model's curve is that of a pressure law.
bool is_exact(const ContactModel& model);

/// The free parameters with their starting values and bounds, in the order of `layout`.
std::vector<Parameter> free_parameters(const UnitCurve& curve, const ContactLayout& layout, const ContactModel& model, Limits start);

/// Moves the start to where a robust loss sees most samples as good ones, and returns the loss to go on with. Seen from a start that is off by
/// many sigmas all samples are outliers, and any few of them are a minimum: so the loss begins as wide as the scatter is, and narrows with
/// it, down to the scale asked for. It stays as wide as the scatter of a model that does not fit, or of sigmas that are too small.
Loss approach(const ContactResiduals& residuals, std::vector<Parameter>& parameters, const Loss& loss);

}  // namespace limitcurve::fit::internal
