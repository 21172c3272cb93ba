// SPDX-License-Identifier: MIT
#include "fit/contact_fit.hpp"

#include "fit/internal/contact_assumptions.hpp"
#include "fit/internal/contact_preparation.hpp"
#include "fit/internal/edge.hpp"
#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::fit {

using namespace internal;

namespace {

void warn(FitReport& report, const UnitCurve& curve) {
  if (!report.converged) report.warnings.push_back("the minimiser did not converge: " + report.message);
  const std::string shape = curve.shape_name();
  if (!shape.empty()) {
    for (const Estimate& other : report.estimates) {
      if (other.name == shape) continue;
      const double correlation = report.correlation_of(shape, other.name);
      if (std::fabs(correlation) > 0.9) {
        report.warnings.push_back(shape + " and " + other.name + " trade off: correlation " +
                                  format_number(correlation, 3));
      }
    }
  }
}

/// Throws if the samples are all about one centre of rotation, for all their noise says: then they give a single point
/// of the curve, and a spread along it that is noise would be taken for that of slips.
void refuse_one_centre(const ContactResiduals::Ray& ray, const Solution& solution, double noise, bool with_sigma,
                       bool robust) {
  const auto count = static_cast<double>(ray.distances.size());
  const double size = robust ? 1.4826 * median_size(ray.distances) : root_mean_square(ray.distances);
  const double unknown =
      1.0 / (count - 1.0) + (with_sigma ? 0.0 : 1.0 / (count - static_cast<double>(solution.values.size())));
  // Without sigmas the limits, which such samples do not tell, are the unit of both errors: noise may seem unequal, but
  // not correlated.
  const bool spreads = with_sigma || ray.correlation * std::sqrt(count - 1.0) < -3.0;
  const double least = spreads ? std::max(2.0, 1.0 + 3.0 * std::sqrt(2.0 * unknown)) : 10.0;
  if (!(size * size < least * noise)) return;
  // A robust size is that of most rows. The others are no gross errors if more of them lie on the curve than its free
  // parameters can lead it through.
  const double far = 3.0 * std::max(1.0, std::sqrt(noise));
  std::size_t beside = 0;
  for (std::size_t i = 0; robust && i < ray.distances.size(); ++i)
    beside += std::fabs(ray.distances[i]) > far && std::fabs(solution.residuals[i]) < far ? 1 : 0;
  if (beside >= solution.values.size()) return;
  throw std::invalid_argument(
      "not identifiable from these samples: mu, mu_r (they are no set of slips). If the finger held in some of them "
      "(rest, loading, letting go), leave those out or use --loss edge; if all are slips, they turn about one centre "
      "of "
      "rotation and give one point of the curve, moment/force = " +
      format_number(ray.ratio, 4) + " +- " + format_number(ray.ratio * ray.relative_error * std::sqrt(noise), 2) +
      " m: add slips about others");
}

/// The fitted curve and its band: with q the curve's point in the normalised plane and N its normal, the standard error
/// of q·N is that of N·(x δlog μ, y δlog μ_r) + N·∂q/∂β δβ (at 1 N: δlog μ_r is that of the limit there).
std::vector<ContactFit::BandPoint> band_of(const UnitCurve& curve, const ContactLayout& layout,
                                           std::span<const double> covariance, double mu, double mu_r,
                                           double log_reference) {
  constexpr int points = 91;
  constexpr double two_sided_95 = 1.959964;
  const std::size_t free = layout.size();
  std::vector<ContactFit::BandPoint> band;
  for (int i = 0; i < points; ++i) {
    const double t = static_cast<double>(i) / (points - 1);
    const auto [point, tangent] = curve.at(t);
    const double length = std::hypot(tangent.x, tangent.y);
    const PlanePoint normal{tangent.y / length, -tangent.x / length};
    std::array<double, 4> gradient{normal.x * point.x, normal.y * point.y, 0.0, 0.0};
    if (layout.shape) {
      const PlanePoint slope = curve.shape_slope(t);
      gradient[2] = normal.x * slope.x + normal.y * slope.y;
    }
    if (layout.gamma) gradient[layout.gamma_place()] = -gradient[1] * log_reference;
    double variance = 0.0;
    for (std::size_t a = 0; a < free; ++a) {
      for (std::size_t b = 0; b < free; ++b) variance += gradient[a] * covariance[a * free + b] * gradient[b];
    }
    const double width = two_sided_95 * std::sqrt(std::max(variance, 0.0));
    band.push_back({mu * point.x, mu_r * point.y, mu * (point.x - width * normal.x),
                    mu_r * (point.y - width * normal.y), mu * (point.x + width * normal.x),
                    mu_r * (point.y + width * normal.y)});
  }
  return band;
}

bool is_at_bound(const UnitCurve& curve, double shape) {
  return std::min(shape - curve.low(), curve.high() - shape) < 1e-6 * (curve.high() - curve.low());
}

}  // namespace

