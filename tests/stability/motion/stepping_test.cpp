// SPDX-License-Identifier: MIT
#include "stepping.hpp"

#include "../here.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace limitcurve::stability {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Time, LightBody) {
  const auto findings = held_here(light_body());
  ASSERT_EQ(findings.size(), 4U);
  for (const std::size_t sliding_or_twisting : {0U, 2U}) {
    EXPECT_EQ(findings[sliding_or_twisting].breaks, 0.0);
    // z² − (2 − κ)z + 1 has a root −1 at κ = 4.
    EXPECT_NEAR(findings[sliding_or_twisting + 1].breaks, 4.0, 0.01);
    EXPECT_EQ(findings[sliding_or_twisting].stands, 1e8);
  }
}

TEST(Time, StiffnessAndDamping) {
  const auto hazard = stiffness_and_damping();
  for (const Finding& finding : held_here(hazard)) {
    EXPECT_GE(finding.breaks, 0.5) << finding.method;
    EXPECT_EQ(finding.stands, 0.0);
  }
  // The cells of the map are on the right side of the analytic limits, except for cells next to them.
  int wrong = 0;
  for (const Row& row : hazard.figures.at(0).rows) {
    if (row.series.find_first_not_of("0123456789.e-") != std::string::npos) continue;
    const double zeta = std::stod(row.series);
    const double beta = 2.0 * zeta * std::sqrt(row.x);
    const bool is_explicit = row.panel == "explicit Euler";
    const double excess = is_explicit                       ? row.x - beta * (1.0 - beta)
                          : row.panel == "symplectic Euler" ? row.x + 2.0 * beta - 4.0
                                                            : -infinity;
    if (std::fabs(excess) > 0.02 * row.x && (row.value == 1.0) != (excess > 0.0)) ++wrong;
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Time, BlockOfTenGrams) {
  const auto findings = held_here(block_of_ten_grams());
  ASSERT_EQ(findings.size(), 2U);
  for (const Finding& finding : findings) {
    EXPECT_NEAR(finding.breaks, 1000.0, 1e-9) << finding.method;
    EXPECT_NEAR(finding.stands, 1.0, 1e-6);
  }
}

TEST(Time, ReleasedGrip) {
  for (const Finding& finding : held_here(released_grip())) {
    EXPECT_GE(finding.breaks, 0.1);
    EXPECT_LE(finding.stands, 1e-12);
  }
}

// A force of d samples' delay, held for a sample, is late by τ = (d + ½)T: a damping of −kτ, of which the device has 1.05 kT/2. To first order
// the amplitude grows at the rate (d − 0.025) kT/2m.
TEST(Time, DelayedForces) {
  const auto findings = held_here(delayed_forces());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_NEAR(std::log(findings[0].breaks), 4.875, 0.05 * 4.875);
  EXPECT_NEAR(std::log(findings[1].breaks), 9.875, 0.05 * 9.875);
  for (const Finding& finding : findings) EXPECT_LT(finding.stands, 1.0) << finding.hazard;
}

TEST(Time, SampledContact) {
  const auto findings = held_here(sampled_contact());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 0.5);
  EXPECT_LE(findings[0].stands, 0.0);
  EXPECT_LE(findings[1].stands, 1e-12);
}

TEST(Time, EncoderSteps) {
  const auto findings = held_here(encoder_steps());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 1.5);
  EXPECT_LE(findings[0].stands, 1.0 + 1e-12);
  EXPECT_GE(findings[1].breaks, 0.5);
  EXPECT_EQ(findings[1].stands, 0.0);
}

}  // namespace

}  // namespace limitcurve::stability
