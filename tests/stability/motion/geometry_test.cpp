// SPDX-License-Identifier: MIT
#include "geometry.hpp"

#include "../here.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

namespace {

TEST(Geometry, ThinPlate) {
  const auto findings = held_here(thin_plate());
  ASSERT_EQ(findings.size(), 2U);
  for (const Finding& finding : findings) {
    EXPECT_GE(finding.breaks, 1.0);
    // Meshes lie on a grid.
    EXPECT_NEAR(finding.stands, 0.0, 1e-9) << finding.method;
  }
}

TEST(Geometry, SideAtAVertex) {
  for (const Finding& finding : held_here(side_at_a_vertex())) {
    EXPECT_GE(finding.breaks, 0.05);
    EXPECT_EQ(finding.stands, 0.0);
  }
}

TEST(Geometry, BrokenMeshes) {
  const auto findings = held_here(broken_meshes());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 4.0);
  EXPECT_EQ(findings[0].stands, 0.0);
  EXPECT_GE(findings[1].stands, 4.0);
}

TEST(Geometry, Slivers) {
  for (const Finding& finding : held_here(slivers())) {
    EXPECT_GE(finding.breaks, 1.0);
    EXPECT_LE(finding.stands, 0.05);
  }
}

TEST(Geometry, NormalsThatJump) {
  for (const Finding& finding : held_here(normals_that_jump())) {
    EXPECT_GE(finding.breaks, 0.5);
    EXPECT_LE(finding.stands, 1e-12);
  }
}

}  // namespace

}  // namespace limitcurve::stability
