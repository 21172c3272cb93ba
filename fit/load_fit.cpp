// SPDX-License-Identifier: MIT
#include "fit/load_fit.hpp"

#include "fit/internal/least_squares.hpp"
#include "fit/internal/report.hpp"
#include "fit/internal/warnings.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace limitcurve::fit {

using namespace internal;

namespace {

struct Row {
  double log_load;  // ln(P/P₀), P₀ the geometric mean
  double value;
  double log_value;
  double sigma;  // 0: not known
};

/// With p₀ = ln value(P₀) and γ: model v = exp(p₀ + (γ + e) ln(P/P₀)), e = 0 for radii and 1 for moments.
///   known σ:   r = (v − value)/σ,          ∂r/∂p₀ = v/σ, ∂r/∂γ = v ln(P/P₀)/σ;
///   unknown σ: r = (ln v − ln value)/noise, ∂r/∂p₀ = 1/noise, ∂r/∂γ = ln(P/P₀)/noise.
class LoadResiduals final : public ResidualModel {
 public:
  LoadResiduals(const std::vector<Row>& rows, double offset, bool fit_gamma, double gamma, double noise)
      : rows_(rows), offset_(offset), fit_gamma_(fit_gamma), gamma_(gamma), noise_(noise) {}
  std::size_t count() const noexcept override { return rows_.size(); }
  bool evaluate(std::size_t i, std::span<const double> parameters, double& residual, double* gradient) const override {
    const Row& row = rows_[i];
    const double log_model = parameters[0] + ((fit_gamma_ ? parameters[1] : gamma_) + offset_) * row.log_load;
    double rate = 1.0 / noise_;
    if (row.sigma > 0.0) {
      const double model = std::exp(log_model);
      residual = (model - row.value) / row.sigma;
      rate = model / row.sigma;
    } else {
      residual = (log_model - row.log_value) * rate;
    }
    if (gradient != nullptr) {
      gradient[0] = rate;
      if (fit_gamma_) gradient[1] = rate * row.log_load;
    }
    return true;
  }

