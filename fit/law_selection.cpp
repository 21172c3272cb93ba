// SPDX-License-Identifier: MIT
#include "fit/contact_fit.hpp"

#include "fit/internal/contact_assumptions.hpp"
#include "fit/internal/edge.hpp"
#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <vector>

namespace limitcurve::fit {

using namespace internal;

namespace {

/// So many of the samples, evenly over load and slip, in any order of the rows the same: one of each of as many equal
/// parts, in the order of the slips within each hundredth of the loads.
std::vector<Sample> drawn(std::span<const Sample> samples, std::size_t count) {
  std::vector<Sample> all(samples.begin(), samples.end());
  const auto part = [&](std::size_t i, std::size_t parts) { return i * all.size() / parts; };
  const auto slip = [](const Sample& sample) { return std::atan2(std::fabs(sample.moment), std::fabs(sample.force)); };
  std::ranges::sort(all, {}, [](const Sample& sample) { return std::tuple(sample.load, sample.force, sample.moment); });
  constexpr std::size_t groups = 100;
  for (std::size_t i = 0; i < groups; ++i)
    std::ranges::stable_sort(std::span(all).subspan(part(i, groups), part(i + 1, groups) - part(i, groups)), {}, slip);
  std::minstd_rand random(1);
  std::vector<Sample> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(all[part(i, count) + random() % (part(i + 1, count) - part(i, count))]);
  return result;
}

LawSelection select_by(std::span<const Sample> samples, const ContactFitOptions& options) {
  const ContactPreparation of_all = internal::prepare(samples, options);
  const std::size_t rows = std::min(samples.size(), options.rows_of_choice);
  const ContactPreparation preparation =
      rows < samples.size() ? internal::prepare(drawn(samples, rows), options) : of_all;
  const std::size_t least = least_rows_of_choice(options.fit_gamma ? 4 : 3);
  if (rows < least)
    throw std::invalid_argument(std::to_string(rows) + " samples are too few to choose a law, expected at least " +
                                std::to_string(least) + ", or name a law");
  LawSelection selection;
  // The families, a Gaussian whose radius is sigma, and every law of one shape. A pressure like 1/ρ at the
  // centre is none: it would explain every peak there, and hide that no law does.
  std::vector<ContactModel> models{
      {ContactModel::Kind::power}, {ContactModel::Kind::xydas_kao}, ContactModel::of(gaussian(1.0))};
  for (const std::string_view law : law_examples()) {
    if (law.find(':') != std::string_view::npos) continue;
    const Law one = parse_law(law);
    constexpr double near = 1e-9;
    if (one->density(RadialPosition<double>{near, 1.0 - near}) * near < 1e-3) models.push_back(ContactModel::of(one));
  }
  std::vector<std::size_t> order(models.size());
  std::vector<ContactFit> fits;
  try {
    for (const ContactModel& model : models) fits.push_back(internal::fit_prepared(preparation, model, options));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) +
                                ". To tell laws apart, record slips that slide and twist at once, and more slips than "
                                "the model has parameters");
  }
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return fits[a].report.aic < fits[b].report.aic; });
  for (const std::size_t i : order) selection.candidates.push_back(std::move(fits[i]));
  ContactFit& best = selection.candidates.front();
  std::string rivals;
  std::string ties;
  for (const ContactFit& candidate : selection.candidates) {
    const double difference = candidate.report.aic - best.report.aic;
    selection.aic_difference.push_back(difference);
    if (&candidate != &best && difference < 2.0) {
      rivals +=
          (rivals.empty() ? "" : ", ") + candidate.model + " (AIC difference " + format_number(difference, 3) + ")";
    } else if (&candidate != &best && std::max(candidate.report.rms, best.report.rms) < perfect) {
      ties += (ties.empty() ? "" : ", ") + candidate.model;
    }
  }
  const std::vector<double> alone = covariances_of(best.report);
  include_choice(best.report, selection.candidates);
  if (rows < samples.size()) {
    ContactFit fit = internal::fit_prepared(of_all, models.at(order.front()), options);
    const std::vector<double> chosen = covariances_of(best.report);
    std::vector<double> all = covariances_of(fit.report);
    const std::size_t count = fit.report.estimates.size();
    const auto of_choice = [&](std::size_t i, std::size_t j) { return chosen[i * count + j] - alone[i * count + j]; };
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j)
        all[i * count + j] += of_choice(i, i) > 0.0 && of_choice(j, j) > 0.0 ? of_choice(i, j) : 0.0;
    }
    set_covariances(fit.report, all);
    best = std::move(fit);
  }
  internal::check_assumptions(best, samples, models.at(order.front()), options);
  const std::string chosen_with =
      rows < samples.size() ? ", with " + std::to_string(rows) + " rows drawn evenly over load and slip" : "";
  best.report.note = internal::note_of(best.model + " (best of " + std::to_string(models.size()) + " laws by AIC" +
                                           chosen_with + "; the errors include the choice, but for n and k)",
                                       options, samples.size() - best.report.free_parameters, preparation.with_sigma);
  test_scatter(best, samples, of_all, options);
  if (!rivals.empty()) best.report.warnings.push_back("the data cannot distinguish " + best.model + " from " + rivals);
  if (!ties.empty()) {
    best.report.warnings.push_back(best.model + " explains the samples to the last digit, and so does " + ties +
                                   ", with more parameters: the result is the law with fewer");
  }
  return selection;
}

/// Without the families: below the limit a wrench says nothing of a shape.
LawSelection select_edge(std::span<const Sample> samples, const ContactFitOptions& options) {
  LawSelection selection;
  for (const Law& law : {flat_punch(), uniform(), hertz(), parabolic(), cone(), gaussian(1.0)})
    selection.candidates.push_back(fit_edge(samples, ContactModel::of(law), options));
  std::ranges::stable_sort(selection.candidates, {}, [](const ContactFit& fit) { return fit.report.aic; });
  ContactFit& best = selection.candidates.front();
  include_choice(best.report, selection.candidates);
  std::string rivals;
  for (const ContactFit& candidate : selection.candidates) {
    selection.aic_difference.push_back(candidate.report.aic - best.report.aic);
    if (&candidate != &best && selection.aic_difference.back() < 2.0)
      rivals += (rivals.empty() ? "" : ", ") + candidate.model;
  }
  best.report.note +=
      "; best of " + std::to_string(selection.candidates.size()) + " laws, the errors include the choice";
  if (!rivals.empty()) best.report.warnings.push_back("the data cannot distinguish " + best.model + " from " + rivals);
  return selection;
}

}  // namespace

LawSelection select_law(std::span<const Sample> samples, const ContactFitOptions& options) {
  if (options.loss.kind == Loss::Kind::edge) return select_edge(samples, options);
  return fit_or_outlive_outliers(options, [&](const ContactFitOptions& with) {
    return fit_beside_holds(samples, with, [&](std::span<const Sample> some) { return select_by(some, with); });
  });
}

}  // namespace limitcurve::fit
