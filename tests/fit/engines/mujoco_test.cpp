// SPDX-License-Identifier: MIT
//
// A finger in MuJoCo, given the translated coefficients and dragged about imposed centres of rotation.
#include "tests/fit/engines/mujoco_drag.hpp"

#include "limitcurve/approximations.hpp"

#include <gtest/gtest.h>

namespace limitcurve::fit::engines {
namespace {

TEST(MujocoElliptic, IsTheEllipseThroughTheExactIntercepts) {
  const EngineContact contact = translated("mujoco", "ellipse");
  const double moment_ratio = law()->moment_ratio();
  const Ellipse ellipse = Ellipse::through_intercepts(moment_ratio);
  for (const SlipTwist twist : twists) {
    const Measured measured = drag_in_mujoco(contact, true, twist);
    EXPECT_NEAR(measured.normal, load, 1e-6 * load);
    const UnitWrench expected = ellipse.wrench(twist);
    EXPECT_NEAR(measured.wrench.force, expected.force, 1e-4) << "c/a = " << twist.cor();
    EXPECT_NEAR(measured.wrench.moment / moment_ratio, expected.moment / moment_ratio, 1e-4) << "c/a = " << twist.cor();
  }
}

TEST(MujocoPyramidal, IsADiamondThroughTheExactIntercepts) {
  const EngineContact contact = translated("mujoco", "diamond");
  const double moment_ratio = law()->moment_ratio();
  for (const SlipTwist twist : twists) {
    const Measured measured = drag_in_mujoco(contact, false, twist);
    // On the face, or in a corner: the shares add up to the whole.
    EXPECT_NEAR(measured.wrench.force + measured.wrench.moment / moment_ratio, 1.0, 1e-4) << "c/a = " << twist.cor();
  }
  EXPECT_NEAR(drag_in_mujoco(contact, false, {1.0, 0.0}).wrench.force, 1.0, 1e-4);
  EXPECT_NEAR(drag_in_mujoco(contact, false, {0.0, 1.0}).wrench.moment / moment_ratio, 1.0, 1e-4);
}

}  // namespace
}  // namespace limitcurve::fit::engines
