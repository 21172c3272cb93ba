// SPDX-License-Identifier: MIT
// Minima on a bound, where Ceres alone may stop early and say that it converged: against a search along the bound.
#include "fit/internal/least_squares.hpp"

#include <gtest/gtest.h>
#include <boost/math/tools/minima.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace limitcurve::fit::internal::test {

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// Residuals r(x, y) with derivatives by central differences.
class Problem final : public ResidualModel {
 public:
  using Residuals = std::function<std::vector<double>(double, double)>;
  explicit Problem(Residuals residuals) : residuals_(std::move(residuals)) {}
  std::size_t count() const noexcept override { return residuals_(0.0, 0.0).size(); }
  bool evaluate(std::size_t i, std::span<const double> p, double& residual, double* gradient) const override {
    constexpr double h = 1e-6;
    residual = residuals_(p[0], p[1])[i];
    if (gradient == nullptr) return true;
    gradient[0] = (residuals_(p[0] + h, p[1])[i] - residuals_(p[0] - h, p[1])[i]) / (2 * h);
    gradient[1] = (residuals_(p[0], p[1] + h)[i] - residuals_(p[0], p[1] - h)[i]) / (2 * h);
    return true;
  }
  double cost(double x, double y) const {
    double sum = 0.0;
    for (const double residual : residuals_(x, y)) sum += 0.5 * residual * residual;
    return sum;
  }

 private:
  Residuals residuals_;
};

/// The least cost with x on its upper bound.
double least_on_bound(const Problem& problem, double bound) {
  return boost::math::tools::brent_find_minima([&](double y) { return problem.cost(bound, y); }, -50.0, 50.0, 52)
      .second;
}

void expect_least(const Problem& problem, double start_x, double start_y, double bound) {
  const Parameter parameters[] = {{"x", start_x, -inf, bound}, {"y", start_y, -inf, inf}};
  const Solution solution = minimise(problem, parameters);
  EXPECT_EQ(solution.values[0], bound);
  EXPECT_TRUE(solution.converged) << solution.message;
  EXPECT_NEAR(solution.cost, least_on_bound(problem, bound), 1e-9 * solution.cost);
}

}  // namespace

TEST(Minimise, ReachesTheMinimumOnABound) {
  const Problem rosenbrock([](double x, double y) { return std::vector{10 * (y - x * x), 1 - x}; });
  for (const double bound : {-0.5, 0.1, 0.5, 0.9}) {
    for (const double start : {-1.2, -3.0, 0.0}) expect_least(rosenbrock, start, 1.0, bound);
  }
}

TEST(Minimise, ReachesTheMinimumOnABoundOfRandomDecays) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> measured;
    for (int i = 0; i < 20; ++i) measured.push_back(std::exp(0.1 * i * 0.5) * 2.0 + noise(random));
    // The true exponent is 0.5, beyond the bound.
    const Problem decay([&](double exponent, double scale) {
      std::vector<double> residuals;
      for (int i = 0; i < 20; ++i)
        residuals.push_back(scale * std::exp(0.1 * i * exponent) - measured[static_cast<std::size_t>(i)]);
      return residuals;
    });
    expect_least(decay, -2.0, 0.1, 0.3);
  }
}

TEST(Minimise, LeavesABoundThatItStartsFrom) {
  const Problem line([](double x, double y) { return std::vector{x - 1, y - x}; });
  const Parameter parameters[] = {{"x", 2.0, -inf, 2.0}, {"y", 0.0, -inf, inf}};
  const Solution solution = minimise(line, parameters);
  EXPECT_TRUE(solution.converged);
  EXPECT_NEAR(solution.values[0], 1.0, 1e-9);
  EXPECT_NEAR(solution.values[1], 1.0, 1e-9);
}

}  // namespace limitcurve::fit::internal::test
