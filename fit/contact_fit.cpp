// SPDX-License-Identifier: MIT
#include "fit/contact_fit.hpp"

#include "fit/internal/contact_residuals.hpp"
#include "fit/internal/report.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace limitcurve::fit {

namespace {

using internal::ContactLayout;
using internal::ContactResiduals;
using internal::Parameter;
using internal::Solution;
using internal::UnitCurve;
using internal::WeightedSample;

/// Number with three digits, for sentences.
std::string brief(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.3g", value);
  return buffer.data();
}

std::unique_ptr<UnitCurve> make_curve(const ContactModel& model) {
  switch (model.kind) {
    case ContactModel::Kind::ellipse:
      return internal::make_ellipse();
    case ContactModel::Kind::superellipse:
      return internal::make_superellipse();
    case ContactModel::Kind::quartic:
      return internal::make_quartic();
    case ContactModel::Kind::power:
      return internal::make_family(internal::ShapeFamily::power(), "n", 0.5);
    case ContactModel::Kind::xydas_kao:
      return internal::make_family(internal::ShapeFamily::xydas_kao(), "k", 2.0);
    case ContactModel::Kind::law:
      break;
  }
  if (!model.pressure_law) throw std::invalid_argument("model 'law': expected a pressure law, got none");
  return internal::make_law(*model.pressure_law);
}

bool is_exact(const ContactModel& model) {
  return model.kind == ContactModel::Kind::law || model.kind == ContactModel::Kind::power || model.kind == ContactModel::Kind::xydas_kao;
}

/// Whether the samples carry sigmas; throws at the first sample that is not fit to be fitted.
bool check(std::span<const Sample> samples) {
  if (samples.empty()) throw std::invalid_argument("samples: expected at least one, got none");
  const bool with_sigma = samples.front().sigma_force > 0.0 || samples.front().sigma_moment > 0.0;
  double largest_force = 0.0;
  double largest_moment = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const auto complain = [&](const char* name, double value, const char* expected) {
      return std::invalid_argument("sample " + std::to_string(i + 1) + ": " + name + " = " + format_number(value) + ": expected " +
                                   expected);
    };
    if (!(sample.load > 0.0) || std::isinf(sample.load)) throw complain("load", sample.load, "> 0 N and finite");
    if (!std::isfinite(sample.force)) throw complain("force", sample.force, "a finite number of N");
    if (!std::isfinite(sample.moment)) throw complain("moment", sample.moment, "a finite number of N m");
    const auto bad = [&](double sigma) { return with_sigma ? !(sigma > 0.0) || std::isinf(sigma) : sigma != 0.0; };
    const char* const expected = with_sigma ? "> 0 and finite in every sample" : "0 in every sample, as in the first";
    if (bad(sample.sigma_force)) throw complain("sigma_force", sample.sigma_force, expected);
    if (bad(sample.sigma_moment)) throw complain("sigma_moment", sample.sigma_moment, expected);
    largest_force = std::max(largest_force, std::fabs(sample.force));
    largest_moment = std::max(largest_moment, std::fabs(sample.moment));
  }
  if (largest_force == 0.0) throw std::invalid_argument("not identifiable from these samples: mu (every force is 0: no slide at all)");
  if (largest_moment == 0.0) throw std::invalid_argument("not identifiable from these samples: mu_r (every moment is 0: no twist at all)");
  return with_sigma;
}

/// With sigmas, a column that is all noise shows as such: its mean square is 1 to within five standard deviations of that mean.
void check_signal(std::span<const Sample> samples) {
  double force = 0.0;
  double moment = 0.0;
  for (const Sample& sample : samples) {
    force += std::pow(sample.force / sample.sigma_force, 2);
    moment += std::pow(sample.moment / sample.sigma_moment, 2);
  }
  const auto count = static_cast<double>(samples.size());
  const double noise = count + 5.0 * std::sqrt(2.0 * count);
  if (force <= noise)
    throw std::invalid_argument("not identifiable from these samples: mu (every force is within its noise of 0: no slide at all)");
  if (moment <= noise)
    throw std::invalid_argument("not identifiable from these samples: mu_r (every moment is within its noise of 0: no twist at all)");
}

struct Limits {
  double force;   // μ
  double moment;  // μ_r at the reference load
};

