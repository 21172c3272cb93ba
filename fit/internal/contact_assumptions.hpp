// SPDX-License-Identifier: MIT
#pragma once

#include "fit/contact_fit.hpp"
#include "fit/internal/contact_preparation.hpp"

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

/// What a fit to samples takes for granted, and whether the samples speak against it.
namespace limitcurve::fit::internal {

/// The fit of one model; several to the same preparation can be compared.
ContactFit fit_prepared(const ContactPreparation& preparation, const ContactModel& model, const ContactFitOptions& options);

/// Tries what was assumed, that no row is a gross error and that the radius grows as P^gamma, by a fit with Cauchy's loss and
/// gamma free. Adds outliers and warnings to the fit.
void check_assumptions(ContactFit& fit, std::span<const Sample> samples, const ContactModel& model, const ContactFitOptions& options);

/// What a reader must know of any estimate: the model, and what was taken for granted.
std::string note_of(const std::string& model, const ContactFitOptions& options, bool with_sigma);

inline ContactFit& best_of(ContactFit& fit) noexcept {
  return fit;
}
inline ContactFit& best_of(LawSelection& selection) noexcept {
  return selection.candidates.front();
}

/// `fit(options)`, a ContactFit or LawSelection; where gross outliers leave the squared loss without an answer (a curve stretched
/// to them is nearer to the rest than it should be), Cauchy's loss gives it, and a warning says so.
template <class Fit>
auto fit_or_outlive_outliers(const ContactFitOptions& options, const Fit& fit) {
  try {
    return fit(options);
  } catch (const std::invalid_argument& refusal) {
    if (options.loss.kind != Loss::Kind::squared) throw;
    ContactFitOptions robust = options;
    robust.loss = Loss::cauchy();
    std::optional<decltype(fit(options))> found;
    try {
      found = fit(robust);
    } catch (const std::invalid_argument&) {
      // Nor has it an answer: the first refusal counts.
    }
    if (!found || best_of(*found).outliers.empty()) throw;
    best_of(*found).report.warnings.push_back(std::string("by the squared loss ") + refusal.what() +
                                              "; the outliers do that: this is the fit by Cauchy's loss");
    return *std::move(found);
  }
}

}  // namespace limitcurve::fit::internal
