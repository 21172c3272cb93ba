// SPDX-License-Identifier: MIT
#include "fit/ratio_fit.hpp"

#include "fit/contact_fit.hpp"
#include "fit/internal/chance.hpp"
#include "fit/internal/report.hpp"
#include "limitcurve/internal/number.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace limitcurve::fit {

using namespace internal;

namespace {

void require_length(std::size_t index, const char* name, double value) {
  if (!(value > 0.0 && std::isfinite(value))) throw bad_sample(index, name, value, "> 0 m and finite");
}

}  // namespace

FitReport fit_ratio(std::span<const RatioSample> samples, const PressureLaw& law) {
  if (samples.size() < 2) {
    throw std::invalid_argument("samples: expected at least two ratios to compare, got " +
                                std::to_string(samples.size()));
  }
  bool counted = true;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    require_length(i, "ratio", samples[i].ratio);
    require_length(i, "ratio_sd", samples[i].sd);
    const double n = samples[i].n;
    if (n != 0.0 && !(n >= 1.0 && std::isfinite(n))) {
      throw bad_sample(i, "n", n, ">= 1 and finite, or 0");
    }
    counted = counted && n != 0.0;
  }
  const auto weight = [&](const RatioSample& sample) { return (counted ? sample.n : 1.0) / sample.sd / sample.sd; };
  double weights = 0.0;
  double mean = 0.0;
  for (const RatioSample& sample : samples) {
    weights += weight(sample);
    mean += (sample.ratio - mean) * (weight(sample) / weights);
  }
  double chi_squared = 0.0;
  for (const RatioSample& sample : samples)
    chi_squared += weight(sample) * (sample.ratio - mean) * (sample.ratio - mean);
  const auto freedom = static_cast<double>(samples.size() - 1);
  constexpr double significant = 0.05;
  const Estimate ratio{"ratio", mean, counted ? 1.0 / std::sqrt(weights) : std::numeric_limits<double>::quiet_NaN(),
                       "m", Estimate::Role::ratio};
  FitReport report;
  report.estimates = {ratio, implied_radius(ratio, law)};
  if (counted) {
    const double p_value = chi_squared_chance(freedom, chi_squared);
    report.estimates.insert(report.estimates.end(), {{"chi_squared", chi_squared, 0.0, "1"},
                                                     {"degrees_of_freedom", freedom, 0.0, "1"},
                                                     {"p_value", p_value, 0.0, "1"}});
    if (p_value < significant) {
      report.warnings.push_back(
          "the ratios differ by more than their standard errors explain (p = " + format_number(p_value, 3) + ")");
    }
  } else {
    const double bound = chi_squared_bound(freedom, significant);
    const double refuted = chi_squared > 0.0 ? bound / chi_squared : std::numeric_limits<double>::infinity();
    report.estimates.insert(report.estimates.end(), {{"chi_squared_per_n", chi_squared, 0.0, "1"},
                                                     {"degrees_of_freedom", freedom, 0.0, "1"},
                                                     {"n_for_p_0.05", refuted, 0.0, "1"}});
  }
  report.correlation.assign(report.estimates.size() * report.estimates.size(), 0.0);
  for (const std::size_t both : {std::size_t{0}, std::size_t{1}}) {
    report.correlation[both] = report.correlation[report.estimates.size() + both] = 1.0;
  }
  report.residuals = samples.size();
  report.free_parameters = 1;
  report.rms = std::sqrt(chi_squared / static_cast<double>(samples.size()));
  report.converged = true;
  report.message = "in closed form";
  report.note = std::string("one ratio for all rows, weighted by ") +
                (counted ? "n/ratio_sd^2" : "1/ratio_sd^2; n not known: no standard error, no p-value") +
                "; radius under " + std::string(law.name());
  return report;
}

}  // namespace limitcurve::fit
