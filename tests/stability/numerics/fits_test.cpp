// SPDX-License-Identifier: MIT
#include "fits.hpp"

#include "../here.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

namespace {

TEST(Fits, CorNearTheAxes) {
  const auto findings = held_here(cor_near_the_axes());
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_NEAR(findings[0].breaks, 0.85, 0.01);  // of the ellipse
  EXPECT_GE(findings[1].breaks, 1.0);           // of the superellipse, without bound
  EXPECT_GE(findings[2].breaks, 0.05);          // of the quartic
  for (const Finding& finding : findings) EXPECT_LE(finding.stands, 1e-3);
}

TEST(Fits, DyingTails) {
  const auto findings = held_here(dying_tails());
  ASSERT_EQ(findings.size(), 3U);
  // In the fitted range it is as good as such fits usually are.
  EXPECT_LE(findings[0].breaks, 0.02);
  EXPECT_GE(findings[1].breaks, 0.9);
  EXPECT_GE(findings[2].breaks, 0.5);
  for (const Finding& finding : findings) EXPECT_LE(finding.stands, 0.02) << finding.quantity;
}

TEST(Fits, ShapeAndRadius) {
  const auto findings = held_here(shape_and_radius());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 0.05);
  EXPECT_LE(findings[0].stands, 0.01);
  EXPECT_GE(findings[1].breaks, 20.0);
  // Correct intervals: 1.96 for a normal estimate, more only within the scatter of 120 sets.
  EXPECT_LE(findings[1].stands, 3.0);
}

}  // namespace

}  // namespace limitcurve::stability
