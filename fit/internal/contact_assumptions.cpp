// SPDX-License-Identifier: MIT
#include "fit/internal/contact_assumptions.hpp"

#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace limitcurve::fit::internal {

void check_assumptions(ContactFit& fit, std::span<const Sample> samples, const ContactModel& model, const ContactFitOptions& options) {
  ContactFitOptions robust = options;
  robust.loss = Loss::cauchy();
  const std::unique_ptr<UnitCurve> curve = make_curve(model);
  Estimate gamma;
  double rms = 0.0;
  double spare = 0.0;
  // Gamma is free if the loads determine it. If this fit fails, the requested fit stands.
  for (const bool fit_gamma : {true, options.fit_gamma}) {
    robust.fit_gamma = fit_gamma;
    try {
      const ContactPreparation preparation = prepare(samples, robust);
      const ContactLayout layout{!curve->shape_name().empty(), fit_gamma, options.gamma};
      std::vector<Parameter> parameters = free_parameters(*curve, layout, model, preparation.start);
      const ContactResiduals residuals(preparation.samples, *curve, layout);
      const Loss loss = approach(residuals, parameters, robust.loss);
      const Solution solution = minimise(residuals, parameters, loss, coarse_tolerance);
      const std::vector<double> spread = covariance(solution, parameters, loss, 1.0);
      if (fit_gamma) {
        gamma.value = solution.values.back();
        gamma.std_error = std::sqrt(spread.back());
        spare = static_cast<double>(samples.size()) - static_cast<double>(solution.values.size());
        rms = root_mean_square(solution.residuals) * preparation.noise;
      }
      fit.outliers = outliers_of(solution, preparation.with_sigma, preparation.noise);
      break;
    } catch (const std::invalid_argument&) {
      gamma.value = options.gamma;
    }
  }
  warn_of_outliers(fit.report, fit.outliers, options.loss);
  if (!options.fit_gamma) warn_of_growth(fit.report, options.gamma, gamma, spare, rms);
}

std::string note_of(const std::string& model, const ContactFitOptions& options, bool with_sigma) {
  return model + "; gamma " + (options.fit_gamma ? std::string("fitted") : "= " + format_number(options.gamma) + " assumed") + "; " +
         to_string(options.loss.kind) + " loss" + (with_sigma ? "" : "; errors proportional to the load assumed");
}

}  // namespace limitcurve::fit::internal
