// SPDX-License-Identifier: MIT
#include "fit/internal/contact_preparation.hpp"

#include "fit/internal/report.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <stdexcept>

namespace limitcurve::fit::internal {

namespace {

/// Whether the samples have sigmas; throws at the first bad sample.
bool check(std::span<const Sample> samples) {
  if (samples.empty()) throw std::invalid_argument("samples: expected at least one, got none");
  const bool with_sigma = samples.front().sigma_force > 0.0 || samples.front().sigma_moment > 0.0;
  double largest_force = 0.0;
  double largest_moment = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const auto complain = [&](const char* name, double value, const char* expected) {
      return bad_sample(i, name, value, expected);
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
  if (largest_force == 0.0)
    throw std::invalid_argument(
        "not identifiable from these samples: mu, because every force is 0; add slips that slide");
  if (largest_moment == 0.0)
    throw std::invalid_argument(
        "not identifiable from these samples: mu_r, because every moment is 0; add slips that twist");
  return with_sigma;
}

/// Whether a column with sigmas is all noise: its mean square is 1 to within five standard deviations of that mean.
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
    throw std::invalid_argument(
        "not identifiable from these samples: mu, because every force is within its noise of 0; add slips that slide");
  if (moment <= noise)
    throw std::invalid_argument(
        "not identifiable from these samples: mu_r, because every moment is within its noise of 0; add slips that "
        "twist");
}

/// Starting values for a robust loss, which gross errors in up to about half of the samples do not move: of the
/// ellipses α f² + β m² = 1 through two samples each, with f = F/P and m = M/P at the reference load, the one with the
/// least Σ e²/(e² + 0.1²), e = (q − 1)/(q + 1), q = αf² + βm². Near the ellipse e is the relative distance; a distant
/// sample has the same weight inside and outside. One sample of a pair is from the half nearer to sliding, one from the
/// half nearer to twisting, 12 of each: at most 144 pairs.
Limits starting_limits(std::span<const Sample> samples, double gamma, double reference_load) {
  struct Place {
    double angle;
    double force;
    double moment;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> places;
  Limits best{0.0, 0.0};
  for (const Sample& sample : samples) {
    const double force = std::fabs(sample.force) / sample.load;
    const double moment = std::fabs(sample.moment) / sample.load * std::pow(sample.load / reference_load, -gamma);
    places.push_back({std::atan2(moment, force), force, moment});
    // The samples are too similar for a pair: start from the largest values.
    best = {std::max(best.force, force), std::max(best.moment, moment)};
  }
  // The pairs do not depend on the order of the rows.
  std::sort(places.begin(), places.end());
  constexpr std::size_t most = 12;
  const std::size_t middle = (places.size() + 1) / 2;
  const auto pick = [](std::size_t i, std::size_t from, std::size_t to) {
    const std::size_t count = to - from;
    return count <= most ? from + i : from + (2 * i + 1) * count / (2 * most);
  };
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(middle, most); ++i) {
    for (std::size_t j = 0; j < std::min(places.size() - middle, most); ++j) {
      const Place& slide = places[pick(i, 0, middle)];
      const Place& twist = places[pick(j, middle, places.size())];
      // In units of the two samples' larger components, so that units do not matter.
      const double x = slide.force > 0.0 ? twist.force / slide.force : 0.0;
      const double y = twist.moment > 0.0 ? slide.moment / twist.moment : 0.0;
      const double determinant = 1.0 - x * x * y * y;
      const double alpha = (1.0 - y * y) / determinant;
      const double beta = (1.0 - x * x) / determinant;
      if (!(slide.force > 0.0 && twist.moment > 0.0 && alpha > 1e-4 && beta > 1e-4 && std::isfinite(alpha + beta)))
        continue;
      const Limits limits{slide.force / std::sqrt(alpha), twist.moment / std::sqrt(beta)};
      double sum = 0.0;
      for (const Place& place : places) {
        const double x_part = place.force / limits.force;
        const double y_part = place.moment / limits.moment;
        const double square = x_part * x_part + y_part * y_part;
        const double error = (square - 1.0) / (square + 1.0);
        sum += error * error / (error * error + 0.01);
      }
      if (sum < least) {
        least = sum;
        best = limits;
      }
    }
  }
  return best;
}

std::vector<WeightedSample> weigh(std::span<const Sample> samples, bool with_sigma, Limits limits, double gamma,
                                  double noise, double reference_load) {
  std::vector<WeightedSample> weighted;
  weighted.reserve(samples.size());
  for (const Sample& sample : samples) {
    const double sigma_force = noise * (with_sigma ? sample.sigma_force : limits.force * sample.load);
    const double growth = std::pow(sample.load / reference_load, gamma);
    const double sigma_moment = noise * (with_sigma ? sample.sigma_moment : limits.moment * sample.load * growth);
    weighted.push_back({std::fabs(sample.force) / sigma_force, std::fabs(sample.moment) / sigma_moment,
                        sample.load / sigma_force, sample.load / sigma_moment, std::log(sample.load / reference_load)});
  }
  return weighted;
}

}  // namespace

std::unique_ptr<UnitCurve> make_curve(const ContactModel& model) {
  switch (model.kind) {
    case ContactModel::Kind::ellipse:
      return make_ellipse();
    case ContactModel::Kind::power:
      return make_family(ShapeFamily::power(), "n", 0.5);
    case ContactModel::Kind::xydas_kao:
      return make_family(ShapeFamily::xydas_kao(), "k", 2.0);
    case ContactModel::Kind::law:
      break;
  }
  if (!model.pressure_law) throw std::invalid_argument("model 'law': expected a pressure law, got none");
  return make_law(*model.pressure_law);
}

bool is_exact(const ContactModel& model) {
  return model.kind == ContactModel::Kind::law || model.kind == ContactModel::Kind::power ||
         model.kind == ContactModel::Kind::xydas_kao;
}

std::vector<Parameter> free_parameters(const UnitCurve& curve, const ContactLayout& layout, const ContactModel& model,
                                       Limits start) {
  const bool exact = is_exact(model);
  // The bounds are a factor of 1000 on either side of the start.
  constexpr double reach = 7.0;
  const double force = std::log(start.force);
  const double moment = std::log(start.moment);
  std::vector<Parameter> parameters{{exact ? "mu" : "force_max", force, force - reach, force + reach},
                                    {exact ? "mu_r" : "moment_max", moment, moment - reach, moment + reach}};
  if (layout.shape) parameters.push_back({curve.shape_name(), curve.start(), curve.low(), curve.high()});
  if (layout.gamma) parameters.push_back({"gamma", layout.fixed_gamma, gamma_range[0], gamma_range[1]});
  return parameters;
}

Loss approach(const ContactResiduals& residuals, std::vector<Parameter>& parameters, const Loss& loss) {
  std::vector<double> values;
  for (const Parameter& parameter : parameters) values.push_back(parameter.start);
  std::vector<double> distances(residuals.count());
  for (std::size_t i = 0; i < distances.size(); ++i) residuals.evaluate(i, values, distances[i], nullptr);
  // Random range of a scatter of 1.
  constexpr double usual = 1.5;
  constexpr int most_passes = 20;
  double scatter = 1.4826 * median_size(distances);
  for (int pass = 0; pass < most_passes && scatter > usual; ++pass) {
    const Solution solution = minimise(residuals, parameters, {loss.kind, loss.scale * scatter}, coarse_tolerance);
    for (std::size_t j = 0; j < parameters.size(); ++j) parameters[j].start = solution.values[j];
    const double before = scatter;
    scatter = 1.4826 * median_size(solution.residuals);
    if (scatter > 0.9 * before) break;
  }
  return {loss.kind, loss.scale * (scatter > usual ? scatter : 1.0)};
}

ContactPreparation prepare(std::span<const Sample> samples, const ContactFitOptions& options) {
  if (!(options.gamma >= gamma_range[0] && options.gamma <= gamma_range[1]))
    throw out_of_range("gamma", options.gamma, "1", "-0.5 <= gamma <= 1");
  if (!(options.loss.scale > 0.0) || std::isinf(options.loss.scale))
    throw out_of_range("loss scale", options.loss.scale, "1", "> 0 and finite");
  ContactPreparation preparation{check(samples), 0.0, {}, 1.0, {}};
  if (preparation.with_sigma) check_signal(samples);
  double log_load = 0.0;
  for (const Sample& sample : samples) log_load += std::log(sample.load);
  preparation.reference_load = std::exp(log_load / static_cast<double>(samples.size()));
  preparation.start = starting_limits(samples, options.gamma, preparation.reference_load);
  // Without sigmas the unit of error is the limit itself, for which an ellipse is good enough. A robust loss also needs
  // the typical error, 1.4826 median |residual|, which outliers hardly move. An ellipse would add its own misfit to it:
  // with Huber's loss and a tenth of the rows inside the curve, 66 to 70 % of the intervals would hold the truth, and
  // not 87 %.
  const bool robust = options.loss.kind != Loss::Kind::squared;
  const std::unique_ptr<UnitCurve> curve = robust ? make_flexible() : make_ellipse();
  const ContactLayout layout{robust, options.fit_gamma, options.gamma};
  const int passes = preparation.with_sigma ? 0 : robust ? 2 : 1;
  double gamma = options.gamma;
  for (int pass = 0; pass < passes; ++pass) {
    const auto weighted =
        weigh(samples, false, preparation.start, gamma, preparation.noise, preparation.reference_load);
    const ContactResiduals residuals(weighted, *curve, layout);
    const std::vector<Parameter> parameters =
        free_parameters(*curve, layout, {ContactModel::Kind::ellipse}, preparation.start);
    const Loss loss = pass == 0 && robust ? Loss::cauchy(0.05) : options.loss;
    const Solution solution = minimise(residuals, parameters, loss, coarse_tolerance);
    preparation.start = {std::exp(solution.values[0]), std::exp(solution.values[1])};
    if (options.fit_gamma) gamma = solution.values.back();
    if (robust) {
      preparation.noise *= std::max(1.4826 * median_size(solution.residuals), 1e-9);
    }
  }
  preparation.samples =
      weigh(samples, preparation.with_sigma, preparation.start, gamma, preparation.noise, preparation.reference_load);
  return preparation;
}

}  // namespace limitcurve::fit::internal
