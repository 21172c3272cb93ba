// SPDX-License-Identifier: MIT
#pragma once

#include "fit/contact_fit.hpp"
#include "fit/internal/contact_residuals.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace limitcurve::fit::internal {

struct Limits {
  double force;   // μ
  double moment;  // μ_r at the reference load
};

/// Data shared by all models of the same samples, so that their likelihoods can be compared.
struct ContactPreparation {
  bool with_sigma;
  double reference_load;  // geometric mean: there the moment limit and its growth have the least correlation
  Limits start;
  double noise;  // unit of the weighted samples, in sigmas
  std::vector<WeightedSample> samples;
};

inline constexpr std::array<double, 2> gamma_range{-0.5, 1.0};

/// Checks the samples, finds starting values and weights. Throws std::invalid_argument as `fit_contact` does.
ContactPreparation prepare(std::span<const Sample> samples, const ContactFitOptions& options);

std::unique_ptr<UnitCurve> make_curve(const ContactModel& model);
/// Whether the model's curve belongs to a pressure law.
bool is_exact(const ContactModel& model);

/// The free parameters with their starting values and bounds, in the order of `layout`.
std::vector<Parameter> free_parameters(const UnitCurve& curve, const ContactLayout& layout, const ContactModel& model,
                                       Limits start);

/// Moves the start to where a robust loss accepts most samples, and returns the loss for the fit. From a start that is
/// off by many sigmas all samples are outliers, and any few of them make a minimum. So the loss begins as wide as the
/// scatter and narrows with it, down to the requested scale. It stays wide if the model does not fit or the sigmas are
/// too small.
Loss approach(const ContactResiduals& residuals, std::vector<Parameter>& parameters, const Loss& loss);

}  // namespace limitcurve::fit::internal
