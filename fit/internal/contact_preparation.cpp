// SPDX-License-Identifier: MIT
#include "fit/internal/contact_preparation.hpp"

#include "limitcurve/number.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve::fit::internal {

namespace {

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

}  // namespace

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

ContactPreparation prepare(std::span<const Sample> samples, const ContactFitOptions& options) {
  if (!(options.gamma >= -0.5 && options.gamma <= 1.0)) throw out_of_range("gamma", options.gamma, "1", "-0.5 <= gamma <= 1");
  if (!(options.loss.scale > 0.0) || std::isinf(options.loss.scale))
    throw out_of_range("loss scale", options.loss.scale, "1", "> 0 and finite");
  ContactPreparation preparation{check(samples), 0.0, {}, 1.0, {}};
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

}  // namespace limitcurve::fit::internal