/// Starting values: α f² + β m² = 1 in f = F/P, m = M/P is linear in α = μ⁻², β = μ_r⁻². Least absolute deviations (by reweighting),
/// so that mislabelled samples do not matter.
Limits starting_limits(std::span<const Sample> samples) {
  double force_scale = 0.0;
  double moment_scale = 0.0;
  for (const Sample& sample : samples) {
    force_scale = std::max(force_scale, std::fabs(sample.force) / sample.load);
    moment_scale = std::max(moment_scale, std::fabs(sample.moment) / sample.load);
  }
  std::vector<double> weights(samples.size(), 1.0);
  double alpha = 1.0;
  double beta = 1.0;
  for (int pass = 0; pass < 15; ++pass) {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    double x1 = 0.0;
    double y1 = 0.0;
    const auto squares = [&](const Sample& sample) {
      const double f = sample.force / sample.load / force_scale;
      const double m = sample.moment / sample.load / moment_scale;
      return std::pair{f * f, m * m};
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto [x, y] = squares(samples[i]);
      xx += weights[i] * x * x;
      xy += weights[i] * x * y;
      yy += weights[i] * y * y;
      x1 += weights[i] * x;
      y1 += weights[i] * y;
    }
    const double determinant = xx * yy - xy * xy;
    const double next_alpha = (x1 * yy - y1 * xy) / determinant;
    const double next_beta = (y1 * xx - x1 * xy) / determinant;
    // Samples too alike for this: the largest seen will do for a start.
    if (!(next_alpha > 1e-4 && next_beta > 1e-4) || !std::isfinite(next_alpha + next_beta)) break;
    alpha = next_alpha;
    beta = next_beta;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const auto [x, y] = squares(samples[i]);
      weights[i] = 1.0 / std::max(std::fabs(alpha * x + beta * y - 1.0), 1e-6);
    }
  }
  return {force_scale / std::sqrt(alpha), moment_scale / std::sqrt(beta)};
}

std::vector<WeightedSample> weigh(std::span<const Sample> samples, bool with_sigma, Limits limits, double noise, double reference_load) {
  std::vector<WeightedSample> weighted;
  weighted.reserve(samples.size());
  for (const Sample& sample : samples) {
    const double sigma_force = noise * (with_sigma ? sample.sigma_force : limits.force * sample.load);
    const double sigma_moment = noise * (with_sigma ? sample.sigma_moment : limits.moment * sample.load);
    weighted.push_back({std::fabs(sample.force) / sigma_force, std::fabs(sample.moment) / sigma_moment, sample.load / sigma_force,
                        sample.load / sigma_moment, std::log(sample.load / reference_load)});
  }
  return weighted;
}

/// What all candidates share, so that their likelihoods can be compared.
struct Preparation {
  bool with_sigma;
  double reference_load;  // geometric mean: there the moment's limit and its growth are least correlated
  Limits start;
  double noise;  // what a unit of the weighted samples is, in sigmas
  std::vector<WeightedSample> samples;
};

std::vector<Parameter> free_parameters(const UnitCurve& curve, const ContactLayout& layout, const ContactModel& model, Limits start) {
  const bool exact = is_exact(model);
  // The logarithms' bounds are a factor of 1000 to either side of the start.
  constexpr double reach = 7.0;
  const double force = std::log(start.force);
  const double moment = std::log(start.moment);
  std::vector<Parameter> parameters{{exact ? "mu" : "force_max", force, force - reach, force + reach},
                                    {exact ? "mu_r" : "moment_max", moment, moment - reach, moment + reach}};
  if (layout.shape) parameters.push_back({curve.shape_name(), curve.start(), curve.low(), curve.high()});
  if (layout.gamma) parameters.push_back({"gamma", layout.fixed_gamma, -0.5, 1.0});
  return parameters;
}

