// SPDX-License-Identifier: MIT
#include "fit/contact_fit.hpp"

#include "fit/internal/contact_assumptions.hpp"
#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace limitcurve::fit {

using internal::ContactPreparation;

namespace {

/// The standard errors of a chosen law include the choice: with Akaike's weights w ∝ exp(−AICc/2) (Buckland, Burnham & Augustin 1997,
/// Biometrics 53:603–618), for each quantity of all candidates, se² = Σ w (se_i² + (value_i − value)²) about the value of the best.
/// A candidate without a value for a quantity is left out.
void include_choice(FitReport& report, const std::vector<ContactFit>& candidates) {
  for (Estimate& estimate : report.estimates) {
    double sum = 0.0;
    double variance = 0.0;
    for (const ContactFit& candidate : candidates) {
      for (const Estimate& other : candidate.report.estimates) {
        if (other.name != estimate.name || !std::isfinite(other.value) || !std::isfinite(other.std_error)) continue;
        const double weight = std::exp(0.5 * (report.aic - candidate.report.aic));
        sum += weight;
        variance += weight * (std::pow(other.std_error, 2) + std::pow(other.value - estimate.value, 2));
      }
    }
    const bool is_shape = estimate.name == "n" || estimate.name == "k";
    if (!is_shape && std::isfinite(estimate.value) && sum > 0.0) estimate.std_error = std::sqrt(variance / sum);
  }
}

LawSelection select_by(std::span<const Sample> samples, const ContactFitOptions& options) {
  const ContactPreparation preparation = internal::prepare(samples, options);
  LawSelection selection;
  const std::array<ContactModel, 8> models{ContactModel::of(flat_punch()),
                                           ContactModel::of(uniform()),
                                           ContactModel::of(hertz()),
                                           ContactModel::of(parabolic()),
                                           ContactModel::of(cone()),
                                           ContactModel::of(gaussian(1.0)),
                                           ContactModel{ContactModel::Kind::power},
                                           ContactModel{ContactModel::Kind::xydas_kao}};
  std::array<std::size_t, models.size()> order{};
  std::vector<ContactFit> fits;
  try {
    for (const ContactModel& model : models) fits.push_back(internal::fit_prepared(preparation, model, options));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) +
                                "; to distinguish laws, use slips that slide and twist at once, more of them than parameters");
  }
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return fits[a].report.aic < fits[b].report.aic; });
  for (const std::size_t i : order) selection.candidates.push_back(std::move(fits[i]));
  ContactFit& best = selection.candidates.front();
  internal::check_assumptions(best, samples, models.at(order.front()), options);
  best.report.note =
      internal::note_of(best.model + " (best of " + std::to_string(models.size()) + " laws by AICc; the errors include the choice)",
                        options, preparation.with_sigma);
  include_choice(best.report, selection.candidates);
  internal::test_scatter(best, samples, options.gamma, true);
  std::string rivals;
  std::string ties;
  for (const ContactFit& candidate : selection.candidates) {
    const double difference = candidate.report.aic - best.report.aic;
    selection.aic_difference.push_back(difference);
    if (&candidate != &best && difference < 2.0) {
      rivals += (rivals.empty() ? "" : ", ") + candidate.model + " (AICc difference " + format_number(difference, 3) + ")";
    } else if (&candidate != &best && std::max(candidate.report.rms, best.report.rms) < internal::perfect) {
      ties += (ties.empty() ? "" : ", ") + candidate.model;
    }
  }
  if (!rivals.empty()) best.report.warnings.push_back("the data cannot distinguish " + best.model + " from " + rivals);
  if (!ties.empty()) {
    best.report.warnings.push_back(best.model + " explains the samples to the last digit, and so does " + ties +
                                   ", with more parameters: the result is the law with fewer");
  }
  return selection;
}

}  // namespace

LawSelection select_law(std::span<const Sample> samples, const ContactFitOptions& options) {
  return internal::fit_or_outlive_outliers(options, [&](const ContactFitOptions& with) { return select_by(samples, with); });
}

}  // namespace limitcurve::fit
