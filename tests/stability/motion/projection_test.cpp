// SPDX-License-Identifier: MIT
#include "projection.hpp"

#include "../here.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

namespace {

TEST(Projection, DegenerateSteps) {
  for (const Finding& finding : held_here(degenerate_steps())) {
    EXPECT_GE(finding.breaks, 4.0);
    EXPECT_EQ(finding.stands, 0.0);
  }
}

TEST(Projection, StiffnessRatios) {
  const auto findings = held_here(stiffness_ratios());
  ASSERT_EQ(findings.size(), 5U);
  // 13.4 % where the paper's method is at its best, and no wrench of friction's a decade away.
  EXPECT_NEAR(findings[1].breaks, 0.134, 0.001);
  for (const std::size_t i : {0U, 2U, 3U}) EXPECT_GE(findings[i].breaks, 0.3) << findings[i].quantity;
  EXPECT_GE(findings[4].breaks, 0.5);
  for (const Finding& finding : findings) EXPECT_LE(finding.stands, 1e-7);
}

TEST(Projection, NewtonWithoutBracket) {
  for (const Finding& finding : held_here(newton_without_bracket())) {
    EXPECT_GE(finding.breaks, 0.05) << finding.quantity;
    EXPECT_EQ(finding.stands, 0.0);
  }
}

TEST(Projection, Corners) {
  const auto findings = held_here(corners());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 0.1);
  EXPECT_LE(findings[1].breaks, -0.1);
  for (const Finding& finding : findings) EXPECT_EQ(finding.stands, 0.0);
}

TEST(Projection, OrderOfLimits) {
  for (const Finding& finding : held_here(order_of_limits())) {
    EXPECT_GE(finding.breaks, 0.5) << finding.method;
    EXPECT_LE(finding.stands, 2e-8);
  }
}

TEST(Projection, Chatter) {
  const auto findings = held_here(chatter());
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_NEAR(findings[0].breaks, 1.0, 0.06);
  EXPECT_LE(findings[0].stands, 1e-12);
  // k v/((μ_s − μ_d)P), to a step of twenty.
  EXPECT_NEAR(findings[1].breaks, 50.0, 5.0);
  EXPECT_EQ(findings[1].stands, 0.0);
  EXPECT_GE(findings[2].breaks, 0.03);
  EXPECT_LE(findings[2].stands, 0.005);
}

TEST(Projection, CollapsingLoad) {
  for (const Finding& finding : held_here(collapsing_load())) {
    EXPECT_GE(finding.breaks, 100.0);
    EXPECT_NEAR(finding.stands, 1.0, 1e-12);
  }
}

}  // namespace

}  // namespace limitcurve::stability