double median_size(std::vector<double> values) {
  for (double& value : values) value = std::fabs(value);
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Preparation prepare(std::span<const Sample> samples, const ContactFitOptions& options) {
  Preparation preparation{check(samples), 0.0, {}, 1.0, {}};
  if (preparation.with_sigma) check_signal(samples);
  double log_load = 0.0;
  for (const Sample& sample : samples) log_load += std::log(sample.load);
  preparation.reference_load = std::exp(log_load / static_cast<double>(samples.size()));
  preparation.start = starting_limits(samples);
  const ContactModel ellipse{};
  const std::unique_ptr<UnitCurve> curve = make_curve(ellipse);
  const ContactLayout layout{false, options.fit_gamma, options.gamma};
  // Without sigmas the unit of error is the limit itself, which an ellipse tells well enough; a robust loss also needs to
  // know what a usual error is: 1.4826 median |residual| estimates σ and does not see outliers.
  const bool robust = options.loss.kind != Loss::Kind::squared;
  const int passes = preparation.with_sigma ? 0 : robust ? 2 : 1;
  for (int pass = 0; pass < passes; ++pass) {
    const auto weighted = weigh(samples, false, preparation.start, preparation.noise, preparation.reference_load);
    const ContactResiduals residuals(weighted, *curve, layout);
    const std::vector<Parameter> parameters = free_parameters(*curve, layout, ellipse, preparation.start);
    const Loss loss = pass == 0 && robust ? Loss::cauchy(0.05) : options.loss;
    const Solution solution = internal::minimise(residuals, parameters, loss, internal::coarse_tolerance);
    preparation.start = {std::exp(solution.values[0]), std::exp(solution.values[1])};
    if (robust) {
      preparation.noise *= std::max(1.4826 * median_size(solution.residuals), 1e-9);
    }
  }
  preparation.samples = weigh(samples, preparation.with_sigma, preparation.start, preparation.noise, preparation.reference_load);
  return preparation;
}

void warn(FitReport& report, const UnitCurve& curve, const ContactModel& model, const ContactFitOptions& options) {
  if (!report.converged) report.warnings.push_back("the minimiser did not converge: " + report.message);
  if (is_exact(model)) {
    const Estimate& radius = report.at(options.gamma != 0.0 || options.fit_gamma ? "c" : "radius");
    if (radius.name == "radius" && radius.value > options.largest_radius) {
      report.warnings.push_back("the law implies a contact radius of " + brief(1e3 * radius.value) + " mm, more than the finger's " +
                                brief(1e3 * options.largest_radius) + " mm: keep mu_r as measured, independent of radius and law");
    }
  }
  const std::string shape = curve.shape_name();
  if (!shape.empty()) {
    for (const Estimate& other : report.estimates) {
      if (other.name == shape) continue;
      const double correlation = report.correlation_of(shape, other.name);
      if (std::fabs(correlation) > 0.9) {
        report.warnings.push_back(shape + " and " + other.name + " trade off: correlation " + brief(correlation));
      }
    }
  }
}

/// What the residuals, in standard deviations as told or found, say against the fit.
void warn_of_scatter(FitReport& report, const Solution& solution, const Loss& loss, bool with_sigma) {
  const auto count = static_cast<double>(solution.residuals.size());
  if (loss.kind != Loss::Kind::squared) {
    constexpr double gross = 5.0;
    const auto outliers =
        std::count_if(solution.residuals.begin(), solution.residuals.end(), [](double r) { return std::fabs(r) > gross; });
    if (outliers > 0) {
      report.warnings.push_back(std::to_string(outliers) + " of " + std::to_string(solution.residuals.size()) +
                                " samples are more than 5 standard deviations off: mislabelled?");
    }
  }
  if (!with_sigma || report.residuals <= report.free_parameters) return;
  const double scatter =
      loss.kind != Loss::Kind::squared ? 1.4826 * median_size(solution.residuals) : std::sqrt(internal::residual_variance(solution));
  if (scatter > 1.0 + 3.0 / std::sqrt(count)) {
    report.warnings.push_back("the scatter is " + brief(scatter) +
                              " times what the sigmas say: outliers, the wrong model, or sigmas that are too small");
  }
}

/// The fitted curve and its band: with q the curve's point in the normalised plane and N its normal, the standard error of q·N is that of
/// N·(x δlog μ, y δlog μ_r) + N·∂q/∂β δβ (at 1 N: δlog μ_r is that of the limit there).
std::vector<ContactFit::BandPoint> band_of(const UnitCurve& curve, const ContactLayout& layout, std::span<const double> covariance,
                                           double mu, double mu_r, double log_reference) {
  constexpr int points = 91;
  constexpr double two_sided_95 = 1.959964;
  const std::size_t free = layout.size();
  std::vector<ContactFit::BandPoint> band;
  for (int i = 0; i < points; ++i) {
    const double t = static_cast<double>(i) / (points - 1);
    const auto [point, tangent] = curve.at(t);
    const double length = std::hypot(tangent.x, tangent.y);
    const internal::PlanePoint normal{tangent.y / length, -tangent.x / length};
    std::array<double, 4> gradient{normal.x * point.x, normal.y * point.y, 0.0, 0.0};
    if (layout.shape) {
      const internal::PlanePoint slope = curve.shape_slope(t);
      gradient[2] = normal.x * slope.x + normal.y * slope.y;
    }
    if (layout.gamma) gradient[layout.gamma_place()] = -gradient[1] * log_reference;
    double variance = 0.0;
    for (std::size_t a = 0; a < free; ++a) {
      for (std::size_t b = 0; b < free; ++b) variance += gradient[a] * covariance[a * free + b] * gradient[b];
    }
    const double width = two_sided_95 * std::sqrt(std::max(variance, 0.0));
    band.push_back({mu * point.x, mu_r * point.y, mu * (point.x - width * normal.x), mu_r * (point.y - width * normal.y),
                    mu * (point.x + width * normal.x), mu_r * (point.y + width * normal.y)});
  }
  return band;
}

ContactFit fit_prepared(const Preparation& preparation, const ContactModel& model, const ContactFitOptions& options) {
  const std::unique_ptr<UnitCurve> curve = make_curve(model);
  const ContactLayout layout{!curve->shape_name().empty(), options.fit_gamma, options.gamma};
  std::vector<Parameter> parameters = free_parameters(*curve, layout, model, preparation.start);
  const std::size_t free = layout.size();
  const std::size_t count = preparation.samples.size();
  if (count < free || (!preparation.with_sigma && count == free)) {
    std::string names;
    for (const Parameter& parameter : parameters) names += (names.empty() ? "" : ", ") + parameter.name;
    throw std::invalid_argument("not identifiable from " + std::to_string(count) + (count == 1 ? " sample: " : " samples: ") + names);
  }
  const bool robust = options.loss.kind != Loss::Kind::squared;
  ContactResiduals residuals(preparation.samples, *curve, layout);
  Solution solution = internal::minimise(residuals, parameters, options.loss, internal::coarse_tolerance);
  // Again from there, with the drift that the scatter found causes (sigmas may overstate it).
  const double scatter = robust ? std::pow(1.4826 * median_size(solution.residuals), 2) : internal::residual_variance(solution);
  residuals.expect_drift(solution.values, preparation.with_sigma ? std::min(scatter, 1.0) : scatter);
  for (std::size_t j = 0; j < free; ++j) parameters[j].start = solution.values[j];
  const int iterations = solution.iterations;
  solution = internal::minimise(residuals, parameters, options.loss);
  solution.iterations += iterations;
  const double variance = preparation.with_sigma ? 1.0 : internal::residual_variance(solution);
  std::vector<double> covariance = internal::covariance(solution, parameters, options.loss, variance);
  for (std::size_t j = 0; j < 2; ++j) {
    const double relative_error = std::sqrt(covariance[j * free + j]);
    if (!(relative_error < 0.5)) {
      throw std::invalid_argument("not identifiable from these samples: " + parameters[j].name + " (its standard error is " +
                                  brief(100.0 * relative_error) + " %)");
    }
  }

  ContactFit fit{model.name(), {}, solution.residuals, {}};
  if (!preparation.with_sigma && !robust && variance > 0.0) {
    for (double& residual : fit.residuals) residual /= std::sqrt(variance);
  }
  internal::describe(fit.report, solution);
  fit.report.rms *= preparation.noise;
  fit.report.aic = internal::akaike(solution.cost, count, free, preparation.with_sigma || robust);

  // From the logarithms at the reference load to the quantities themselves, at 1 N where the radius depends on the load.
  const double shape = layout.shape ? solution.values[2] : 0.0;
  curve->bend(shape);
  const double gamma = layout.gamma ? solution.values[layout.gamma_place()] : options.gamma;
  const double log_reference = std::log(preparation.reference_load);
  const bool grows = options.fit_gamma || options.gamma != 0.0;
  const std::string metre = grows ? "m/N^gamma" : "m";
  const double mu = std::exp(solution.values[0]);
  const double mu_r = std::exp(solution.values[1] - gamma * log_reference);
  std::vector<internal::Quantity> quantities;
  std::vector<double> jacobian;
  const auto add = [&](std::string name, double value, std::string unit, double by_mu, double by_mu_r, double by_shape, double by_gamma) {
    quantities.push_back({std::move(name), value, std::move(unit)});
    jacobian.insert(jacobian.end(), {by_mu, by_mu_r});
    if (layout.shape) jacobian.push_back(by_shape);
    if (layout.gamma) jacobian.push_back(by_gamma);
  };
  add(parameters[0].name, mu, "1", mu, 0.0, 0.0, 0.0);
  add(parameters[1].name, mu_r, metre, 0.0, mu_r, 0.0, -mu_r * log_reference);
  if (is_exact(model)) {
    const double ratio = mu_r / mu;
    add("ratio", ratio, metre, -ratio, ratio, 0.0, -ratio * log_reference);
    const double radius = ratio / curve->moment_ratio();
    add(grows ? "c" : "radius", radius, metre, -radius, radius, -radius * curve->moment_ratio_slope() / curve->moment_ratio(),
        -radius * log_reference);
  }
  if (layout.shape) add(curve->shape_name(), curve->parameter(shape), "1", 0.0, 0.0, curve->parameter_slope(shape), 0.0);
  if (layout.gamma) add("gamma", gamma, "1", 0.0, 0.0, 0.0, 1.0);
  internal::set_estimates(fit.report, quantities, jacobian, covariance);
  fit.band = band_of(*curve, layout, covariance, mu, mu_r, log_reference);
  warn(fit.report, *curve, model, options);
  warn_of_scatter(fit.report, solution, options.loss, preparation.with_sigma);

  if (layout.shape) {
    const double range = curve->high() - curve->low();
    const double error = std::sqrt(covariance[2 * free + 2]);
    const bool at_bound = std::min(shape - curve->low(), curve->high() - shape) < 1e-6 * range;
    if (at_bound || error > 0.5 * range) {
      // An honest blank is better than a number: neither the shape nor what depends on it is known.
      constexpr double infinity = std::numeric_limits<double>::infinity();
      for (Estimate& estimate : fit.report.estimates) {
        if (estimate.name != curve->shape_name() && estimate.name != "radius" && estimate.name != "c") continue;
        if (!at_bound) estimate.value = std::numeric_limits<double>::quiet_NaN();
        estimate.std_error = infinity;
      }
      fit.report.warnings.push_back(at_bound ? curve->shape_name() + " is at the end of its range, " + brief(curve->parameter(shape)) +
                                                   ": the data ask for more than the family has, or say nothing of it"
                                             : curve->shape_name() +
                                                   " is not identifiable from these samples: any value in its range explains them");
    }
  }
  return fit;
}

}  // namespace

