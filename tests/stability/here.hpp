// SPDX-License-Identifier: MIT
#pragma once

#include "atlas.hpp"

#include <gtest/gtest.h>

namespace limitcurve::stability {

/// The findings of a hazard; each must name the present test, because the document lists the test of each line.
inline std::vector<Finding> held_here(const Hazard& hazard) {
  const ::testing::TestInfo* here = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(here->test_suite_name()) + '.' + here->name();
  for (const Finding& finding : hazard.findings) EXPECT_EQ(finding.test, name) << finding.hazard << ", " << finding.method;
  EXPECT_FALSE(hazard.findings.empty());
  return hazard.findings;
}

}  // namespace limitcurve::stability
