// SPDX-License-Identifier: MIT
#include "fit/internal/contact_assumptions.hpp"

#include "fit/internal/chance.hpp"
#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

namespace limitcurve::fit::internal {

void check_assumptions(ContactFit& fit, std::span<const Sample> samples, const ContactModel& model,
                       const ContactFitOptions& options) {
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

void test_scatter(ContactFit& fit, std::span<const Sample> samples, const ContactPreparation& preparation,
                  const ContactFitOptions& options) {
  constexpr Eigen::Index waves = 4;
  FitReport& report = fit.report;
  double gamma = options.gamma;
  const double mu = report.estimates[0].value;
  const double mu_r = report.estimates[1].value;
  for (const Estimate& estimate : report.estimates) {
    if (estimate.name == "gamma") gamma = estimate.value;
  }
  // Without sigmas residuals of the squared loss are in standard deviations, others in the typical error. With as many
  // parameters as rows nothing scatters.
  const auto rows = static_cast<double>(report.residuals);
  const double unit =
      options.loss.kind != Loss::Kind::squared
          ? preparation.noise
          : report.rms * std::sqrt(rows / std::max(1.0, rows - static_cast<double>(report.free_parameters)));
  const auto count = static_cast<Eigen::Index>(samples.size() - fit.outliers.size());
  Eigen::MatrixXd columns(count, waves);
  Eigen::VectorXd residuals(count);
  std::vector<double> distances;
  double curved = 0.0;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double force = mu * samples[i].load;
    const double moment = mu_r * std::pow(samples[i].load, 1.0 + gamma);
    const double angle = std::atan2(std::fabs(samples[i].moment) / moment, std::fabs(samples[i].force) / force);
    const double force_noise = samples[i].sigma_force / force;
    const double moment_noise = samples[i].sigma_moment / moment;
    if (force_noise > 0.0)
      curved = std::max({curved, moment_noise * moment_noise / force_noise, force_noise * force_noise / moment_noise});
    // A standard deviation in the normalised plane.
    const double noise =
        samples[i].sigma_force > 0.0 ? std::hypot(std::cos(angle) * force_noise, std::sin(angle) * moment_noise) : unit;
    distances.push_back(fit.residuals[i] * noise);
    if (std::find(fit.outliers.begin(), fit.outliers.end(), i) != fit.outliers.end()) continue;
    for (Eigen::Index k = 0; k < waves; ++k) columns(row, k) = std::cos(2.0 * static_cast<double>(k) * angle) / noise;
    residuals[row++] = fit.residuals[i];
  }
  warn_of_rows_inside(report, distances);
  const auto spare = static_cast<double>(count) - static_cast<double>(waves) - 1.0;
  const auto fitted = static_cast<Eigen::Index>(report.free_parameters);
  if (!(spare > 0.0) || fitted >= waves || report.rms < perfect) return;
  const Eigen::VectorXd trend = columns.colPivHouseholderQr().solve(residuals);
  const double after = (residuals - columns * trend).squaredNorm();
  const auto freedom = static_cast<double>(waves - fitted);
  const double ratio = (residuals.squaredNorm() - after) / freedom / (after / spare);
  const double chance = fisher_chance(freedom, spare, std::max(ratio, 0.0));
  if (!(chance < 0.05)) return;
  // Beyond slips of a narrow range the trend means nothing; no two models differ by more.
  constexpr double most = 0.2;
  const double at_slide = std::clamp(trend.sum(), -most, most);
  const double at_twist = std::clamp(trend[0] - trend[1] + trend[2] - trend[3], -most, most);
  const std::array<double, 2> off_limits{at_slide, at_twist};
  for (std::size_t j = 0; j < report.estimates.size(); ++j) {
    Estimate& estimate = report.estimates[j];
    if (j > 1 && estimate.name != "ratio" && estimate.name != "radius" && estimate.name != "c") continue;
    const double off = j > 1 ? at_twist - at_slide : off_limits.at(j);
    estimate.std_error = std::hypot(estimate.std_error, off * estimate.value);
  }
  if (chance < 0.002) {
    // Where an end of the curve bends within a standard deviation, errors make a trend.
    constexpr double most_curved = 0.4;
    report.warnings.push_back(
        "the samples do not scatter evenly about the curve of " + fit.model + ": " + report.estimates[0].name +
        " may be off by " + format_number(100.0 * std::fabs(at_slide), 3) + " %, " + report.estimates[1].name + " by " +
        format_number(100.0 * std::fabs(at_twist), 3) + " %, which the standard errors include. " +
        (curved > most_curved ? "Force and moment have errors so unequal that the curve bends within one of them"
                              : "Another pressure law, or a wrong zero of the sensor?"));
  }
}

std::string note_of(const std::string& model, const ContactFitOptions& options, std::size_t spare, bool with_sigma) {
  return model + "; gamma " +
         (options.fit_gamma ? std::string("fitted") : "= " + format_number(options.gamma) + " assumed") + "; " +
         to_string(options.loss.kind) + " loss" + (with_sigma ? "" : "; errors proportional to the load assumed") +
         (with_sigma && options.loss.kind == Loss::Kind::squared ? "" : note_of_few_rows(spare));
}

}  // namespace limitcurve::fit::internal
