// SPDX-License-Identifier: MIT
#pragma once

#include "fit/measurements.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// The interface to Ceres; no other file of the module includes it.
namespace limitcurve::fit::internal {

/// A model with one residual a sample and its analytic gradient. Called from one thread, many times in a row with the
/// same parameters, so that a model may cache values that depend only on them.
class ResidualModel {
 public:
  virtual ~ResidualModel() = default;
  [[nodiscard]] virtual std::size_t count() const noexcept = 0;
  /// The residual of sample i at `parameters`, and into `gradient` (if not null) its derivatives. False where the model
  /// is not defined.
  virtual bool evaluate(std::size_t i, std::span<const double> parameters, double& residual,
                        double* gradient) const = 0;
};

/// A free parameter: its start and its physical bounds. With low = high it is fixed.
struct Parameter {
  std::string name;
  double start;
  double low;
  double high;
  [[nodiscard]] bool is_held() const noexcept { return low == high; }
};

struct Solution {
  std::vector<double> values;
  /// Residuals before any loss, in the samples' order, and the gradient of each, row by row.
  std::vector<double> residuals;
  std::vector<double> jacobian;
  double cost = 0.0;  ///< ½ Σ loss(residual²)
  bool converged = false;
  int iterations = 0;
  std::string message;
};

/// Relative change of the cost that ends the iteration. The error of the parameters is then about its root, times the
/// root of the number of samples, in standard errors; without noise they are exact to rounding in any case.
inline constexpr double fine_tolerance = 1e-14;
inline constexpr double coarse_tolerance = 1e-7;

/// Minimises ½ Σ loss(residual²) within the bounds. A solution on a bound has converged only if no parameter that can
/// move would still lower the cost. Throws std::invalid_argument if the model is undefined at the start.
Solution minimise(const ResidualModel& model, std::span<const Parameter> parameters, const Loss& loss = {},
                  double tolerance = fine_tolerance);

/// ½ Σ loss(residual²) with a loss that may differ from the minimised one.
double cost_of(const Solution& solution, const Loss& loss);

/// Covariance of the parameters, row by row: σ²(JᵀJ)⁻¹. For plain least squares σ² is `variance`, that of one residual
/// (1 if residuals are already in units of their standard deviation). For a robust loss it is Huber's estimate from all
/// influences ψ, but at least `variance` (0 if the noise is unknown). Throws std::invalid_argument with the names of
/// the parameters that the samples do not determine: a column of the Jacobian, or a singular value of it with columns
/// of unit length, below 1e-9 of the largest.
std::vector<double> covariance(const Solution& solution, std::span<const Parameter> parameters, const Loss& loss,
                               double variance);

}  // namespace limitcurve::fit::internal
