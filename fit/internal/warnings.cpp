// SPDX-License-Identifier: MIT
#include "fit/internal/warnings.hpp"

#include "fit/internal/chance.hpp"
#include "fit/internal/report.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace limitcurve::fit::internal {

std::string listed(const char* one, const char* several, const std::vector<std::size_t>& places) {
  constexpr std::size_t most = 12;
  std::string text = places.size() == 1 ? one : several;
  for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
    text += (i == 0 ? " " : ", ") + std::to_string(places[i]);
  return places.size() > most ? text + " and " + std::to_string(places.size() - most) + " more" : text;
}

std::vector<std::size_t> outliers_of(const Solution& robust, bool with_sigma, double noise) {
  const auto count = static_cast<double>(robust.residuals.size());
  const double spare = count - static_cast<double>(robust.values.size());
  // With fewer spare rows most rows lie on the curve, and the others would look gross.
  if (spare < 3.0) return {};
  double scatter = 1.4826 * (1.0 + 5.0 / spare) * median_size(robust.residuals);
  if (with_sigma) scatter = std::max(scatter, 1.0);
  double gross = 3.0;
  while (count * std::erfc(gross / std::sqrt(2.0)) > 0.005) gross += 0.1;
  const double least = with_sigma ? 0.0 : 1e-3 / noise;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < robust.residuals.size(); ++i) {
    if (std::fabs(robust.residuals[i]) > std::max(gross * scatter, least)) rows.push_back(i);
  }
  return rows;
}

void warn_of_outliers(FitReport& report, const std::vector<std::size_t>& rows, const Loss& loss) {
  if (rows.empty()) return;
  report.warnings.push_back(
      listed("row", "rows", rows) + " (the first is 1) " + (rows.size() == 1 ? "lies" : "lie") +
      " far off the curve. If the finger did not slip there, remove " + (rows.size() == 1 ? "it" : "them") +
      (loss.kind == Loss::Kind::squared ? ", or use the loss cauchy, which gives them little weight" : ""));
}

void warn_of_rows_inside(FitReport& report, std::span<const double> distances) {
  constexpr double far_inside = -0.5;
  constexpr double many = 0.05;
  const auto inside =
      std::count_if(distances.begin(), distances.end(), [](double distance) { return distance < far_inside; });
  if (static_cast<double>(inside) <= many * static_cast<double>(distances.size())) return;
  report.warnings.push_back(
      std::to_string(inside) + " of " + std::to_string(distances.size()) +
      " rows lie inside the curve by more than half of it. Did the finger slip in these rows? If not, remove them");
}

void warn_of_scatter(FitReport& report, const Solution& solution, const Loss& loss, bool with_sigma) {
  const auto count = static_cast<double>(solution.residuals.size());
  if (!with_sigma || report.residuals <= report.free_parameters) return;
  const double scatter = loss.kind != Loss::Kind::squared ? 1.4826 * median_size(solution.residuals)
                                                          : std::sqrt(residual_variance(solution));
  const bool large = scatter > 1.0 + 3.0 / std::sqrt(count);
  report.scatter_refused = large;
  if (!large && !(scatter < 1.0 - 3.0 / std::sqrt(count))) return;
  report.warnings.push_back("the rows scatter " + format_number(scatter, 3) +
                            " times as much as their sigmas predict: " +
                            (large ? "there are outliers, the model is wrong, or the sigmas are too small"
                                   : "are they of one reading? The standard errors are as much too large"));
}

void refuse_hidden(const Parameter& parameter, double variance) {
  if (std::sqrt(variance) < 0.5 * (parameter.high - parameter.low)) return;
  throw std::invalid_argument("not identifiable from these samples: " + parameter.name + " (its standard error is " +
                              format_number(std::sqrt(variance), 3) + ", more than half of its range, " +
                              format_number(parameter.low) + " to " + format_number(parameter.high) +
                              "), expected loads that differ more, or less scatter");
}

void warn_of_end(FitReport& report, const Parameter& parameter, double value) {
  if (std::min(value - parameter.low, parameter.high - value) > 1e-3 * (parameter.high - parameter.low)) return;
  report.warnings.push_back(parameter.name + " is at the end of its range, " + format_number(value, 3) +
                            ": the data may ask for more");
}

void warn_of_growth(FitReport& report, double assumed, const Estimate& gamma, double spare, double rms) {
  const double difference = std::fabs(gamma.value - assumed);
  // Fewer spare rows do not tell their noise. Ignore the last digits of exact data.
  if (!(spare >= 5.0) || difference < 1e-6) return;
  const double rare = student_quantile(spare, 1.0 - 0.5 / 2000.0);
  if (!(difference > rare * gamma.std_error)) return;
  report.gamma_refused = true;
  // Gross outliers may hide the gain.
  const std::string gain =
      rms < report.rms ? ": rms " + format_number(rms, 3) + " instead of " + format_number(report.rms, 3) : "";
  report.warnings.push_back("gamma = " + format_number(assumed) + " was assumed, but " + format_number(gamma.value, 3) +
                            " +- " + format_number(gamma.std_error, 3) + " fits better" + gain + "; fit gamma as well");
}

}  // namespace limitcurve::fit::internal
