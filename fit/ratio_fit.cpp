// SPDX-License-Identifier: MIT
#include "fit/ratio_fit.hpp"

#include "fit/contact_fit.hpp"
#include "limitcurve/internal/number.hpp"

#include <boost/math/distributions/chi_squared.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace limitcurve::fit {

namespace {

void require_length(std::size_t index, const char* name, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument("sample " + std::to_string(index + 1) + ": " + name + " = " + format_number(value) +
                              ": expected > 0 m and finite");
}

}  // namespace

FitReport fit_ratio(std::span<const RatioSample> samples, const PressureLaw& law) {
  if (samples.size() < 2) {
    throw std::invalid_argument("samples: expected at least two ratios to compare, got " + std::to_string(samples.size()));
  }
  double weights = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    require_length(i, "ratio", samples[i].ratio);
    require_length(i, "ratio_sd", samples[i].sigma);
    const double weight = 1.0 / samples[i].sigma / samples[i].sigma;
    weights += weight;
    mean += (samples[i].ratio - mean) * (weight / weights);
  }
  FitReport report;
  double chi_squared = 0.0;
  for (const RatioSample& sample : samples) {
    const double residual = (sample.ratio - mean) / sample.sigma;
    chi_squared += residual * residual;
  }
  const auto freedom = static_cast<double>(samples.size() - 1);
  const double p_value = boost::math::cdf(boost::math::complement(boost::math::chi_squared(freedom), chi_squared));
  const Estimate ratio{"ratio", mean, 1.0 / std::sqrt(weights), "m"};
  report.estimates = {ratio,
                      implied_radius(ratio, law),
                      {"chi_squared", chi_squared, 0.0, "1"},
                      {"degrees_of_freedom", freedom, 0.0, "1"},
                      {"p_value", p_value, 0.0, "1"}};
  report.correlation.assign(report.estimates.size() * report.estimates.size(), 0.0);
  for (const std::size_t both : {std::size_t{0}, std::size_t{1}}) {
    report.correlation[both] = report.correlation[report.estimates.size() + both] = 1.0;
  }
  report.residuals = samples.size();
  report.free_parameters = 1;
  report.rms = std::sqrt(chi_squared / static_cast<double>(samples.size()));
  report.converged = true;
  report.message = "in closed form";
  report.note = "one ratio for all rows, weighted by 1/ratio_sd^2; radius under " + std::string(law.name());
  if (p_value < 0.05) {
    report.warnings.push_back("the ratios differ by more than their standard deviations explain (p = " + format_number(p_value) + ")");
  }
  return report;
}

}  // namespace limitcurve::fit
