// SPDX-License-Identifier: MIT
//
// A finger in Bullet, given the translated coefficients and dragged about imposed centres of rotation.
#include "tests/fit/engines/bullet_drag.hpp"

#include "limitcurve/polygon.hpp"

#include <gtest/gtest.h>

namespace limitcurve::fit::engines {
namespace {

TEST(Bullet, IsABoxWithTheExactLimits) {
  const EngineContact contact = translated("bullet", "box");
  const double moment_ratio = law()->moment_ratio();
  const Box expected = box(1.0, moment_ratio);
  for (const SlipTwist twist : twists) {
    const auto [measured, normal] = drag_in_bullet(contact, twist);
    EXPECT_NEAR(normal, load, 1e-3 * load);
    // Single precision.
    EXPECT_NEAR(measured.force, expected.wrench(twist).force, 2e-3) << "c/a = " << twist.cor();
    EXPECT_NEAR(measured.moment / moment_ratio, expected.wrench(twist).moment / moment_ratio, 2e-3) << "c/a = " << twist.cor();
  }
}

}  // namespace
}  // namespace limitcurve::fit::engines
