// SPDX-License-Identifier: MIT
#include "turns.hpp"

#include "../here.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

namespace {

TEST(Turns, HalfATurn) {
  const auto findings = held_here(half_a_turn());
  ASSERT_EQ(findings.size(), 3U);
  for (const Finding& finding : findings) {
    // More than the limit: it pushes the user forward instead of resisting.
    EXPECT_GE(finding.breaks, 1.0) << finding.method;
    EXPECT_LE(finding.stands, 1e-12) << finding.quantity;
  }
}

TEST(Turns, TenThousandTurns) {
  const auto findings = held_here(ten_thousand_turns());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 1.0);
  EXPECT_GE(findings[1].breaks, 2.0 * findings[1].stands);
  for (const Finding& finding : findings) EXPECT_LE(finding.stands, 1e-7);
}

}  // namespace

}  // namespace limitcurve::stability
