// SPDX-License-Identifier: MIT
#include "fit/internal/contact_correction.hpp"

#include "fit/internal/bias.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limitcurve::fit::internal {

namespace {

/// Index of the shape among the parameters.
constexpr std::size_t shape_place = 2;

double variance_of_shape(std::span<const double> covariance, std::size_t free) noexcept {
  return covariance[shape_place * free + shape_place];
}

}  // namespace

Stray stray_of(const FittedContact& fit) {
  Stray stray{{}, covariance(fit.solution, fit.parameters, fit.loss, fit.variance)};
  stray.bias = second_order_bias(fit.residuals, fit.solution, fit.loss, stray.covariance);
  const std::size_t free = fit.parameters.size();
  for (std::size_t j = 0; j < free; ++j) {
    const double cap = 0.5 * std::sqrt(stray.covariance[j * free + j]);
    stray.bias[j] = std::clamp(stray.bias[j], -cap, cap);
  }
  return stray;
}

Stray expected_stray(const FittedContact& fit, const Stray& at_solution) {
  const std::size_t free = fit.parameters.size();
  std::vector<double> values = fit.solution.values;
  for (std::size_t j = 0; j < free; ++j) values[j] -= at_solution.bias[j];
  values[shape_place] -= 0.5 * variance_of_shape(at_solution.covariance, free);
  values[shape_place] = std::clamp(values[shape_place], fit.parameters[shape_place].low, fit.parameters[shape_place].high);
  const Solution nearer = moved(fit.residuals, fit.solution, std::move(values));
  return stray_of({fit.residuals, nearer, fit.parameters, fit.loss, fit.variance});
}

void unbias(FitReport& report, const Reported& reported, const Stray& stray, std::size_t bent) {
  const std::size_t free = stray.bias.size();
  for (std::size_t a = 0; a < report.estimates.size(); ++a) {
    const double* const slopes = reported.jacobian.data() + a * free;
    double shift = 0.0;
    double variance = 0.0;
    for (std::size_t j = 0; j < free; ++j) {
      shift += slopes[j] * stray.bias[j];
      for (std::size_t k = 0; j < bent && k < bent; ++k) variance += slopes[j] * stray.covariance[j * free + k] * slopes[k];
    }
    const double scale = reported.scales[a];
    if (scale == 0.0) {
      report.estimates[a].value -= shift;
    } else {
      const double bend = reported.bends[a] == 0.0 ? 0.0 : reported.bends[a] * variance_of_shape(stray.covariance, free);
      report.estimates[a].value += scale * std::expm1(-shift / scale - 0.5 * variance / (scale * scale) - bend);
    }
  }
}

double mean_shape_error(const FittedContact& fit, std::span<const double> covariance, const UnitCurve& curve) {
  constexpr double two_sided_95 = 1.959964;
  const std::size_t free = fit.parameters.size();
  const double error = std::sqrt(variance_of_shape(covariance, free));
  double sum = 4.0 * curve.parameter_slope(fit.solution.values[shape_place]) * error;
  if (error == 0.0) return 0.0;
  for (const double sign : {-1.0, 1.0}) {
    // The other parameters follow the line of their correlation.
    std::vector<double> values = fit.solution.values;
    for (std::size_t j = 0; j < free; ++j) values[j] += sign * two_sided_95 * covariance[j * free + shape_place] / error;
    values[shape_place] = std::clamp(values[shape_place], curve.low(), curve.high());
    const double coordinate = values[shape_place];
    const Solution there = moved(fit.residuals, fit.solution, std::move(values));
    const std::vector<double> spread = internal::covariance(there, fit.parameters, fit.loss, fit.variance);
    sum += curve.parameter_slope(coordinate) * std::sqrt(variance_of_shape(spread, free));
  }
  return sum / 6.0;
}

double log_moment_ratio_curvature(UnitCurve& curve, double shape) {
  constexpr double step = 1e-3;
  const auto slope_at = [&](double coordinate) {
    curve.bend(coordinate);
    return curve.moment_ratio_slope() / curve.moment_ratio();
  };
  const double low = std::max(shape - step, curve.low());
  const double high = std::min(shape + step, curve.high());
  const double curvature = (slope_at(high) - slope_at(low)) / (high - low);
  curve.bend(shape);
  return curvature;
}

}  // namespace limitcurve::fit::internal
