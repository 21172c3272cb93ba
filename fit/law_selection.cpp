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
  best.report.note = internal::note_of(
      best.model + " (best of " + std::to_string(models.size()) + " laws by AICc; the errors include the choice, but for n and k)", options,
      samples.size() - best.report.free_parameters, preparation.with_sigma);
  internal::include_choice(best.report, selection.candidates);
  internal::test_scatter(best, samples, options.gamma);
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
