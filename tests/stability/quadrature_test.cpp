// SPDX-License-Identifier: MIT
#include "atlas.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

namespace {

TEST(Quadrature, CentreUnderTheFinger) {
  for (const Finding& finding : findings_of(quadrature(), "Quadrature.CentreUnderTheFinger")) {
    EXPECT_GE(finding.breaks, 1e-10) << finding.method;
    EXPECT_LE(finding.stands, 1e-13) << finding.method;
  }
}

}  // namespace

}  // namespace limitcurve::stability