 private:
  const std::vector<Row>& rows_;
  double offset_;
  bool fit_gamma_;
  double gamma_;
  double noise_;
};

double fixed_gamma(LoadModel model) {
  return model == LoadModel::hertz ? 1.0 / 3.0 : 0.0;
}

struct Preparation {
  std::vector<Row> rows;
  double log_reference = 0.0;
  double offset = 0.0;
  bool with_sigma = false;
  double noise = 1.0;
};

std::vector<Parameter> free_parameters(const Preparation& data, LoadModel model) {
  std::vector<double> logs;
  const double gamma = model == LoadModel::power ? 0.25 : fixed_gamma(model);
  for (const Row& row : data.rows) logs.push_back(row.log_value - (gamma + data.offset) * row.log_load);
  const double start = median_of(logs);
  std::vector<Parameter> parameters{{data.offset > 0.0 ? "mu_r" : "c", start, start - 20.0, start + 20.0}};
  if (model == LoadModel::power) parameters.push_back({"gamma", gamma, -0.5, 1.5});
  return parameters;
}

Preparation prepare(const LoadSamples& samples, const Loss& loss) {
  if (loss.kind == Loss::Kind::edge) throw std::invalid_argument("loss edge: only for slips under a law (ratio, law)");
  if (!(loss.scale > 0.0) || std::isinf(loss.scale))
    throw out_of_range("loss scale", loss.scale, "1", "> 0 and finite");
  if (samples.samples.empty()) throw std::invalid_argument("samples: expected at least one, got none");
  Preparation data;
  const bool moments = samples.quantity == LoadSamples::Quantity::moment;
  data.offset = moments ? 1.0 : 0.0;
  data.with_sigma = samples.samples.front().sigma > 0.0;
  for (std::size_t i = 0; i < samples.samples.size(); ++i) {
    const LoadSamples::Row& sample = samples.samples[i];
    const auto require = [&](bool good, const char* name, double value, const char* expected) {
      if (!good) throw bad_sample(i, name, value, expected);
    };
    require(sample.load > 0.0 && std::isfinite(sample.load), "load", sample.load, "> 0 N and finite");
    require(sample.value > 0.0 && std::isfinite(sample.value), moments ? "moment" : "radius", sample.value,
            "> 0 and finite");
    require(data.with_sigma ? sample.sigma > 0.0 && std::isfinite(sample.sigma) : sample.sigma == 0.0, "sigma",
            sample.sigma, data.with_sigma ? "> 0 and finite in every sample" : "0 in every sample, as in the first");
    data.rows.push_back({std::log(sample.load), sample.value, std::log(sample.value), sample.sigma});
    data.log_reference += std::log(sample.load) / static_cast<double>(samples.samples.size());
  }
  for (Row& row : data.rows) row.log_load -= data.log_reference;
  if (!data.with_sigma && loss.kind != Loss::Kind::squared) {
    // A robust loss needs the typical error, the same for all models: take it from the most flexible one.
    const std::vector<Parameter> parameters = free_parameters(data, LoadModel::power);
    const LoadResiduals residuals(data.rows, data.offset, true, 0.0, 1.0);
    data.noise = std::max(1.4826 * median_size(minimise(residuals, parameters, Loss::cauchy(0.05)).residuals), 1e-9);
  }
  return data;
}

LoadFit fit_prepared(const Preparation& data, LoadModel model, const Loss& loss) {
  const bool fit_gamma = model == LoadModel::power;
  const std::vector<Parameter> parameters = free_parameters(data, model);
  const std::size_t free = parameters.size();
  const std::size_t count = data.rows.size();
  const bool robust = loss.kind != Loss::Kind::squared;
  if (count < free || (count == free && !data.with_sigma)) {
    throw too_few_samples(count, free, parameters[0].name + (fit_gamma ? ", gamma" : ""), "of sigmas");
  }
  const LoadResiduals residuals(data.rows, data.offset, fit_gamma, fixed_gamma(model), data.noise);
  // Linear in the logarithms: a regression line is a good start.
  const Solution solution = minimise(residuals, parameters, loss, 1e-18);
  const double variance = data.with_sigma ? 1.0 : robust ? 0.0 : residual_variance(solution);
  const std::vector<double> covariance = internal::covariance(solution, parameters, loss, variance);
  if (fit_gamma) refuse_hidden(parameters.back(), covariance.back());

  LoadFit fit{model, {}};
  describe(fit.report, solution);
  fit.report.note = std::string(to_string(model)) + "; gamma " + (fit_gamma ? "fitted" : "assumed") + "; " +
                    to_string(loss.kind) + " loss" +
                    (data.with_sigma ? "" : "; relative errors of one size assumed" + note_of_few_rows(count - free));
  fit.report.rms *= data.noise;
  fit.report.aic = akaike(solution.cost, count, free, data.with_sigma || robust);
  // From the value at the reference load to that at 1 N, per newton for moments.
  const double gamma = fit_gamma ? solution.values[1] : fixed_gamma(model);
  const double coefficient = std::exp(solution.values[0] - (gamma + data.offset) * data.log_reference);
  const std::array<Quantity, 2> quantities{
      {{parameters[0].name, coefficient, gamma == 0.0 && !fit_gamma ? "m" : "m/N^gamma",
        data.offset > 0.0 ? Estimate::Role::moment : Estimate::Role::radius},
       {"gamma", gamma, "1", Estimate::Role::gamma}}};
  if (fit_gamma) {
    internal::set_estimates(fit.report, quantities,
                            std::array{coefficient, -coefficient * data.log_reference, 0.0, 1.0}, covariance);
    warn_of_end(fit.report, parameters.back(), gamma);
    const Estimate& estimate = fit.report.at("gamma");
    if (estimate.value < -2.0 * estimate.std_error || estimate.value > 1.0 / 3.0 + 2.0 * estimate.std_error) {
      fit.report.warnings.push_back("gamma = " + format_number(estimate.value, 3) +
                                    " is outside 0 to 1/3, the range of solid contacts");
    }
  } else {
    internal::set_estimates(fit.report, quantities, std::array{coefficient, 0.0}, covariance);
  }
  warn_of_scatter(fit.report, solution, loss, data.with_sigma);
  if (!fit.report.converged) fit.report.warnings.push_back("the minimiser did not converge: " + fit.report.message);
  return fit;
}

/// Fits the power law with Cauchy's loss, and warns of gross outliers and of an assumed growth that the data
/// contradict.
void check_assumptions(LoadFit& fit, const LoadSamples& samples, const Loss& loss) {
  try {
    const Preparation data = prepare(samples, Loss::cauchy());
    const std::vector<Parameter> parameters = free_parameters(data, LoadModel::power);
    const LoadResiduals residuals(data.rows, data.offset, true, 0.0, data.noise);
    const Solution solution = minimise(residuals, parameters, Loss::cauchy());
    const std::vector<std::size_t> outliers = outliers_of(solution, data.with_sigma, data.noise);
    warn_of_outliers(fit.report, names_of(samples.samples, outliers), loss);
    if (fit.model == LoadModel::power) return;
    const std::vector<double> spread = covariance(solution, parameters, Loss::cauchy(), data.with_sigma ? 1.0 : 0.0);
    warn_of_growth(fit.report, fixed_gamma(fit.model), {"gamma", solution.values[1], std::sqrt(spread[3]), "1"},
                   static_cast<double>(data.rows.size()) - 2.0, root_mean_square(solution.residuals) * data.noise);
  } catch (const std::invalid_argument&) {
    // Too few rows for a power law, or only one load: no warning possible.
  }
}

}  // namespace

