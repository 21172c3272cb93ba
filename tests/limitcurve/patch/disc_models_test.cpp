// SPDX-License-Identifier: MIT
#include "limitcurve/patch/disc_models.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "patch_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace limitcurve::test {
namespace {

// What docs/which_number.md advises for engines without a moment at a point. The limit is weakest where a ball does not move.
TEST(DiscModels, ThreeBallsAreUpTo13PercentTooWeak) {
  const ExactCurve hertz_curve(hertz());
  const double m0 = hertz_curve.moment_ratio();
  const double half = m0 * std::sqrt(3.0) / 2.0;
  const Patch balls = Patch::points(std::vector<PatchLoad>{{m0, 0.0, 1.0}, {-m0 / 2.0, half, 1.0}, {-m0 / 2.0, -half, 1.0}});
  const auto gauge = [&](const PatchTwist& twist) {
    const PatchWrench wrench = balls.wrench(twist);
    return hertz_curve.gauge({std::hypot(wrench.fx, wrench.fy), std::fabs(wrench.moment)});
  };
  EXPECT_NEAR(gauge(about({m0, 0.0})), 1.0 - 0.13, 0.005);
  for (const PatchTwist& twist : twists(m0, 20000, -1.0, 1.0)) {
    EXPECT_GT(gauge(twist), 1.0 - 0.135);
    EXPECT_LT(gauge(twist), 1.01);
  }
}

// The over-estimate has a sharp maximum where the COR is on a point that bears much of the load: there H lacks that point's term.
TEST(DiscModels, OfPointsAreTriedWithTheCorOnEachPoint) {
  std::mt19937 bits(7);
  const auto uniform = [&bits] { return std::generate_canonical<double, 53>(bits); };
  for (std::size_t set = 0; set < 3; ++set) {
    std::vector<PatchLoad> loads(3 + set);
    for (PatchLoad& point : loads) point = {uniform(), uniform(), 0.1 + uniform()};
    const auto [mx, my] = set % 2 == 0 ? std::pair{1.0, 1.0} : std::pair{1.7, 0.6};
    const Patch patch = Patch::points(loads).orthotropic(mx, my);
    const DiscModel ellipsoid = disc_models(patch).back();
    ASSERT_EQ(ellipsoid.name, "ellipsoid");
    for (const PatchLoad& point : loads) {
      const PatchPoint cor{point.x - patch.centre().x, point.y - patch.centre().y};
      const double there = std::hypot(mx * cor.y, my * cor.x, patch.moment_ratio()) / patch.power(about(cor)) - 1.0;
      EXPECT_GE(ellipsoid.error.max_over_estimate, there - 1e-9) << set;
    }
  }
}

}  // namespace
}  // namespace limitcurve::test
