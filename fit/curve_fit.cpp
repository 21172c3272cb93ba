// SPDX-License-Identifier: MIT
#include "fit/curve_fit.hpp"

#include "fit/internal/curve_points.hpp"
#include "fit/internal/least_squares.hpp"
#include "fit/internal/report.hpp"
#include "limitcurve/exact_curve.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>

namespace limitcurve::fit {

namespace {

using internal::CurvePoint;

/// Each residual is a radial error times the point's weight. With the ellipse's gauge γ = √((x/A)² + (y/B)²) of a curve point (x, y), the
/// radial error is e = 1/γ − 1 and
///   ∂e/∂A = x²/(A³γ³),  ∂e/∂B = y²/(B³γ³).
class EllipseResiduals final : public internal::ResidualModel {
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

/// Superellipse: with S = xⁿ + yⁿ, γ = S^{1/n}, e = 1/γ − 1 and
///   ∂e/∂n = (1/γ)[ln S/n² − (xⁿ ln x + yⁿ ln y)/(n S)].
class SuperellipseResiduals final : public internal::ResidualModel {
 public:
  explicit SuperellipseResiduals(const std::vector<CurvePoint>& points) : points_(points) {}
  std::size_t count() const noexcept override { return points_.size(); }
  bool evaluate(std::size_t i, std::span<const double> parameters, double& residual, double* gradient) const override {
    const double n = parameters[0];
    const double x = std::pow(points_[i].x, n);
    const double y = std::pow(points_[i].y, n);
    const double sum = x + y;
    const double inverse = std::pow(sum, -1.0 / n);
    residual = points_[i].weight * (inverse - 1.0);
    if (gradient != nullptr) {
      const auto entropy = [](double power, double base) { return base > 0.0 ? power * std::log(base) : 0.0; };
      gradient[0] =
          points_[i].weight * inverse * (std::log(sum) / (n * n) - (entropy(x, points_[i].x) + entropy(y, points_[i].y)) / (n * sum));
    }
    return true;
  }

 private:
  const std::vector<CurvePoint>& points_;
};

/// Quartic: γ⁴ = x⁴ + y⁴ + κx²y², e = 1/γ − 1 and ∂e/∂κ = −x²y²/(4γ⁵).
class QuarticResiduals final : public internal::ResidualModel {
 public:
  explicit QuarticResiduals(const std::vector<CurvePoint>& points) : points_(points) {}
  std::size_t count() const noexcept override { return points_.size(); }
  bool evaluate(std::size_t i, std::span<const double> parameters, double& residual, double* gradient) const override {
    const double x = points_[i].x * points_[i].x;
    const double y = points_[i].y * points_[i].y;
    const double fourth = x * x + y * y + parameters[0] * x * y;
    if (!(fourth > 0.0)) return false;
    const double inverse = 1.0 / std::sqrt(std::sqrt(fourth));
    residual = points_[i].weight * (inverse - 1.0);
    if (gradient != nullptr) gradient[0] = -points_[i].weight * x * y * inverse / (4.0 * fourth);
    return true;
  }

