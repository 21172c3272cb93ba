// SPDX-License-Identifier: MIT
#include "../special_values.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"
#include "patch_cases.hpp"
#include "tests/complaint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace limitcurve::test {
namespace {

TEST(PatchInput, BadOnesAreNamed) {
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has(complaint([] {
                    return Patch::points(std::vector<PatchLoad>{{0, 0, 1}, {0, nan, 1}});
                  }),
                  "point 2: y = nan"));
  EXPECT_TRUE(has(complaint([] { return Patch::points(std::vector<PatchLoad>{{0, 0, -1}}); }), "point 1: load = -1"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::points(std::vector<PatchLoad>{{0, 0, 0}, {1, 0, 0}});
                  }),
                  "all 2 points have load 0"));
  EXPECT_TRUE(has(complaint([] { return Patch::points({}); }), "no points"));
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {1, 0}}); }), "2 vertices"));
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {1, inf}, {1, 0}}); }), "vertex 2: y = inf"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::polygon(Outline{{0, 0}, {1, 0}, {1, 0}, {0, 1}});
                  }),
                  "vertex 3: equal to vertex 2"));
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {1, 1}, {2, 2}}); }), "enclose no area"));
  const std::string bow_tie = complaint([] { return Patch::polygon(Outline{{0, 0}, {1, 1}, {1, 0}, {0, 1}}); });
  EXPECT_TRUE(has(bow_tie, "the edge from vertex 1 to 2 meets the edge from vertex 3 to 4")) << bow_tie;
  // A hole that a slit joins to the outside, and one vertex on another edge.
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}); }), "meets"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::polygon(Outline{{1, 0}, {1 + 1e-200, 0}, {1, 1e-200}});
                  }),
                  "equal to vertex 1"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::polygon(Outline{{0, 0}, {1e-101, 0}, {0, 1e-101}});
                  }),
                  "size = 1e-101 m"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::points(std::vector<PatchLoad>{{0, 0, 1}, {1e-101, 0, 1}});
                  }),
                  "size = 1e-101 m"));
  EXPECT_TRUE(has(complaint([] { return Patch::rectangle(0.0, 1.0); }), "x = 0 m"));
  EXPECT_TRUE(has(complaint([] { return Patch::rectangle(1.0, nan); }), "y = nan m"));
  EXPECT_TRUE(has(complaint([] { return Patch::ellipse(hertz(), 1.0, -1.0); }), "b = -1 m"));
  EXPECT_TRUE(has(complaint([] { return Patch::ellipse(hertz(), 1.0, 1e-5); }), "aspect"));
  EXPECT_TRUE(has(complaint([] { return Patch::ellipse(hertz(), 1.0, 1e-3).orthotropic(1.0, 100.0); }), "aspect"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::image(std::vector<double>{1, 2, 3, nan}, 2, 1.0);
                  }),
                  "row 2, column 2: pressure = nan"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::image(std::vector<double>{1, -2, 3, 1}, 2, 1.0);
                  }),
                  "row 1, column 2: a pressure of -2"));
  EXPECT_TRUE(has(complaint([] {
                    return Patch::image(std::vector<double>{0, 0}, 2, 1.0);
                  }),
                  "all 2 pixels have pressure 0"));
  EXPECT_TRUE(has(complaint([] { return Patch::rectangle(1, 1).orthotropic(0, 1); }), "mx = 0"));
}

TEST(PatchInput, VerticesInEitherSenseAndAClosingOneAreTheSame) {
  Outline other(ell.rbegin(), ell.rend());
  other.push_back(other.front());
  const Patch one = Patch::polygon(ell);
  const Patch two = Patch::polygon(other);
  for (const PatchTwist& twist : twists(4.0, 20))
    EXPECT_LE(test::difference(one.evaluate(twist), two.evaluate(twist), one.moment_ratio()), 1e-14);
}

}  // namespace
}  // namespace limitcurve::test