LoadFit fit_load(const LoadSamples& samples, LoadModel model, const Loss& loss) {
  if (model == LoadModel::best) return std::move(select_load(samples, loss).candidates.front());
  LoadFit fit = fit_prepared(prepare(samples, loss), model, loss);
  check_assumptions(fit, samples, loss);
  return fit;
}

LoadSelection select_load(const LoadSamples& samples, const Loss& loss) {
  const Preparation data = prepare(samples, loss);
  LoadSelection selection;
  const bool can_choose = data.rows.size() >= least_rows_of_choice(2);
  selection.candidates.push_back(fit_prepared(data, LoadModel::power, loss));
  if (can_choose) {
    for (const LoadModel model : {LoadModel::linear, LoadModel::hertz})
      selection.candidates.push_back(fit_prepared(data, model, loss));
  }
  const FitReport free = selection.candidates.front().report;
  std::stable_sort(selection.candidates.begin(), selection.candidates.end(),
                   [](const LoadFit& a, const LoadFit& b) { return a.report.aic < b.report.aic; });
  LoadFit& best = selection.candidates.front();
  best.report.note += can_choose ? "; best of 3 by AIC, the errors include the choice" : "; too few rows to choose";
  if (best.model != LoadModel::power) {
    // The power law contains the others: its errors, and how far the best is from it.
    std::vector<double> offs;
    for (std::size_t i = 0; i < free.estimates.size(); ++i) {
      best.report.estimates[i].std_error = free.estimates[i].std_error;
      offs.push_back(free.estimates[i].value - best.report.estimates[i].value);
    }
    best.report.correlation = free.correlation;
    add_error(best.report, offs);
  }
  check_assumptions(best, samples, loss);
  for (const LoadFit& candidate : selection.candidates) {
    // Infinite with too few rows to choose.
    const double difference = &candidate == &best ? 0.0 : candidate.report.aic - best.report.aic;
    selection.aic_difference.push_back(difference);
    if (&candidate != &best && difference < 2.0) {
      best.report.warnings.push_back(std::string("the data cannot distinguish ") + to_string(best.model) + " from " +
                                     to_string(candidate.model) + " (AIC difference " +
                                     format_number(std::round(difference * 100.0) / 100.0) + ")");
    }
  }
  return selection;
}

}  // namespace limitcurve::fit
