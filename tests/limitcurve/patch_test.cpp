// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"
#include "patch_cases.hpp"
#include "tests/limitcurve/complaint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace limitcurve::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

TEST(PatchInput, BadOnesAreNamed) {
  const auto has = [](const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(complaint([] { return Patch::points(std::vector<PatchLoad>{{0, 0, 1}, {0, nan, 1}}); }), "point 2: y = nan"));
  EXPECT_TRUE(has(complaint([] { return Patch::points(std::vector<PatchLoad>{{0, 0, -1}}); }), "point 1: load = -1"));
  EXPECT_TRUE(has(complaint([] { return Patch::points(std::vector<PatchLoad>{{0, 0, 0}, {1, 0, 0}}); }), "all 2 points have load 0"));
  EXPECT_TRUE(has(complaint([] { return Patch::points({}); }), "no points"));
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {1, 0}}); }), "2 vertices"));
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {1, inf}, {1, 0}}); }), "vertex 2: y = inf"));
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {1, 0}, {1, 0}, {0, 1}}); }), "vertex 3: equal to vertex 2"));
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {1, 1}, {2, 2}}); }), "enclose no area"));
  const std::string bow_tie = complaint([] { return Patch::polygon(Outline{{0, 0}, {1, 1}, {1, 0}, {0, 1}}); });
  EXPECT_TRUE(has(bow_tie, "the edge from vertex 1 to 2 meets the edge from vertex 3 to 4")) << bow_tie;
  // A hole that a slit joins to the outside, and one vertex on another edge.
  EXPECT_TRUE(has(complaint([] { return Patch::polygon(Outline{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}); }), "meets"));
  EXPECT_TRUE(has(complaint([] { return Patch::rectangle(0.0, 1.0); }), "x = 0 m"));
  EXPECT_TRUE(has(complaint([] { return Patch::rectangle(1.0, nan); }), "y = nan m"));
  EXPECT_TRUE(has(complaint([] { return Patch::ellipse(hertz(), 1.0, -1.0); }), "b = -1 m"));
  EXPECT_TRUE(has(complaint([] { return Patch::ellipse(hertz(), 1.0, 1e-5); }), "aspect"));
  EXPECT_TRUE(has(complaint([] { return Patch::ellipse(hertz(), 1.0, 1e-3).orthotropic(1.0, 100.0); }), "aspect"));
  EXPECT_TRUE(has(complaint([] { return Patch::image(std::vector<double>{1, 2, 3, nan}, 2, 1.0); }), "row 2, column 2: pressure = nan"));
  EXPECT_TRUE(has(complaint([] { return Patch::image(std::vector<double>{1, -2, 3, 1}, 2, 1.0); }), "row 1, column 2: pressure = -2"));
  EXPECT_TRUE(has(complaint([] { return Patch::image(std::vector<double>{0, 0}, 2, 1.0); }), "all 2 pixels have pressure 0"));
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

// The Hertz ellipse was said to cost 30 ns, and cost 270 to 590.
TEST(Patch, CostsWhatItSays) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "costs are those of an optimized build";
#endif
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> between(-1.0, 1.0);
  std::vector<PatchTwist> twists;
  for (int i = 0; i < 512; ++i) {
    const double angle = std::numbers::pi * between(random);
    const double distance = std::pow(10.0, between(random));
    twists.push_back({distance * std::cos(angle), distance * std::sin(angle), 1.0});
  }
  std::vector<SlipTwist> slips;
  for (const PatchTwist& twist : twists) slips.push_back({std::hypot(twist.vx, twist.vy), twist.omega});
  const auto clocks_of = [](const auto& inputs, const auto& wrench_of) {
    double sum = 0.0;
    const std::clock_t begin = std::clock();
    for (int i = 0; i < 20; ++i) {
      for (const auto& input : inputs) sum += wrench_of(input);
    }
    EXPECT_GT(sum, 0.0);
    return static_cast<double>(std::clock() - begin);
  };
  const Table table = Table::build(hertz(), 1e-8);
  for (const double b : {0.9, 0.5, 0.1}) {
    for (const Law& law : {hertz(), uniform()}) {
      const Patch patch = Patch::ellipse(law, 1.0, b);
      const double m0 = patch.moment_ratio();
      // In turns, so that a busy machine slows both down.
      double usual = inf;
      double found = inf;
      for (int run = 0; run < 9; ++run) {
        usual = std::min(usual, clocks_of(slips, [&](const SlipTwist& twist) { return table.wrench(twist).moment; }) / 9.0);
        found = std::min(found, clocks_of(twists, [&](const PatchTwist& twist) {
                           return patch.wrench({m0 * twist.vx, m0 * twist.vy, twist.omega}).moment;
                         }));
      }
      EXPECT_LT(found / usual, 3.0 * patch.nanoseconds()) << law->name() << ' ' << b;
      EXPECT_GT(found / usual, patch.nanoseconds() / 3.0) << law->name() << ' ' << b;
    }
  }
}

}  // namespace
}  // namespace limitcurve::test
