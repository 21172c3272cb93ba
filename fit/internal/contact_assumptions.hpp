// SPDX-License-Identifier: MIT
#pragma once

#include "fit/contact_fit.hpp"
#include "fit/internal/contact_preparation.hpp"

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The assumptions of a fit to samples, and tests of them.
namespace limitcurve::fit::internal {

/// The fit of one model; fits to the same preparation can be compared.
ContactFit fit_prepared(const ContactPreparation& preparation, const ContactModel& model,
                        const ContactFitOptions& options);

/// Fills in estimates and band from the parameters of `layout` and their covariance: from the logarithms at the
/// reference load to the quantities, at 1 N if the radius depends on the load. Warns of
/// a larger radius.
void report_limits(ContactFit& fit, UnitCurve& curve, const ContactLayout& layout, const ContactModel& model,
                   std::span<const double> values, std::span<const double> covariance, double reference_load,
                   double largest_radius);

/// Tests two assumptions, that no row is a gross error and that the radius is proportional to P^gamma, with a fit with
/// Cauchy's loss and free gamma. Adds outliers and warnings to the fit.
void check_assumptions(ContactFit& fit, std::span<const Sample> samples, const ContactModel& model,
                       const ContactFitOptions& options);

/// Tests two more: that rows scatter to both sides of it (none was taken while the finger held), and that the residuals
/// are noise, not a function of the place on the curve (another law made the samples, or no ellipse). The fit is of
/// this preparation with these options.
///
/// In the normalised plane the relative distance from the curve is fitted by g(φ) = Σ c_k cos 2kφ, k < 4, φ the polar
/// angle, without gross outliers. An F test warns of what chance gives in 1 of 500 data sets. What chance gives in 1 of
/// 20 enters the standard errors: g is what the law may be off by, at φ = 0 of mu, at π/2 of mu_r, the difference of
/// ratio and radius.
void test_scatter(ContactFit& fit, std::span<const Sample> samples, const ContactPreparation& preparation,
                  const ContactFitOptions& options);

/// The note beside each estimate: the model and its assumptions; `spare` rows more than parameters.
std::string note_of(const std::string& model, const ContactFitOptions& options, std::size_t spare, bool with_sigma);

/// Rows below the limits in which the finger held, if a robust `fit` (its own best, of `refit`) follows them: more than
/// 3 % of the rows lie outside its curve by more than 4 standard deviations, where no hold can be, and the curve of the
/// outermost rows agrees with rows in more directions of slip, for a long hold is one direction. Empty otherwise.
/// `gamma` is that assumed.
std::vector<std::size_t> rows_held(std::span<const Sample> samples, const ContactFit& fit, double gamma,
                                   const std::function<ContactFit(std::span<const Sample>)>& refit);

/// The fit of the other rows, as one of all: residuals of the rows held, which count as outliers, and a warning.
void include_held(ContactFit& fit, std::span<const Sample> samples, double gamma, const std::vector<std::size_t>& held);

/// The samples at the places that `places` does not list.
std::vector<Sample> without(std::span<const Sample> samples, const std::vector<std::size_t>& places);

inline ContactFit& best_of(ContactFit& fit) noexcept {
  return fit;
}
inline ContactFit& best_of(LawSelection& selection) noexcept {
  return selection.candidates.front();
}

/// Calls `fit(samples)`, which returns a ContactFit or LawSelection, and again without the rows that were held.
template <class Fit>
auto fit_beside_holds(std::span<const Sample> samples, const ContactFitOptions& options, const Fit& fit) {
  auto found = fit(samples);
  if (options.loss.kind == Loss::Kind::squared) return found;
  const std::vector<std::size_t> held =
      rows_held(samples, best_of(found), options.gamma, [&](std::span<const Sample> some) {
        auto again = fit(some);
        return best_of(again);
      });
  if (held.empty()) return found;
  found = fit(without(samples, held));
  include_held(best_of(found), samples, options.gamma, held);
  return found;
}

/// Calls `fit(options)`, which returns a ContactFit or LawSelection. If gross outliers leave the squared loss without a
/// solution, calls it with Cauchy's loss and adds a warning.
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
      // Cauchy's loss has no solution either: report the first error.
    }
    if (!found || best_of(*found).outliers.empty()) throw;
    best_of(*found).report.warnings.push_back(std::string("by the squared loss ") + refusal.what() +
                                              "; the outliers do that: this is the fit by Cauchy's loss");
    return *std::move(found);
  }
}

}  // namespace limitcurve::fit::internal