void internal::report_limits(ContactFit& fit, UnitCurve& curve, const ContactLayout& layout, const ContactModel& model,
                             std::span<const double> values, std::span<const double> covariance, double reference_load,
                             double largest_radius) {
  const double shape = layout.shape ? values[2] : 0.0;
  curve.bend(shape);
  const double gamma = layout.gamma ? values[layout.gamma_place()] : layout.fixed_gamma;
  const double log_reference = std::log(reference_load);
  const bool grows = layout.gamma || layout.fixed_gamma != 0.0;
  const std::string metre = grows ? "m/N^gamma" : "m";
  const double mu = std::exp(values[0]);
  const double mu_r = std::exp(values[1] - gamma * log_reference);
  std::vector<Quantity> quantities;
  std::vector<double> jacobian;
  using Role = Estimate::Role;
  const auto add = [&](Role role, std::string name, double value, std::string unit, std::array<double, 4> slopes) {
    quantities.push_back({std::move(name), value, std::move(unit), role});
    jacobian.insert(jacobian.end(), {slopes[0], slopes[1]});
    if (layout.shape) jacobian.push_back(slopes[2]);
    if (layout.gamma) jacobian.push_back(slopes[3]);
  };
  add(Role::force, is_exact(model) ? "mu" : "force_max", mu, "1", {mu, 0.0, 0.0, 0.0});
  add(Role::moment, is_exact(model) ? "mu_r" : "moment_max", mu_r, metre, {0.0, mu_r, 0.0, -mu_r * log_reference});
  if (is_exact(model)) {
    const double ratio = mu_r / mu;
    add(Role::ratio, "ratio", ratio, metre, {-ratio, ratio, 0.0, -ratio * log_reference});
    const double radius = ratio / curve.moment_ratio();
    add(Role::radius, grows ? "c" : "radius", radius, metre,
        {-radius, radius, -radius * curve.moment_ratio_slope() / curve.moment_ratio(), -radius * log_reference});
    if (!grows && radius > largest_radius) {
      fit.report.warnings.push_back("the law implies a contact radius of " + format_number(1e3 * radius, 3) +
                                    " mm, more than the finger's " + format_number(1e3 * largest_radius, 3) +
                                    " mm: keep mu_r as measured, independent of radius and law");
    }
  }
  if (layout.shape)
    add(Role::shape, curve.shape_name(), curve.parameter(shape), "1", {0.0, 0.0, curve.parameter_slope(shape), 0.0});
  if (layout.gamma) add(Role::gamma, "gamma", gamma, "1", {0.0, 0.0, 0.0, 1.0});
  internal::set_estimates(fit.report, quantities, jacobian, covariance);
  fit.band = band_of(curve, layout, covariance, mu, mu_r, log_reference);
}

