// SPDX-License-Identifier: MIT
#include "fit/internal/report.hpp"
#include "fit/internal/chance.hpp"

#include "limitcurve/internal/number.hpp"

#include <limits>

namespace limitcurve::fit::internal {

std::invalid_argument too_few_samples(std::size_t count, std::size_t free, const std::string& names,
                                      const std::string& sigmas) {
  const std::string one_more =
      std::to_string(free + 1) + " samples, or " + std::to_string(free) + " with the columns " + sigmas;
  return std::invalid_argument("not identifiable from " + std::to_string(count) +
                               (count == 1 ? " sample: " : " samples: ") + names + ", expected at least " + one_more +
                               ": without sigmas the noise is known from the scatter alone");
}

double root_mean_square(std::span<const double> residuals) noexcept {
  double sum = 0.0;
  for (const double residual : residuals) sum += residual * residual;
  return residuals.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(residuals.size()));
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_size(std::vector<double> values) {
  for (double& value : values) value = std::fabs(value);
  return median_of(std::move(values));
}

std::invalid_argument bad_sample(std::size_t index, const char* name, double value, const std::string& expected) {
  return std::invalid_argument("sample " + std::to_string(index + 1) + ": " + name + " = " + format_number(value) +
                               ": expected " + expected);
}

double residual_variance(const Solution& solution) noexcept {
  const std::size_t count = solution.residuals.size();
  const std::size_t free = solution.values.size();
  if (count <= free) return 0.0;
  const double rms = root_mean_square(solution.residuals);
  return rms * rms * static_cast<double>(count) / static_cast<double>(count - free);
}

void describe(FitReport& report, const Solution& solution) {
  report.residuals = solution.residuals.size();
  report.free_parameters = solution.values.size();
  report.rms = root_mean_square(solution.residuals);
  report.converged = solution.converged;
  report.iterations = solution.iterations;
  report.message = solution.message;
}

void set_estimates(FitReport& report, std::span<const Quantity> quantities, std::span<const double> jacobian,
                   std::span<const double> covariance) {
  const std::size_t count = quantities.size();
  const std::size_t free = count == 0 ? 0 : jacobian.size() / count;
  const auto propagated = [&](std::size_t a, std::size_t b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < free; ++i) {
      for (std::size_t j = 0; j < free; ++j)
        sum += jacobian[a * free + i] * covariance[i * free + j] * jacobian[b * free + j];
    }
    return sum;
  };
  report.estimates.clear();
  for (std::size_t a = 0; a < count; ++a) {
    const auto& [name, value, unit, role] = quantities[a];
    report.estimates.push_back({name, value, std::sqrt(std::max(propagated(a, a), 0.0)), unit, role});
  }
  report.correlation.assign(count * count, 0.0);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      const double scale = report.estimates[a].std_error * report.estimates[b].std_error;
      if (scale > 0.0) report.correlation[a * count + b] = a == b ? 1.0 : propagated(a, b) / scale;
    }
  }
}

std::vector<double> covariances_of(const FitReport& report) {
  const std::vector<Estimate>& estimates = report.estimates;
  const std::size_t count = estimates.size();
  std::vector<double> covariances(count * count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j)
      covariances[i * count + j] =
          (i == j ? 1.0 : report.correlation[i * count + j]) * estimates[i].std_error * estimates[j].std_error;
  }
  return covariances;
}

void set_covariances(FitReport& report, std::span<const double> covariances) {
  const std::size_t count = report.estimates.size();
  for (std::size_t i = 0; i < count; ++i) report.estimates[i].std_error = std::sqrt(covariances[i * count + i]);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const double scale = report.estimates[i].std_error * report.estimates[j].std_error;
      const double correlation = i == j ? 1.0 : covariances[i * count + j] / scale;
      report.correlation[i * count + j] =
          std::isfinite(scale) && scale > 0.0 ? std::clamp(correlation, -1.0, 1.0) : 0.0;
    }
  }
}

void add_error(FitReport& report, std::span<const double> offs) {
  std::vector<double> covariances = covariances_of(report);
  for (std::size_t i = 0; i < offs.size(); ++i) {
    for (std::size_t j = 0; j < offs.size(); ++j) covariances[i * offs.size() + j] += offs[i] * offs[j];
  }
  set_covariances(report, covariances);
}

std::string note_of_few_rows(std::size_t spare) {
  if (spare == 0 || spare >= 30) return "";
  const double rare = student_quantile(static_cast<double>(spare), 0.975);
  return "; few rows: a 95 % interval is +- " + format_number(rare, 3) + " std_error";
}

double akaike(double cost, std::size_t residuals, std::size_t free_parameters, bool known_variance) noexcept {
  const auto n = static_cast<double>(residuals);
  const double p = static_cast<double>(free_parameters) + (known_variance ? 0.0 : 1.0);
  const double chi_square = std::max(2.0 * cost, n * perfect * perfect);
  const double misfit = known_variance ? chi_square : n * std::log(chi_square / n);
  if (known_variance) return misfit + 2.0 * p;
  // So few samples say nothing of a model with so many parameters.
  if (!(n - p - 1.0 > 0.0)) return std::numeric_limits<double>::infinity();
  return misfit + 2.0 * p + 2.0 * p * (p + 1.0) / (n - p - 1.0);
}

}  // namespace limitcurve::fit::internal