std::string ContactModel::name() const {
  switch (kind) {
    case Kind::ellipse:
      return "ellipse";
    case Kind::superellipse:
      return "superellipse";
    case Kind::quartic:
      return "quartic";
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
  return fit_prepared(prepare(samples, options), model, options);
}

LawSelection select_law(std::span<const Sample> samples, const ContactFitOptions& options) {
  const Preparation preparation = prepare(samples, options);
  LawSelection selection;
  const std::array<ContactModel, 8> models{ContactModel::of(flat_punch()),
                                           ContactModel::of(uniform()),
                                           ContactModel::of(hertz()),
                                           ContactModel::of(parabolic()),
                                           ContactModel::of(cone()),
                                           ContactModel::of(gaussian(1.0)),
                                           ContactModel{ContactModel::Kind::power},
                                           ContactModel{ContactModel::Kind::xydas_kao}};
  for (const ContactModel& model : models) selection.candidates.push_back(fit_prepared(preparation, model, options));
  std::stable_sort(selection.candidates.begin(), selection.candidates.end(),
                   [](const ContactFit& a, const ContactFit& b) { return a.report.aic < b.report.aic; });
  ContactFit& best = selection.candidates.front();
  std::string rivals;
  for (const ContactFit& candidate : selection.candidates) {
    const double difference = candidate.report.aic - best.report.aic;
    selection.aic_difference.push_back(difference);
    if (&candidate != &best && difference < 2.0) {
      rivals += (rivals.empty() ? "" : ", ") + candidate.model + " (AICc difference " + brief(difference) + ")";
    }
  }
  if (!rivals.empty()) best.report.warnings.push_back("the data cannot tell " + best.model + " from " + rivals);
  return selection;
}

Estimate implied_radius(const Estimate& ratio, const PressureLaw& law) {
  const double moment_ratio = law.moment_ratio();
  return {"radius", ratio.value / moment_ratio, ratio.std_error / moment_ratio, ratio.unit};
}

}  // namespace limitcurve::fit
