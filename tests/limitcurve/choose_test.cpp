// SPDX-License-Identifier: MIT
#include "limitcurve/choose.hpp"
#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace limitcurve::test {

namespace {

const Candidate& chosen(const std::vector<Candidate>& candidates) {
  return *std::find_if(candidates.begin(), candidates.end(), [](const Candidate& candidate) { return candidate.chosen; });
}

TEST(Choose, TakesTheCheapestThatIsGoodEnough) {
  for (const char* law : {"hertz", "uniform", "flat-punch", "xydas-kao:k=3"}) {
    for (const double tolerance : {1.0, 0.6, 0.2, 0.07, 0.01, 1e-4, 1e-8}) {
      const auto candidates = choose(parse_law(law), tolerance);
      const Candidate& best = chosen(candidates);
      EXPECT_LE(best.error, tolerance) << law;
      EXPECT_EQ(std::count_if(candidates.begin(), candidates.end(), [](const Candidate& candidate) { return candidate.chosen; }), 1);
      for (const Candidate& other : candidates) {
        if (other.nanoseconds < best.nanoseconds) {
          EXPECT_GT(other.error, tolerance) << law << ": " << other.model;
        }
      }
    }
  }
}

TEST(Choose, FollowsTheTolerance) {
  EXPECT_EQ(chosen(choose(hertz(), 0.6)).model, "box");
  EXPECT_EQ(chosen(choose(hertz(), 0.07)).model, "ellipse");
  EXPECT_EQ(chosen(choose(uniform(), 0.07)).model, "table");  // whose ellipse is off by 7.04 %
  EXPECT_EQ(chosen(choose(hertz(), 1e-6)).model, "table");
}

TEST(Choose, RefusesTolerancesThatMeanNothing) {
  for (const double tolerance : {0.0, -1.0, 1e-11, 2.0}) EXPECT_THROW(choose(hertz(), tolerance), std::invalid_argument);
}

}  // namespace

}  // namespace limitcurve::test
