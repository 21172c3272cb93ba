// SPDX-License-Identifier: MIT
#include "tables.hpp"

#include "../here.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

namespace {

TEST(Tables, EvenSpacing) {
  const auto findings = held_here(even_spacing());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 1e-4);
  EXPECT_LE(findings[0].stands, 1e-8);
  // Even thirty times the nodes are not enough.
  EXPECT_GE(findings[1].breaks, 1e-6);
}

TEST(Tables, BeyondTheLastNode) {
  const auto findings = held_here(beyond_the_last_node());
  ASSERT_EQ(findings.size(), 4U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GE(findings[i].breaks, 10.0) << findings[i].method;
    // A table states absolute errors; its exact ends keep the relative errors small.
    EXPECT_LE(findings[i].stands, 1e-5) << findings[i].method;
  }
  EXPECT_GE(findings[3].breaks, 0.01);
  EXPECT_EQ(findings[3].stands, 0.0);
}

TEST(Tables, FalseEquilibria) {
  const auto findings = held_here(false_equilibria());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 2.0);
  EXPECT_EQ(findings[0].stands, 1.0);
  EXPECT_GE(findings[1].breaks, 1e-3);
  EXPECT_EQ(findings[1].stands, 0.0);
}

}  // namespace

}  // namespace limitcurve::stability