ContactFit internal::fit_prepared(const ContactPreparation& preparation, const ContactModel& model,
                                  const ContactFitOptions& options) {
  const std::unique_ptr<UnitCurve> curve = make_curve(model);
  const ContactLayout layout{!curve->shape_name().empty(), options.fit_gamma, options.gamma};
  std::vector<Parameter> parameters = internal::free_parameters(*curve, layout, model, preparation.start);
  const std::size_t free = layout.size();
  const std::size_t count = preparation.samples.size();
  if (count < free || (!preparation.with_sigma && count == free)) {
    std::string names;
    for (const Parameter& parameter : parameters) names += (names.empty() ? "" : ", ") + parameter.name;
    throw too_few_samples(count, free, names, "sigma_force and sigma_moment");
  }
  const bool robust = options.loss.kind != Loss::Kind::squared;
  // To 3 % of a standard error for 100 samples: enough for a first pass.
  constexpr double first_tolerance = 1e-5;
  ContactResiduals residuals(preparation.samples, *curve, layout);
  const Loss loss = robust ? approach(residuals, parameters, options.loss) : options.loss;
  Solution solution = minimise(residuals, parameters, loss, first_tolerance);
  // Second pass, with the drift from the estimated scatter (the sigmas may overstate it).
  const double scatter = robust ? std::pow(1.4826 * median_size(solution.residuals), 2) : residual_variance(solution);
  const double noise = preparation.with_sigma ? std::min(scatter, 1.0) : scatter;
  residuals.expect_drift(solution.values, noise);
  for (std::size_t j = 0; j < free; ++j) parameters[j].start = solution.values[j];
  const int iterations = solution.iterations;
  solution = minimise(residuals, parameters, loss);
  solution.iterations += iterations;
  const double variance = preparation.with_sigma ? 1.0 : robust ? 0.0 : residual_variance(solution);
  // A row without force and moment is about no centre, and its distance from the curve would pass for noise.
  double squares = 0.0;
  std::size_t slips = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (preparation.samples[i].force == 0.0 && preparation.samples[i].moment == 0.0) continue;
    squares += solution.residuals[i] * solution.residuals[i];
    ++slips;
  }
  const double of_slips =
      robust || slips <= free ? noise : std::min(noise, squares / static_cast<double>(slips - free));
  refuse_one_centre(residuals.common_ray(solution.values), solution, of_slips, preparation.with_sigma, robust);
  const std::vector<double> covariance = internal::covariance(solution, parameters, loss, variance);
  for (std::size_t j = 0; j < 2; ++j) {
    const double relative_error = std::sqrt(covariance[j * free + j]);
    if (!(relative_error < 0.5)) {
      throw std::invalid_argument("not identifiable from these samples: " + parameters[j].name +
                                  " (its standard error is " + format_number(100.0 * relative_error, 3) +
                                  " %); if the finger held in some rows, use --loss edge");
    }
  }
  if (layout.gamma) refuse_hidden(parameters.back(), covariance.back());

  ContactFit fit{model.name(), {}, solution.residuals, {}, {}};
  if (!preparation.with_sigma && !robust && variance > 0.0) {
    for (double& residual : fit.residuals) residual /= std::sqrt(variance);
  }
  describe(fit.report, solution);
  fit.report.note = internal::note_of(fit.model, options, count - free, preparation.with_sigma);
  fit.report.rms *= preparation.noise;
  fit.report.aic = akaike(cost_of(solution, options.loss), count, free, preparation.with_sigma || robust);

  bool at_bound = false;
  bool hidden = false;
  if (layout.shape) {
    const double range = curve->high() - curve->low();
    at_bound = is_at_bound(*curve, solution.values[2]);
    hidden = std::sqrt(covariance[2 * free + 2]) > 0.5 * range;
  }
  report_limits(fit, *curve, layout, model, solution.values, covariance, preparation.reference_load,
                options.largest_radius);
  const double shape = layout.shape ? solution.values[2] : 0.0;
  const double gamma = layout.gamma ? solution.values[layout.gamma_place()] : options.gamma;
  warn(fit.report, *curve);
  if (layout.gamma) warn_of_end(fit.report, parameters.back(), gamma);
  warn_of_scatter(fit.report, solution, options.loss, preparation.with_sigma);

  if (at_bound || hidden) {
    // Report nothing rather than a wrong number: the data determine neither the shape nor the quantities that depend on
    // it.
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (Estimate& estimate : fit.report.estimates) {
      if (estimate.role != Estimate::Role::shape && estimate.role != Estimate::Role::radius) continue;
      if (!at_bound) estimate.value = std::numeric_limits<double>::quiet_NaN();
      estimate.std_error = infinity;
    }
    fit.report.warnings.push_back(
        at_bound
            ? curve->shape_name() + " is at the end of its range, " + format_number(curve->parameter(shape), 3) +
                  ": the data ask for more than the family has, or say nothing of it"
            : curve->shape_name() + " is not identifiable from these samples: any value in its range explains them");
  }
  return fit;
}

std::string ContactModel::name() const {
  switch (kind) {
    case Kind::ellipse:
      return "ellipse";
    case Kind::power:
      return "power";
    case Kind::xydas_kao:
      return "xydas-kao";
    case Kind::law:
      break;
  }
  return pressure_law ? pressure_law->name() : "law";
}

ContactFit fit_contact(std::span<const Sample> samples, const ContactModel& model, const ContactFitOptions& options) {
  if (options.loss.kind == Loss::Kind::edge) return fit_edge(samples, model, options);
  return fit_or_outlive_outliers(options, [&](const ContactFitOptions& with) {
    return fit_beside_holds(samples, with, [&](std::span<const Sample> some) {
      const ContactPreparation preparation = internal::prepare(some, with);
      ContactFit fit = internal::fit_prepared(preparation, model, with);
      internal::check_assumptions(fit, some, model, with);
      test_scatter(fit, some, preparation, with);
      return fit;
    });
  });
}

Estimate implied_radius(const Estimate& ratio, const PressureLaw& law) {
  const double moment_ratio = law.moment_ratio();
  return {"radius", ratio.value / moment_ratio, ratio.std_error / moment_ratio, ratio.unit, Estimate::Role::radius};
}

}  // namespace limitcurve::fit
