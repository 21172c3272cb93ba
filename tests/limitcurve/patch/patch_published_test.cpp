// SPDX-License-Identifier: MIT
// Values of contacts that are not round that others printed, each with its source.
#include "limitcurve/patch/patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace limitcurve::test {
namespace {

// Goyal, Ruina, Papadopoulos, Wear 143:307, 1991: of two equal points ("dumbbell") the section of
// the limit surface along their line is an ellipse, the one across it a diamond.
TEST(PatchPublished, ADumbbellHasAnEllipseAndADiamond) {
  const Patch dumbbell = Patch::points(std::vector<PatchLoad>{{-1.0, 0.0, 1.0}, {1.0, 0.0, 1.0}});
  for (const double slide : {0.3, 1.0, 4.0}) {
    const PatchWrench along = dumbbell.wrench({slide, 0.0, 1.0});
    EXPECT_NEAR(std::hypot(along.fx, along.moment), 1.0, 1e-15);
    const PatchWrench across = dumbbell.wrench({0.0, slide + 0.1, 1.0});
    EXPECT_NEAR(std::fabs(across.fy) + std::fabs(across.moment), 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace limitcurve::test
