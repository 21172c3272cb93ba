// SPDX-License-Identifier: MIT
#include "fit/internal/bias.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limitcurve::fit::internal {

namespace {

/// ψ(r)/r.
double weight_of(const Loss& loss, double residual) noexcept {
  const double scaled = std::fabs(residual) / loss.scale;
  switch (loss.kind) {
    case Loss::Kind::huber:
      return scaled <= 1.0 ? 1.0 : 1.0 / scaled;
    case Loss::Kind::cauchy:
      return 1.0 / (1.0 + scaled * scaled);
    case Loss::Kind::squared:
      break;
  }
  return 1.0;
}

}  // namespace

std::vector<double> second_order_bias(const ResidualModel& model, const Solution& solution, const Loss& loss,
                                      std::span<const double> covariance) {
  const std::size_t free = solution.values.size();
  const std::size_t count = solution.residuals.size();
  std::vector<double> errors(free);
  for (std::size_t j = 0; j < free; ++j) {
    errors[j] = std::sqrt(std::max(covariance[j * free + j], 0.0));
    // Without noise there is no bias, and no step for the differences.
    if (!(errors[j] > 1e-10) || !std::isfinite(errors[j])) return std::vector<double>(free, 0.0);
  }
  // tr(H V) of each residual, summed parameter by parameter, so that the model is evaluated once for each step.
  std::vector<double> traces(count, 0.0);
  std::vector<double> values = solution.values;
  std::vector<double> above(free);
  std::vector<double> below(count * free);
  double residual = 0.0;
  for (std::size_t j = 0; j < free; ++j) {
    const double step = 0.01 * errors[j];
    values[j] = solution.values[j] - step;
    for (std::size_t i = 0; i < count; ++i) {
      if (!model.evaluate(i, values, residual, below.data() + i * free)) return std::vector<double>(free, 0.0);
    }
    values[j] = solution.values[j] + step;
    for (std::size_t i = 0; i < count; ++i) {
      if (!model.evaluate(i, values, residual, above.data())) return std::vector<double>(free, 0.0);
      for (std::size_t k = 0; k < free; ++k) {
        traces[i] += (above[k] - below[i * free + k]) / (2.0 * step) * covariance[j * free + k];
      }
    }
    values[j] = solution.values[j];
  }
  // In standard errors, so that the matrix is well scaled whatever the parameters' units.
  const auto size = static_cast<Eigen::Index>(free);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd gradient(size);
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weight_of(loss, solution.residuals[i]);
    for (std::size_t j = 0; j < free; ++j) gradient[static_cast<Eigen::Index>(j)] = solution.jacobian[i * free + j] * errors[j];
    information += weight * gradient * gradient.transpose();
    pull += weight * traces[i] * gradient;
    model.evaluate(i, solution.values, residual, nullptr);
  }
  const Eigen::VectorXd scaled = -0.5 * information.ldlt().solve(pull);
  std::vector<double> bias(free);
  for (std::size_t j = 0; j < free; ++j) {
    bias[j] = scaled[static_cast<Eigen::Index>(j)] * errors[j];
    if (!std::isfinite(bias[j])) return std::vector<double>(free, 0.0);
  }
  return bias;
}

Solution moved(const ResidualModel& model, const Solution& solution, std::vector<double> values) {
  Solution result = solution;
  result.values = std::move(values);
  const std::size_t free = result.values.size();
  for (std::size_t i = 0; i < result.residuals.size(); ++i) {
    model.evaluate(i, result.values, result.residuals[i], result.jacobian.data() + i * free);
  }
  return result;
}

}  // namespace limitcurve::fit::internal
