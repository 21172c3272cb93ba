// SPDX-License-Identifier: MIT
//
// A finger in Bullet, given the translated coefficients and dragged about imposed centres of rotation.
#include "tests/fit/engines/box_test.hpp"
#include "tests/fit/engines/bullet_drag.hpp"

#include <gtest/gtest.h>

namespace limitcurve::fit::engines {
namespace {

TEST(Bullet, IsABoxWithTheExactLimits) {
  // Single precision.
  expect_box("bullet", drag_in_bullet, 1e-3 * load, 2e-3);
}

}  // namespace
}  // namespace limitcurve::fit::engines
