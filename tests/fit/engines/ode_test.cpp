// SPDX-License-Identifier: MIT
//
// A finger in ODE, given the translated coefficients and dragged about imposed centres of rotation.
#include "limitcurve/approximations.hpp"
#include "tests/fit/engines/ode_drag.hpp"

#include <gtest/gtest.h>

namespace limitcurve::fit::engines {
namespace {

TEST(Ode, IsABoxWithTheExactLimits) {
  const EngineContact contact = translated();
  const double moment_ratio = law()->moment_ratio();
  const Box expected = box(1.0, moment_ratio);
  for (const SlipTwist twist : twists) {
    const auto [measured, normal] = drag_in_ode(contact, twist);
    EXPECT_NEAR(normal, load, 1e-3 / friction);
    EXPECT_NEAR(measured.force, expected.wrench(twist).force, 1e-3) << "c/a = " << twist.cor();
    EXPECT_NEAR(measured.moment / moment_ratio, expected.wrench(twist).moment / moment_ratio, 1e-3) << "c/a = " << twist.cor();
  }
}

}  // namespace
}  // namespace limitcurve::fit::engines
