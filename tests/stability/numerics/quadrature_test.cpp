// SPDX-License-Identifier: MIT
#include "quadrature.hpp"

#include "../here.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

namespace {

/// A relative error that counts as a failure, compared with the requested 1e-9.
constexpr double wrong = 1e-8;
/// The library's bound for quadrature in loops (accuracy::forces_by_quadrature).
constexpr double promised = 1e-13;

TEST(Quadrature, CentreUnderTheFinger) {
  const auto findings = held_here(centre_under_the_finger());
  ASSERT_EQ(findings.size(), 3U);
  // At the worst of all CORs; at the CORs of a short build it is above the requested 1e-9.
  EXPECT_GE(findings[0].breaks, tests_are_short ? 1e-9 : 1e-6);
  EXPECT_LE(findings[0].stands, promised);
  // Our stated error is never below the true one.
  EXPECT_GE(findings[1].breaks, 3.0);
  EXPECT_LE(findings[1].stands, 1.0);
  EXPECT_GE(findings[2].breaks, 1e-4);
  EXPECT_LE(findings[2].stands, promised);
}

TEST(Quadrature, AdaptiveSubdivisionStopsShort) {
  for (const Finding& finding : held_here(adaptive_subdivision())) {
    EXPECT_GE(finding.breaks, 1e-12);
    EXPECT_LE(finding.stands, promised);
  }
}

TEST(Quadrature, SingularRim) {
  const auto findings = held_here(singular_rim());
  ASSERT_EQ(findings.size(), 4U);
  for (const Finding& finding : findings) {
    EXPECT_GE(finding.breaks, wrong) << finding.method << ' ' << finding.quantity;
    EXPECT_LE(finding.stands, promised) << finding.quantity;
  }
  // Towards the ring half the load lies where 1 − ρ rounds to 0.
  EXPECT_GE(findings.back().breaks, 0.3);
}

TEST(Quadrature, KinksOfAMeasuredProfile) {
  const auto findings = held_here(kinks_of_a_profile());
  ASSERT_EQ(findings.size(), 3U);
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_GE(findings[i].breaks, 1e-6) << findings[i].method;
    EXPECT_LE(findings[i].stands, promised);
  }
  EXPECT_GE(findings[1].breaks, 2.0);
  EXPECT_LE(findings[1].stands, 1.0);
}

TEST(Quadrature, VanishingComplement) {
  const auto findings = held_here(vanishing_complement());
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_GE(findings[0].breaks, 1e-8);
  EXPECT_GE(findings[1].breaks, 1e-170);
  for (const Finding& finding : findings) EXPECT_EQ(finding.stands, 0.0);
}

TEST(ClosedForms, MomentFarAway) {
  const auto findings = held_here(moment_far_away());
  ASSERT_EQ(findings.size(), 4U);
  for (const Finding& finding : findings) {
    EXPECT_GE(finding.breaks, 1e-10) << finding.method;
    EXPECT_LE(finding.stands, 1e-14) << finding.method;
  }
}

TEST(ClosedForms, ForceNearTheCentre) {
  for (const Finding& finding : held_here(force_near_the_centre())) {
    EXPECT_GE(finding.breaks, 1e-3);
    EXPECT_LE(finding.stands, 1e-14);
  }
}

}  // namespace

}  // namespace limitcurve::stability
