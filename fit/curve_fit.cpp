// SPDX-License-Identifier: MIT
#include "fit/curve_fit.hpp"

#include "fit/internal/curve_points.hpp"
#include "fit/internal/least_squares.hpp"
#include "fit/internal/report.hpp"
#include "limitcurve/exact_curve.hpp"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>

namespace limitcurve::fit {

using namespace internal;

namespace {

/// Each residual is a radial error times the point's weight. With the ellipse's gauge γ = √((x/A)² + (y/B)²) of a curve
/// point (x, y), the radial error is e = 1/γ − 1 and
///   ∂e/∂A = x²/(A³γ³),  ∂e/∂B = y²/(B³γ³).
class EllipseResiduals final : public ResidualModel {
 public:
  explicit EllipseResiduals(const std::vector<CurvePoint>& points) : points_(points) {}
  std::size_t count() const noexcept override { return points_.size(); }
  bool evaluate(std::size_t i, std::span<const double> parameters, double& residual, double* gradient) const override {
    const double x = points_[i].x / parameters[0];
    const double y = points_[i].y / parameters[1];
    const double inverse = 1.0 / std::sqrt(x * x + y * y);
    residual = points_[i].weight * (inverse - 1.0);
    if (gradient != nullptr) {
      const double cube = points_[i].weight * inverse * inverse * inverse;
      gradient[0] = x * x / parameters[0] * cube;
      gradient[1] = y * y / parameters[1] * cube;
    }
    return true;
  }

 private:
  const std::vector<CurvePoint>& points_;
};

std::vector<double> residuals_at(const ResidualModel& model, std::span<const double> parameters) {
  std::vector<double> residuals(model.count());
  for (std::size_t i = 0; i < residuals.size(); ++i) model.evaluate(i, parameters, residuals[i], nullptr);
  return residuals;
}

/// Sets the estimates. Their standard errors have no meaning: what the residuals show is the difference of two curves,
/// not noise.
void set_estimates(FitReport& report, std::initializer_list<Quantity> quantities) {
  for (const Quantity& quantity : quantities) {
    report.estimates.push_back(
        {quantity.name, quantity.value, std::numeric_limits<double>::quiet_NaN(), quantity.unit});
  }
  report.correlation.assign(quantities.size() * quantities.size(), 0.0);
}

/// The report of parameters in closed form.
FitReport direct_report(const ResidualModel& model, std::span<const double> parameters, const char* message) {
  FitReport report;
  const std::vector<double> residuals = residuals_at(model, parameters);
  report.residuals = residuals.size();
  report.rms = root_mean_square(residuals);
  report.converged = true;
  report.message = message;
  return report;
}

std::string note_of(const Law& law, Criterion criterion) {
  return std::string(criterion_names[static_cast<std::size_t>(criterion)]) + " to the exact curve of " + law->name();
}

}  // namespace

CurveFit fit_ellipse(const Law& law, Criterion criterion, std::size_t points) {
  const ExactCurve exact(law);
  const std::vector<CurvePoint> curve = curve_points(*law, points);
  const EllipseResiduals model(curve);
  const double moment_ratio = exact.moment_ratio();
  Ellipse ellipse = Ellipse::through_intercepts(moment_ratio);
  FitReport report;
  const char* message = "through the intercepts: nothing to iterate";
  switch (criterion) {
    case Criterion::intercepts:
      break;
    case Criterion::least_squares: {
      const std::array<Parameter, 2> parameters{{{"force_max", 1.0, 0.1, 10.0}, {"moment_max", 1.0, 0.1, 10.0}}};
      const Solution solution = minimise(model, parameters);
      ellipse = Ellipse(solution.values[0], solution.values[1] * moment_ratio);
      describe(report, solution);
      break;
    }
    case Criterion::minimax: {
      // The same shape as inside: the ratio of its largest to its smallest radius, in units of the
      // curve's, is the least. Scaled so that both errors are equal.
      ellipse = inner_ellipse(exact);
      const double scale = 2.0 / (2.0 - curve_error(ellipse, exact).max_under_estimate);
      ellipse = Ellipse(scale * ellipse.force_max(), scale * ellipse.moment_max());
      message = "minimax: extremes of the error of equal size";
      break;
    }
    case Criterion::inner:
      ellipse = inner_ellipse(exact);
      message = "inside the curve, with the least largest error";
      break;
  }
  if (criterion != Criterion::least_squares) {
    report = direct_report(model, std::array{ellipse.force_max(), ellipse.moment_max() / moment_ratio}, message);
  }
  set_estimates(report, {{"force_max", ellipse.force_max(), "1", Estimate::Role::force},
                         {"moment_max", ellipse.moment_max(), "1", Estimate::Role::moment}});
  report.note = note_of(law, criterion);
  return {ellipse, curve_error(ellipse, exact), std::move(report)};
}

}  // namespace limitcurve::fit
