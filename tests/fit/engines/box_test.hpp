// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/approximations.hpp"
#include "tests/fit/engines/dragged.hpp"

#include <gtest/gtest.h>

#include <string>

namespace limitcurve::fit::engines {

/// Checks that an engine with the translated coefficients carries the load to `load_tolerance` [N] and has the box with the exact
/// limits for its friction, to `tolerance` of either limit. `drag(contact, twist)` gives what it answered.
template <class Drag>
void expect_box(const std::string& engine, Drag&& drag, double load_tolerance, double tolerance) {
  const EngineContact contact = translated(engine, "box");
  const double moment_ratio = law()->moment_ratio();
  const Box expected = box(1.0, moment_ratio);
  for (const SlipTwist twist : twists) {
    const auto [measured, normal] = drag(contact, twist);
    EXPECT_NEAR(normal, load, load_tolerance);
    EXPECT_NEAR(measured.force, expected.wrench(twist).force, tolerance) << "c/a = " << twist.cor();
    EXPECT_NEAR(measured.moment / moment_ratio, expected.wrench(twist).moment / moment_ratio, tolerance) << "c/a = " << twist.cor();
  }
}

}  // namespace limitcurve::fit::engines
