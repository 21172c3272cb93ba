// SPDX-License-Identifier: MIT
#include "fit/friction_fit.hpp"

#include "limitcurve/laws.hpp"
#include "tests/complaint.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <vector>

namespace limitcurve::fit {

namespace {

// Pushes of a disc whose coefficient grows with the share of spin, and scatters: the line through them by Eigen's least
// squares.
TEST(FrictionFit, MeanAndDriftAreThoseOfALine) {
  constexpr double load = 5.0;
  const Patch patch = Patch::ellipse(hertz(), 0.01, 0.01);
  const double m0 = patch.moment_ratio();
  constexpr std::array shares{0.0, 0.2, 0.4, 0.6, 0.8};
  constexpr std::array coefficients{0.30, 0.33, 0.31, 0.36, 0.35};
  std::vector<Push> pushes;
  Eigen::Matrix<double, 5, 2> places;
  Eigen::Matrix<double, 5, 1> found;
  for (Eigen::Index i = 0; i < 5; ++i) {
    const double share = shares[static_cast<std::size_t>(i)];
    const double mu = coefficients[static_cast<std::size_t>(i)];
    const PatchTwist twist{std::sqrt(1.0 - share * share), 0.0, share / m0};
    PatchWrench wrench = patch.evaluate(twist).wrench;
    wrench = {mu * load * wrench.fx, mu * load * wrench.fy, mu * load * wrench.moment};
    pushes.push_back({wrench, twist});
    places.row(i) << 1.0, share;
    found[i] = mu;
  }
  const Eigen::Vector2d line = places.colPivHouseholderQr().solve(found);
  const double variance = (found - places * line).squaredNorm() / 3.0;
  const double slope_error = std::sqrt(variance * (places.transpose() * places).inverse()(1, 1));

  const std::vector<Estimate> estimates = fit_friction(patch, pushes, load, "1").estimates;
  ASSERT_EQ(estimates.size(), 4U);
  EXPECT_NEAR(estimates[0].value, found.mean(), 1e-12);
  EXPECT_NEAR(estimates[0].std_error, std::sqrt((found.array() - found.mean()).square().sum() / 4.0 / 5.0), 1e-12);
  EXPECT_NEAR(estimates[1].value, line[1] / found.mean(), 1e-10);
  EXPECT_NEAR(estimates[1].std_error, slope_error / found.mean(), 1e-10);

  const auto refused = [&](double under, const char* told) {
    test::expect_mention(test::complaint([&] { (void)fit_friction(patch, pushes, under, "1"); }), told);
  };
  for (const double under : {0.0, -5.0, std::nan(""), HUGE_VAL}) refused(under, "load = ");
  pushes[3].row = 17;
  pushes[3].wrench.fx = std::nan("");
  refused(load, "push 17: expected finite numbers");
  pushes[3] = {{1.0, 0.0, 0.0}, {}};
  refused(load, "push 4: no displacement");
}

}  // namespace

}  // namespace limitcurve::fit
