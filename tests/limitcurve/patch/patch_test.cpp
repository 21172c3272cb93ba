// SPDX-License-Identifier: MIT
#include "patch_cases.hpp"

namespace limitcurve::test {
namespace {

TEST(PatchInput, BadOnesAreNamed) {
  const auto refused = [](const char* told, auto&& make) { expect_mention(complaint(make), told); };
  const auto points = [&](const char* told, const std::vector<PatchLoad>& loads) {
    refused(told, [&] { Patch::points(loads); });
  };
  const auto polygon = [&](const char* told, const Outline& vertices) {
    refused(told, [&] { Patch::polygon(vertices); });
  };
  const auto image = [&](const char* told, const std::vector<double>& pressures) {
    refused(told, [&] { Patch::image(pressures, 2, 1.0); });
  };
  points("point 2: y = nan", {{0, 0, 1}, {0, nan, 1}});
  points("point 1: load = -1", {{0, 0, -1}});
  points("all 2 points have load 0", {{0, 0, 0}, {1, 0, 0}});
  points("no points", {});
  points("size = 1e-101 m", {{0, 0, 1}, {1e-101, 0, 1}});
  polygon("2 vertices", {{0, 0}, {1, 0}});
  polygon("vertex 2: y = inf", {{0, 0}, {1, inf}, {1, 0}});
  polygon("vertex 3: equal to vertex 2", {{0, 0}, {1, 0}, {1, 0}, {0, 1}});
  polygon("enclose no area", {{0, 0}, {1, 1}, {2, 2}});
  polygon("the edge from vertex 1 to 2 meets the edge from vertex 3 to 4", {{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  // A hole that a slit joins to the outside, and one vertex on another edge.
  polygon("meets", {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}});
  polygon("equal to vertex 1", {{1, 0}, {1 + 1e-200, 0}, {1, 1e-200}});
  polygon("size = 1e-101 m", {{0, 0}, {1e-101, 0}, {0, 1e-101}});
  image("row 2, column 2: pressure = nan", {1, 2, 3, nan});
  image("row 1, column 2: a pressure of -2", {1, -2, 3, 1});
  image("row 1, column 2: a pressure of -2, and none is positive", {-1, -2, 0, -1});
  image("all 2 pixels have pressure 0", {0, 0});
  refused("x = 0 m", [] { Patch::rectangle(0.0, 1.0); });
  refused("y = nan m", [] { Patch::rectangle(1.0, nan); });
  refused("b = -1 m", [] { Patch::ellipse(hertz(), 1.0, -1.0); });
  refused("aspect", [] { Patch::ellipse(hertz(), 1.0, 1e-5); });
  refused("aspect", [] { return Patch::ellipse(hertz(), 1.0, 1e-3).orthotropic(1.0, 100.0); });
  refused("mx = 0", [] { return Patch::rectangle(1, 1).orthotropic(0, 1); });
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
