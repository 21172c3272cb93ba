// SPDX-License-Identifier: MIT
#include "projection.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace limitcurve::stability {

namespace {

// What docs/paper.md says of eq. (23) and of the c-curve: 0.255 N, and 0.438, 0.416, 0.4135 N in steps
// of 100, 10, 1 µm, where eq. (17) has 0.487 N.
TEST(Projection, GrowingRadius) {
  const auto findings = growing_radius().findings;
  ASSERT_EQ(findings.size(), 4U);
  constexpr std::array printed{std::pair{0.255, 0.0005}, std::pair{0.416, 0.0005}, std::pair{0.438, 0.0005}, std::pair{0.4135, 0.0005}};
  // (3π/8)s(1 − s²/4), s = 5/6.
  const double s = 5.0 / 6.0;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    EXPECT_NEAR(findings[i].breaks, printed[i].first, printed[i].second);
    EXPECT_NEAR(findings[i].stands, 0.6 * 3.0 * std::numbers::pi / 8.0 * s * (1.0 - 0.25 * s * s), 1e-7);
  }
}

}  // namespace

}  // namespace limitcurve::stability
