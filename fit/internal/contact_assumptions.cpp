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
      const std::vector<double> spread = covariance(solution, parameters, loss, preparation.with_sigma ? 1.0 : 0.0);
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
  warn_of_outliers(fit.report, names_of(samples, fit.outliers), options.loss);
  if (!options.fit_gamma) warn_of_growth(fit.report, options.gamma, gamma, spare, rms);
}

void test_scatter(ContactFit& fit, std::span<const Sample> samples, const ContactPreparation& preparation,
                  const ContactFitOptions& options) {
  constexpr Eigen::Index waves = 4;
  FitReport& report = fit.report;
  double gamma = options.gamma;
  const double mu = report.estimates[0].value;
  const double mu_r = report.estimates[1].value;
  if (const Estimate* const fitted = report.find(Estimate::Role::gamma)) gamma = fitted->value;
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
  using Role = Estimate::Role;
  std::vector<double> offs;
  for (const Estimate& estimate : report.estimates) {
    const bool is_ratio = estimate.role == Role::ratio || estimate.role == Role::radius;
    const double off = offs.empty() ? at_slide : offs.size() == 1 ? at_twist : is_ratio ? at_twist - at_slide : 0.0;
    offs.push_back(std::isfinite(estimate.std_error) ? off * estimate.value : 0.0);
  }
  add_error(report, offs);
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

namespace {

/// How far each sample is from the curve of a fit, in standard deviations along its ray, and the ray.
struct Placed {
  double distance;
  double angle;  ///< polar, in the normalised plane
};
std::vector<Placed> place(std::span<const Sample> samples, const ContactFit& fit, double gamma) {
  if (const Estimate* const fitted = fit.report.find(Estimate::Role::gamma)) gamma = fitted->value;
  const double mu = fit.report.estimates[0].value;
  const double mu_r = fit.report.estimates[1].value;
  // Of residuals in the typical error.
  const double unit = fit.report.rms / std::max(root_mean_square(fit.residuals), 1e-300);
  std::vector<Placed> placed;
  for (const Sample& sample : samples) {
    const double force = std::fabs(sample.force) / (mu * sample.load);
    const double moment = std::fabs(sample.moment) / (mu_r * std::pow(sample.load, 1.0 + gamma));
    const double angle = std::atan2(moment, force);
    // The band's points are those of the curve, from slide to twist.
    const auto beyond = std::partition_point(fit.band.begin() + 1, fit.band.end() - 1, [&](const auto& point) {
      return point.moment / mu_r * std::cos(angle) < point.force / mu * std::sin(angle);
    });
    const auto& low = *(beyond - 1);
    const double normal_x = (beyond->moment - low.moment) / mu_r;
    const double normal_y = (low.force - beyond->force) / mu;
    const double size =
        (force * normal_x + moment * normal_y) / (low.force / mu * normal_x + low.moment / mu_r * normal_y);
    const double noise =
        sample.sigma_force > 0.0
            ? std::hypot(std::cos(angle) * sample.sigma_force / (mu * sample.load),
                         std::sin(angle) * sample.sigma_moment / (mu_r * std::pow(sample.load, 1.0 + gamma)))
            : unit;
    placed.push_back({(size - 1.0) / std::max(noise, perfect), angle});
  }
  return placed;
}

double scatter_of(std::span<const double> residuals) {
  return std::max(1.0, 1.4826 * median_size({residuals.begin(), residuals.end()}));
}

/// In how many of twelve directions of slip two rows or more are within three standard deviations of the curve.
std::size_t directions(const std::vector<Placed>& placed, double scatter) {
  std::array<std::size_t, 12> rows{};
  for (const Placed& one : placed) {
    if (std::fabs(one.distance) < 3.0 * scatter)
      ++rows.at(std::min<std::size_t>(static_cast<std::size_t>(one.angle * 7.64), 11));
  }
  return static_cast<std::size_t>(std::ranges::count_if(rows, [](std::size_t count) { return count >= 2; }));
}

}  // namespace

std::vector<std::size_t> rows_held(std::span<const Sample> samples, const ContactFit& fit, double gamma,
                                   const std::function<ContactFit(std::span<const Sample>)>& refit) {
  constexpr double far = 4.0;
  constexpr double many = 0.03;
  std::vector<Placed> placed = place(samples, fit, gamma);
  double scatter = scatter_of(fit.residuals);
  const std::size_t before = directions(placed, scatter);
  const auto inside_of = [&](double bound) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (placed[i].distance < bound * scatter) places.push_back(i);
    }
    return places;
  };
  const auto outside = [&] { return static_cast<double>(samples.size() - inside_of(far).size()); };
  const double most = many * static_cast<double>(samples.size());
  if (!(outside() > most)) return {};
  // Begins with the outermost rows, and takes in what lies on their curve.
  std::vector<std::size_t> held = inside_of(far);
  constexpr int most_passes = 10;
  for (int pass = 0; pass < most_passes; ++pass) {
    try {
      const ContactFit outermost = refit(without(samples, held));
      placed = place(samples, outermost, gamma);
      scatter = scatter_of(outermost.residuals);
    } catch (const std::invalid_argument&) {
      return {};
    }
    const std::vector<std::size_t> inside = inside_of(-far);
    if (inside == held) break;
    held = inside;
  }
  if (outside() > most || directions(placed, scatter) <= before) return {};
  return held;
}

std::vector<Sample> without(std::span<const Sample> samples, const std::vector<std::size_t>& places) {
  std::vector<Sample> others;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (std::ranges::binary_search(places, i)) continue;
    others.push_back(samples[i]);
    if (samples[i].row == 0) others.back().row = i + 1;
  }
  return others;
}

void include_held(ContactFit& fit, std::span<const Sample> samples, double gamma,
                  const std::vector<std::size_t>& held) {
  const std::vector<Placed> placed = place(samples, fit, gamma);
  std::vector<double> residuals;
  std::vector<std::size_t> outliers;
  std::size_t other = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool is_held = std::ranges::binary_search(held, i);
    if (is_held || std::ranges::binary_search(fit.outliers, other)) outliers.push_back(i);
    residuals.push_back(is_held ? placed[i].distance : fit.residuals[other++]);
  }
  fit.residuals = std::move(residuals);
  fit.outliers = std::move(outliers);
  fit.report.warnings.push_back(listed("row", "rows", names_of(samples, held)) +
                                " (the first is 1): left out, for the finger held: by a curve through them the other "
                                "rows would lie outside, where nothing can be");
}

std::string note_of(const std::string& model, const ContactFitOptions& options, std::size_t spare, bool with_sigma) {
  return model + "; gamma " +
         (options.fit_gamma ? std::string("fitted") : "= " + format_number(options.gamma) + " assumed") + "; " +
         to_string(options.loss.kind) + " loss" + (with_sigma ? "" : "; errors proportional to the load assumed") +
         (with_sigma ? "" : note_of_few_rows(spare));
}

}  // namespace limitcurve::fit::internal
