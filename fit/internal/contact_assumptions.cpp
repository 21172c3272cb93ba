// SPDX-License-Identifier: MIT
#include "fit/internal/contact_assumptions.hpp"

#include "fit/internal/report.hpp"
#include "limitcurve/number.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

namespace limitcurve::fit::internal {

namespace {

/// Rows whose distance from the curve of a robust fit is beyond what the others' scatter explains: a normal error is as large in
/// one of 200 data sets. The scatter is the median's, with Rousseeuw's correction for few samples; without sigmas nothing
/// below a thousandth of the limits is gross.
std::vector<std::size_t> outliers_of(const Solution& robust, const ContactPreparation& preparation) {
  const auto count = static_cast<double>(robust.residuals.size());
  const double spare = count - static_cast<double>(robust.values.size());
  // With fewer to spare most rows lie on the curve, and the others look gross.
  if (spare < 3.0) return {};
  double scatter = 1.4826 * (1.0 + 5.0 / spare) * median_size(robust.residuals);
  if (preparation.with_sigma) scatter = std::max(scatter, 1.0);
  double gross = 3.0;
  while (count * std::erfc(gross / std::sqrt(2.0)) > 0.005) gross += 0.1;
  const double least = preparation.with_sigma ? 0.0 : 1e-3 / preparation.noise;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < robust.residuals.size(); ++i) {
    if (std::fabs(robust.residuals[i]) > std::max(gross * scatter, least)) rows.push_back(i);
  }
  return rows;
}

std::string list(const std::vector<std::size_t>& rows) {
  constexpr std::size_t most = 12;
  std::string text = rows.size() == 1 ? "row " : "rows ";
  for (std::size_t i = 0; i < std::min(rows.size(), most); ++i) text += (i == 0 ? "" : ", ") + std::to_string(rows[i] + 1);
  return rows.size() > most ? text + " and " + std::to_string(rows.size() - most) + " more" : text;
}

}  // namespace

std::string brief(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.3g", value);
  return buffer.data();
}

void check_assumptions(ContactFit& fit, std::span<const Sample> samples, const ContactModel& model, const ContactFitOptions& options) {
  ContactFitOptions robust = options;
  robust.loss = Loss::cauchy();
  const std::unique_ptr<UnitCurve> curve = make_curve(model);
  Estimate gamma;
  double rms = 0.0;
  double spare = 0.0;
  // With gamma free, where the loads tell it. What cannot be answered says nothing against the fit asked for.
  for (const bool fit_gamma : {true, options.fit_gamma}) {
    robust.fit_gamma = fit_gamma;
    try {
      const ContactPreparation preparation = prepare(samples, robust);
      const ContactLayout layout{!curve->shape_name().empty(), fit_gamma, options.gamma};
      std::vector<Parameter> parameters = free_parameters(*curve, layout, model, preparation.start);
      const ContactResiduals residuals(preparation.samples, *curve, layout);
      if (preparation.with_sigma) approach(residuals, parameters, robust.loss, coarse_tolerance);
      const Solution solution = minimise(residuals, parameters, robust.loss, coarse_tolerance);
      const std::vector<double> spread = covariance(solution, parameters, robust.loss, 1.0);
      if (fit_gamma) {
        gamma.value = solution.values.back();
        gamma.std_error = std::sqrt(spread.back());
        spare = static_cast<double>(samples.size()) - static_cast<double>(solution.values.size());
        rms = root_mean_square(solution.residuals) * preparation.noise;
      }
      fit.outliers = outliers_of(solution, preparation);
      break;
    } catch (const std::invalid_argument&) {
      gamma.value = options.gamma;
    }
  }
  if (!fit.outliers.empty()) {
    fit.report.warnings.push_back(list(fit.outliers) + " of " + std::to_string(samples.size()) +
                                  " (the first is 1): gross outliers; mislabelled, or taken while the finger held?" +
                                  (options.loss.kind == Loss::Kind::squared ? " The squared loss follows them; Cauchy's does not" : ""));
  }
  // As far off by chance in one of 2000 sets, by Student's distribution. The last digits of exact data are no growth.
  const double difference = std::fabs(gamma.value - options.gamma);
  if (options.fit_gamma || !(spare > 0.0) || difference < 1e-6) return;
  const double rare = boost::math::quantile(boost::math::students_t(spare), 1.0 - 0.5 / 2000.0);
  if (!(difference > rare * gamma.std_error)) return;
  fit.report.warnings.push_back("gamma = " + format_number(options.gamma) + " was assumed, but " + brief(gamma.value) + " +- " +
                                brief(gamma.std_error) + " explains the samples better: rms " + brief(rms) + " instead of " +
                                brief(fit.report.rms) + "; fit gamma too");
}

std::string note_of(const std::string& model, const ContactFitOptions& options, bool with_sigma) {
  return model + "; gamma " + (options.fit_gamma ? std::string("fitted") : "= " + format_number(options.gamma) + " assumed") + "; " +
         to_string(options.loss.kind) + " loss" + (with_sigma ? "" : "; errors proportional to the load assumed");
}

}  // namespace limitcurve::fit::internal
