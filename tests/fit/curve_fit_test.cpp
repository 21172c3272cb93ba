// SPDX-License-Identifier: MIT
#include "fit/curve_fit.hpp"

#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace limitcurve::fit {
namespace {

struct Point {
  double x;
  double y;
  double share;  ///< of the rays
};

/// Points of the exact curve in the normalised plane, by the extended-precision evaluator.
std::vector<Point> exact_points(const Law& law, std::size_t count) {
  std::vector<Point> points;
  const double moment_ratio = law->moment_ratio();
  const double quarter_turn = std::acos(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = quarter_turn * static_cast<double>(i) / static_cast<double>(count - 1);
    const WrenchEstimate exact =
        law->evaluate(i + 1 == count ? std::numeric_limits<double>::infinity() : moment_ratio * std::tan(angle));
    points.push_back({exact.wrench.force, exact.wrench.moment / moment_ratio, 0.0});
  }
  for (std::size_t i = 1; i < count; ++i) {
    const double half =
        0.5 * (std::atan2(points[i].x, points[i].y) - std::atan2(points[i - 1].x, points[i - 1].y)) / quarter_turn;
    points[i - 1].share += half;
    points[i].share += half;
  }
  return points;
}

using Gauge = std::function<double(Point, const std::vector<double>&)>;

double mean_square(const std::vector<Point>& points, const Gauge& gauge, const std::vector<double>& parameters) {
  double sum = 0.0;
  for (const Point& point : points) sum += point.share * std::pow(1.0 / gauge(point, parameters) - 1.0, 2);
  return sum;
}

double largest_error(const std::vector<Point>& points, const Gauge& gauge, const std::vector<double>& parameters) {
  double largest = 0.0;
  for (const Point& point : points) largest = std::fmax(largest, std::fabs(1.0 / gauge(point, parameters) - 1.0));
  return largest;
}

/// Compass search with diagonals: no derivatives, nothing of the module.
std::vector<double> brute_force(const std::function<double(const std::vector<double>&)>& cost, std::vector<double> at,
                                double finest) {
  double best = cost(at);
  for (double step = 0.05; step > finest;) {
    bool improved = false;
    const int directions = at.size() == 1 ? 3 : 9;
    for (int k = 0; k < directions; ++k) {
      std::vector<double> candidate = at;
      candidate[0] += step * (k % 3 - 1);
      if (at.size() > 1) candidate[1] += step * (k / 3 - 1);
      const double value = cost(candidate);
      if (value >= best) continue;
      best = value;
      at = candidate;
      improved = true;
      break;
    }
    if (!improved) step /= 2.0;
  }
  return at;
}

const Gauge ellipse_gauge = [](Point p, const std::vector<double>& axes) {
  return std::hypot(p.x / axes[0], p.y / axes[1]);
};
TEST(CurveFit, EllipseLeastSquaresIsTheMinimumThatBruteForceFinds) {
  for (const Law& law : {flat_punch(), uniform(), hertz(), parabolic(), cone()}) {
    const std::vector<Point> points = exact_points(law, 91);
    const CurveFit fit = fit_ellipse(law, Criterion::least_squares, 91);
    EXPECT_TRUE(fit.report.converged) << fit.report.message;
    const auto best =
        brute_force([&](const auto& axes) { return mean_square(points, ellipse_gauge, axes); }, {1.0, 1.0}, 1e-9);
    EXPECT_NEAR(fit.curve.force_max(), best[0], 1e-7) << law->name();
    EXPECT_NEAR(fit.curve.moment_max() / law->moment_ratio(), best[1], 1e-7) << law->name();
    EXPECT_NEAR(fit.report.rms, std::sqrt(mean_square(points, ellipse_gauge, best)), 1e-12) << law->name();
    // The residuals are the difference of two curves: no noise, hence no standard error.
    EXPECT_TRUE(std::isnan(fit.report.at("force_max").std_error));
  }
}

TEST(CurveFit, EllipseMinimaxIsTheMinimumThatBruteForceFinds) {
  for (const Law& law : {flat_punch(), uniform(), hertz(), parabolic()}) {
    const std::vector<Point> points = exact_points(law, 2001);
    const CurveFit fit = fit_ellipse(law, Criterion::minimax);
    const auto best =
        brute_force([&](const auto& axes) { return largest_error(points, ellipse_gauge, axes); }, {0.97, 0.96}, 1e-8);
    EXPECT_NEAR(fit.error.max_error, largest_error(points, ellipse_gauge, best), 1e-6) << law->name();
    EXPECT_NEAR(fit.curve.force_max(), best[0], 1e-5) << law->name();
    EXPECT_NEAR(fit.error.max_over_estimate, fit.error.max_under_estimate, 1e-9) << law->name();
  }
  // This curve bulges out of the ellipse through the intercepts; brute force stops at a ridge, a
  // little above the minimum.
  const std::vector<Point> points = exact_points(xydas_kao(0.2), 2001);
  const double found = largest_error(
      points, ellipse_gauge,
      brute_force([&](const auto& axes) { return largest_error(points, ellipse_gauge, axes); }, {1.0, 1.0}, 1e-8));
  const CurveError error = fit_ellipse(xydas_kao(0.2), Criterion::minimax).error;
  EXPECT_LT(error.max_error, found);
  EXPECT_NEAR(error.max_over_estimate, error.max_under_estimate, 1e-9);
}

TEST(CurveFit, TheInnerEllipseDoesNotCrossTheCurve) {
  for (const Law& law : {flat_punch(), uniform(), hertz()}) {
    EXPECT_LE(fit_ellipse(law, Criterion::inner).error.max_over_estimate, 1e-9) << law->name();
  }
}

/// The fit minimises the reported error, whatever the law and its unit of length.
TEST(CurveFit, NoNeighbourHasALesserReportedError) {
  for (const char* text :
       {"hertz", "flat-punch", "cone", "power:n=-0.95", "power:n=20", "power:n=1000", "xydas-kao:k=0.2",
        "xydas-kao:k=20", "gaussian:sigma=1", "gaussian:sigma=1e-3", "mix:0.9*power:n=500+0.1*flat-punch"}) {
    const Law law = parse_law(text);
    const ExactCurve exact(law);
    const double m0 = exact.moment_ratio();
    const auto ellipse = fit_ellipse(law);
    // Reported from other points than were fitted: equal to a few millionths.
    EXPECT_NEAR(ellipse.report.rms, ellipse.error.rms_error, 1e-5) << text;
    constexpr double rounding = 1e-7;
    for (const double step : {-0.01, -0.002, 0.002, 0.01}) {
      const double force = ellipse.curve.force_max();
      const double moment = ellipse.curve.moment_max();
      EXPECT_GT(curve_error(Ellipse(force + step, moment), exact).rms_error, ellipse.error.rms_error - rounding)
          << text;
      EXPECT_GT(curve_error(Ellipse(force, moment + step * m0), exact).rms_error, ellipse.error.rms_error - rounding)
          << text;
    }
  }
}

TEST(CurveFit, RefusesWhatItCannotDo) {
  EXPECT_THROW(fit_ellipse(hertz(), Criterion::least_squares, 2), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::fit
