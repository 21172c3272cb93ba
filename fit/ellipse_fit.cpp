// SPDX-License-Identifier: MIT
#include "fit/ellipse_fit.hpp"

#include "fit/internal/curve_points.hpp"
#include "fit/internal/least_squares.hpp"
#include "fit/internal/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limitcurve::fit {

namespace {

/// With the ellipse's gauge γ = √((x/A)² + (y/B)²) of a curve point (x, y), the radial error is e = 1/γ − 1 and
///   ∂e/∂A = x²/(A³γ³),  ∂e/∂B = y²/(B³γ³).
class EllipseResiduals final : public internal::ResidualModel {
 public:
  explicit EllipseResiduals(const std::vector<internal::CurvePoint>& points) : points_(points) {}
  std::size_t count() const noexcept override { return points_.size(); }
  bool evaluate(std::size_t i, std::span<const double> parameters, double& residual, double* gradient) const override {
    const double x = points_[i].x / parameters[0];
    const double y = points_[i].y / parameters[1];
    const double inverse = 1.0 / std::sqrt(x * x + y * y);
    residual = inverse - 1.0;
    if (gradient != nullptr) {
      const double cube = inverse * inverse * inverse;
      gradient[0] = x * x / parameters[0] * cube;
      gradient[1] = y * y / parameters[1] * cube;
    }
    return true;
  }

 private:
  const std::vector<internal::CurvePoint>& points_;
};

EllipseFit measure(const PressureLaw& law, const std::vector<double>& residuals, double force_max, double relative_moment_max) {
  EllipseFit fit{Ellipse(force_max, relative_moment_max * law.moment_ratio())};
  for (const double residual : residuals) {
    fit.max_over_estimate = std::max(fit.max_over_estimate, residual);
    fit.max_under_estimate = std::max(fit.max_under_estimate, -residual);
  }
  fit.report.residuals = residuals.size();
  fit.report.rms = internal::root_mean_square(residuals);
  return fit;
}

}  // namespace

EllipseFit ellipse_through_intercepts(const Law& law, std::size_t points) {
  const std::vector<internal::CurvePoint> curve = internal::curve_points(*law, points);
  const EllipseResiduals model(curve);
  const std::array<double, 2> unit{1.0, 1.0};
  std::vector<double> residuals(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) model.evaluate(i, unit, residuals[i], nullptr);
  EllipseFit fit = measure(*law, residuals, 1.0, 1.0);
  fit.report.estimates = {{"force_max", 1.0, 0.0, "1"}, {"moment_max", law->moment_ratio(), 0.0, "1"}};
  fit.report.correlation.assign(4, 0.0);
  fit.report.converged = true;
  fit.report.message = "through the intercepts: nothing to iterate";
  return fit;
}

EllipseFit fit_ellipse(const Law& law, std::size_t points) {
  const std::vector<internal::CurvePoint> curve = internal::curve_points(*law, points);
  const EllipseResiduals model(curve);
  const std::array<internal::Parameter, 2> parameters{{{"force_max", 1.0, 0.1, 10.0}, {"moment_max", 1.0, 0.1, 10.0}}};
  const internal::Solution solution = internal::minimise(model, parameters);
  EllipseFit fit = measure(*law, solution.residuals, solution.values[0], solution.values[1]);
  internal::describe(fit.report, solution);
  const double variance = internal::residual_variance(solution);
  const std::vector<double> covariance = internal::covariance(solution, parameters, Loss::squared(), variance);
  // From the normalised plane back to unit wrenches: B = m₀·B′.
  const std::array<double, 4> jacobian{1.0, 0.0, 0.0, law->moment_ratio()};
  const std::array<internal::Quantity, 2> quantities{
      {{"force_max", fit.ellipse.force_max(), "1"}, {"moment_max", fit.ellipse.moment_max(), "1"}}};
  internal::set_estimates(fit.report, quantities, jacobian, covariance);
  return fit;
}

}  // namespace limitcurve::fit
