// SPDX-License-Identifier: MIT
#include "fit/curve_fit.hpp"

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
};

/// Points of the exact curve in the normalised plane, by the extended-precision evaluator.
std::vector<Point> exact_points(const Law& law, std::size_t count) {
  std::vector<Point> points;
  const double moment_ratio = law->moment_ratio();
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = std::acos(0.0) * static_cast<double>(i) / static_cast<double>(count - 1);
    const WrenchEstimate exact = law->evaluate(i + 1 == count ? std::numeric_limits<double>::infinity() : std::tan(angle));
    points.push_back({exact.wrench.force, exact.wrench.moment / moment_ratio});
  }
  return points;
}

using Gauge = std::function<double(Point, const std::vector<double>&)>;

double sum_of_squares(const std::vector<Point>& points, const Gauge& gauge, const std::vector<double>& parameters) {
  double sum = 0.0;
  for (const Point& point : points) sum += std::pow(1.0 / gauge(point, parameters) - 1.0, 2);
  return sum;
}

double largest_error(const std::vector<Point>& points, const Gauge& gauge, const std::vector<double>& parameters) {
  double largest = 0.0;
  for (const Point& point : points) largest = std::fmax(largest, std::fabs(1.0 / gauge(point, parameters) - 1.0));
  return largest;
}

/// Compass search with diagonals: no derivatives, nothing of the module.
std::vector<double> brute_force(const std::function<double(const std::vector<double>&)>& cost, std::vector<double> at, double finest) {
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

const Gauge ellipse_gauge = [](Point p, const std::vector<double>& axes) { return std::hypot(p.x / axes[0], p.y / axes[1]); };
const Gauge superellipse_gauge = [](Point p, const std::vector<double>& n) {
  return std::pow(std::pow(p.x, n[0]) + std::pow(p.y, n[0]), 1.0 / n[0]);
};
const Gauge quartic_gauge = [](Point p, const std::vector<double>& kappa) {
  return std::pow(std::pow(p.x, 4) + std::pow(p.y, 4) + kappa[0] * p.x * p.x * p.y * p.y, 0.25);
};

TEST(CurveFit, EllipseThroughTheInterceptsOverEstimatesByThePublishedAmounts) {
  const std::vector<std::pair<Law, double>> known{{flat_punch(), 0.0826}, {uniform(), 0.0704}, {hertz(), 0.0638}, {parabolic(), 0.0597}};
  for (const auto& [law, over] : known) {
    const CurveFit<Ellipse> fit = fit_ellipse(law, Criterion::intercepts);
    EXPECT_NEAR(fit.error.max_over_estimate, over, 6e-5) << law->name();
    EXPECT_EQ(fit.report.at("moment_max").value, law->moment_ratio());
    EXPECT_EQ(fit.report.at("force_max").std_error, 0.0);
  }
}

TEST(CurveFit, EllipseLeastSquaresIsTheMinimumThatBruteForceFinds) {
  for (const Law& law : {flat_punch(), uniform(), hertz(), parabolic(), cone()}) {
    const std::vector<Point> points = exact_points(law, 91);
    const CurveFit<Ellipse> fit = fit_ellipse(law, Criterion::least_squares, 91);
    EXPECT_TRUE(fit.report.converged) << fit.report.message;
    const auto best = brute_force([&](const auto& axes) { return sum_of_squares(points, ellipse_gauge, axes); }, {1.0, 1.0}, 1e-9);
    EXPECT_NEAR(fit.boundary.force_max(), best[0], 1e-7) << law->name();
    EXPECT_NEAR(fit.boundary.moment_max() / law->moment_ratio(), best[1], 1e-7) << law->name();
    EXPECT_NEAR(fit.report.rms, std::sqrt(sum_of_squares(points, ellipse_gauge, best) / 91), 1e-12) << law->name();
    EXPECT_GT(fit.report.at("force_max").std_error, 0.0);
  }
}

TEST(CurveFit, EllipseMinimaxIsTheMinimumThatBruteForceFinds) {
  for (const Law& law : {flat_punch(), uniform(), hertz(), parabolic()}) {
    const std::vector<Point> points = exact_points(law, 2001);
    const CurveFit<Ellipse> fit = fit_ellipse(law, Criterion::minimax);
    const auto best = brute_force([&](const auto& axes) { return largest_error(points, ellipse_gauge, axes); }, {0.97, 0.96}, 1e-8);
    EXPECT_NEAR(fit.error.max_error, largest_error(points, ellipse_gauge, best), 1e-6) << law->name();
    EXPECT_NEAR(fit.boundary.force_max(), best[0], 1e-5) << law->name();
    EXPECT_NEAR(fit.error.max_over_estimate, fit.error.max_under_estimate, 1e-9) << law->name();
  }
}

TEST(CurveFit, InnerAndOuterEllipsesDoNotCrossTheCurve) {
  for (const Law& law : {flat_punch(), uniform(), hertz()}) {
    EXPECT_LE(fit_ellipse(law, Criterion::inner).error.max_over_estimate, 1e-9) << law->name();
    EXPECT_LE(fit_ellipse(law, Criterion::outer).error.max_under_estimate, 1e-9) << law->name();
  }
}

TEST(CurveFit, ShapesOfOneParameterGiveThePublishedMinimax) {
  EXPECT_NEAR(fit_superellipse(hertz(), Criterion::minimax).report.at("exponent").value, 1.725, 5e-4);
  EXPECT_NEAR(fit_superellipse(uniform(), Criterion::minimax).report.at("exponent").value, 1.702, 5e-4);
  EXPECT_NEAR(fit_quartic(hertz(), Criterion::minimax).report.at("kappa").value, 3.142, 5e-4);
  EXPECT_NEAR(fit_quartic(uniform(), Criterion::minimax).report.at("kappa").value, 3.261, 5e-4);
}

TEST(CurveFit, ShapesOfOneParameterLeastSquaresIsTheMinimumThatBruteForceFinds) {
  for (const Law& law : {flat_punch(), uniform(), hertz(), parabolic(), cone()}) {
    const std::vector<Point> points = exact_points(law, 91);
    const auto super = brute_force([&](const auto& n) { return sum_of_squares(points, superellipse_gauge, n); }, {2.0}, 1e-9);
    EXPECT_NEAR(fit_superellipse(law, Criterion::least_squares, 91).boundary.exponent(), super[0], 1e-6) << law->name();
    const auto quartic = brute_force([&](const auto& kappa) { return sum_of_squares(points, quartic_gauge, kappa); }, {2.0}, 1e-9);
    EXPECT_NEAR(fit_quartic(law, Criterion::least_squares, 91).boundary.kappa(), quartic[0], 1e-6) << law->name();
  }
}

TEST(CurveFit, RefusesWhatItCannotDo) {
  EXPECT_THROW(fit_ellipse(hertz(), Criterion::least_squares, 2), std::invalid_argument);
  EXPECT_THROW(fit_superellipse(hertz(), Criterion::inner), std::invalid_argument);
  EXPECT_THROW(fit_quartic(hertz(), Criterion::intercepts), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve::fit
