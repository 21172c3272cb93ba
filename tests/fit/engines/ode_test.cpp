// SPDX-License-Identifier: MIT
//
// A finger in ODE, given the translated coefficients and dragged about imposed centres of rotation.
#include "tests/fit/engines/box_test.hpp"
#include "tests/fit/engines/ode_drag.hpp"

#include <gtest/gtest.h>

namespace limitcurve::fit::engines {
namespace {

TEST(Ode, IsABoxWithTheExactLimits) {
  expect_box("ode", drag_in_ode, 1e-3 / friction, 1e-3);
}

}  // namespace
}  // namespace limitcurve::fit::engines
