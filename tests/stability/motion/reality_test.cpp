// SPDX-License-Identifier: MIT
#include "reality.hpp"

#include "../here.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace limitcurve::stability {

namespace {

TEST(Reality, RatesAndJitter) {
  const auto hazard = rates_and_jitter();
  for (const Finding& finding : held_here(hazard)) {
    EXPECT_GE(finding.breaks, 2.0) << finding.quantity;
    EXPECT_LE(finding.stands, 1.0 + 1e-12);
  }
  // The error at a lower rate is at most proportional to the step.
  for (const Row& row : hazard.figures.at(0).rows) {
    if (row.panel == "error") {
      EXPECT_LE(row.value, 40.0 / row.x) << row.x << " Hz";
    }
  }
}

TEST(Reality, Clocks) {
  const auto findings = held_here(clocks());
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_GE(findings[0].breaks, 0.3);
  EXPECT_LE(findings[0].stands, 1e-9);
  // Infinite, and attracting.
  EXPECT_FALSE(std::isfinite(findings[1].breaks));
  EXPECT_LE(findings[2].breaks, -1.0);
  EXPECT_NEAR(findings[1].stands, 1.0, 1e-12);
  // Refused, with the last load held: 20 ms of growing depth, and the dampers' part of it.
  EXPECT_NEAR(findings[2].stands, (20.0 + 5.0) / 21.0, 1e-12);
}

TEST(Reality, BadSamples) {
  const auto findings = held_here(bad_samples());
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings[0].breaks, 1000.0);
  EXPECT_EQ(findings[0].stands, 0.0);
  EXPECT_GE(findings[1].breaks, 50.0);
  EXPECT_LE(findings[1].stands, 1.0);
  EXPECT_LE(findings[2].stands, 1e-4);
}

TEST(Reality, PlateBetweenSamples) {
  for (const Finding& finding : held_here(plate_between_samples())) {
    EXPECT_EQ(finding.breaks, 0.0);
    EXPECT_NEAR(finding.stands, 1.0, 1e-12);
  }
}

TEST(Reality, FrozenDevice) {
  for (const Finding& finding : held_here(frozen_device())) {
    EXPECT_GE(finding.breaks, 10.0);
    EXPECT_LE(finding.stands, 1.0 + 1e-12);
  }
}

}  // namespace

}  // namespace limitcurve::stability