 private:
  const std::vector<CurvePoint>& points_;
};

std::vector<double> residuals_at(const internal::ResidualModel& model, std::span<const double> parameters) {
  std::vector<double> residuals(model.count());
  for (std::size_t i = 0; i < residuals.size(); ++i) model.evaluate(i, parameters, residuals[i], nullptr);
  return residuals;
}

/// Sets the estimates. Their standard errors have no meaning: what the residuals show is the difference of two curves, not noise.
void set_estimates(FitReport& report, std::initializer_list<internal::Quantity> quantities) {
  for (const internal::Quantity& quantity : quantities) {
    report.estimates.push_back({quantity.name, quantity.value, std::numeric_limits<double>::quiet_NaN(), quantity.unit});
  }
  report.correlation.assign(quantities.size() * quantities.size(), 0.0);
}

/// The report of parameters in closed form.
FitReport direct_report(const internal::ResidualModel& model, std::span<const double> parameters, const char* message) {
  FitReport report;
  const std::vector<double> residuals = residuals_at(model, parameters);
  report.residuals = residuals.size();
  report.rms = internal::root_mean_square(residuals);
  report.converged = true;
  report.message = message;
  return report;
}

std::string note_of(const Law& law, Criterion criterion) {
  return std::string(to_string(criterion)) + " to the exact curve of " + law->name();
}

/// A shape through the intercepts with one parameter `name`, by least squares or minimax.
template <class Curve, class MakeCurve, class Minimax>
CurveFit<Curve> fit_shape(const Law& law, Criterion criterion, const internal::ResidualModel& model, const internal::Parameter& shape,
                          MakeCurve make, Minimax minimax) {
  const ExactCurve exact(law);
  double value = 0.0;
  FitReport report;
  if (criterion == Criterion::least_squares) {
    const std::array<internal::Parameter, 1> parameters{shape};
    const internal::Solution solution = internal::minimise(model, parameters);
    value = solution.values[0];
    internal::describe(report, solution);
  } else if (criterion == Criterion::minimax) {
    value = minimax(exact);
    report = direct_report(model, std::array{value}, "minimax: extremes of the error of equal size");
  } else {
    throw std::invalid_argument(std::string("criterion '") + to_string(criterion) +
                                "' is not one this shape has: expected least-squares or minimax");
  }
  const Curve curve = make(exact.moment_ratio(), value);
  set_estimates(report, {{"force_max", 1.0, "1"}, {"moment_max", exact.moment_ratio(), "1"}, {shape.name, value, "1"}});
  report.note = note_of(law, criterion);
  return {curve, curve_error(curve, exact), std::move(report)};
}

}  // namespace

const char* to_string(Criterion criterion) noexcept {
  switch (criterion) {
    case Criterion::intercepts:
      return "intercepts";
    case Criterion::least_squares:
      return "least-squares";
    case Criterion::minimax:
      return "minimax";
    case Criterion::inner:
      return "inner";
    case Criterion::outer:
      return "outer";
  }
  return "";
}

CurveFit<Ellipse> fit_ellipse(const Law& law, Criterion criterion, std::size_t points) {
  const std::vector<CurvePoint> curve = internal::curve_points(*law, points);
  const EllipseResiduals model(curve);
  const ExactCurve exact(law);
  const double moment_ratio = exact.moment_ratio();
  Ellipse ellipse = Ellipse::through_intercepts(moment_ratio);
  FitReport report;
  const char* message = "through the intercepts: nothing to iterate";
  switch (criterion) {
    case Criterion::intercepts:
      break;
    case Criterion::least_squares: {
      const std::array<internal::Parameter, 2> parameters{{{"force_max", 1.0, 0.1, 10.0}, {"moment_max", 1.0, 0.1, 10.0}}};
      const internal::Solution solution = internal::minimise(model, parameters);
      ellipse = Ellipse(solution.values[0], solution.values[1] * moment_ratio);
      internal::describe(report, solution);
      break;
    }
    case Criterion::minimax: {
      // The error of the intercept ellipse is 0 at both ends and e₀ > 0 at its one maximum between. Scaled by 1 − E it is −E, +E, −E:
      // equal in size and alternating three times for two parameters, hence minimax, if (1−E)(1+e₀) = 1 + E.
      const double largest = curve_error(ellipse, exact).max_over_estimate;
      const double shrink = 1.0 - largest / (2.0 + largest);
      ellipse = Ellipse(shrink, shrink * moment_ratio);
      message = "minimax: extremes of the error of equal size";
      break;
    }
    case Criterion::inner:
      ellipse = inner_ellipse(exact);
      message = "largest area inside the curve";
      break;
    case Criterion::outer:
      ellipse = outer_ellipse(exact);
      message = "smallest area around the curve";
      break;
  }
  if (criterion != Criterion::least_squares) {
    report = direct_report(model, std::array{ellipse.force_max(), ellipse.moment_max() / moment_ratio}, message);
  }
  set_estimates(report, {{"force_max", ellipse.force_max(), "1"}, {"moment_max", ellipse.moment_max(), "1"}});
  report.note = note_of(law, criterion);
  return {ellipse, curve_error(ellipse, exact), std::move(report)};
}

CurveFit<Superellipse> fit_superellipse(const Law& law, Criterion criterion, std::size_t points) {
  const std::vector<CurvePoint> curve = internal::curve_points(*law, points);
  return fit_shape<Superellipse>(law, criterion, SuperellipseResiduals(curve), {"exponent", 1.8, 1.01, 100.0},
                                 Superellipse::through_intercepts,
                                 [](const ExactCurve& exact) { return minimax_superellipse(exact).exponent(); });
}

CurveFit<Quartic> fit_quartic(const Law& law, Criterion criterion, std::size_t points) {
  const std::vector<CurvePoint> curve = internal::curve_points(*law, points);
  return fit_shape<Quartic>(law, criterion, QuarticResiduals(curve), {"kappa", 3.0, 0.0, 6.0}, Quartic::through_intercepts,
                            [](const ExactCurve& exact) { return minimax_quartic(exact).kappa(); });
}

}  // namespace limitcurve::fit
