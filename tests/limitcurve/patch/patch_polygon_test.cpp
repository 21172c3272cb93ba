// SPDX-License-Identifier: MIT
#include "patch_cases.hpp"

namespace limitcurve::test {
namespace {

void expect_polygon(const Outline& vertices, const std::vector<PatchTwist>& cases) {
  const Patch patch = Patch::polygon(vertices);
  for (const PatchTwist& twist : cases) {
    expect_exact(patch, twist, polygon_by_triangles(vertices, twist, patch.centre()), accuracy::patch_points,
                 witness_error);
  }
}

TEST(PatchPolygon, IsTheIntegralOverTriangles) {
  for (const Outline& vertices :
       {rectangle(2, 2), rectangle(20, 2), rectangle(0.002, 0.02), ell, star(5, 0.3), star(12, 0.9), star(3, 0.5)}) {
    double radius = 0.0;
    for (const PatchPoint& vertex : vertices) radius = std::max(radius, std::hypot(vertex.x, vertex.y));
    expect_polygon(vertices, twists(radius, 300));
  }
}

TEST(PatchPolygon, WithTheCorOnVerticesEdgesAndTheirLines) {
  for (const Outline& vertices : {rectangle(2, 2), rectangle(20, 2), ell, star(5, 0.3)}) {
    const PatchPoint c = Patch::polygon(vertices).centre();
    std::vector<PatchTwist> cases;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const PatchPoint& from = vertices[i];
      const PatchPoint& to = vertices[(i + 1) % vertices.size()];
      for (const double t : {0.0, 1e-12, 1e-5, 0.25, 0.5, 0.9999999, -0.5, 1.7, 2.4}) {
        const PatchPoint cor{from.x + t * (to.x - from.x) - c.x, from.y + t * (to.y - from.y) - c.y};
        for (const double off : {0.0, 1e-14, 1e-7}) cases.push_back(about({cor.x + off, cor.y - off}));
      }
    }
    expect_polygon(vertices, cases);
  }
}

// Twice the mean distance from a corner of a unit square, B₂(1) (Bailey, Borwein, Crandall, J. Comput. Appl. Math.
// 206:196, 2007).
TEST(PatchPolygon, SquareHasItsKnownSpin) {
  EXPECT_NEAR(Patch::rectangle(2.0, 2.0).moment_ratio(), (std::sqrt(2.0) + std::asinh(1.0)) / 3.0, 1e-15);
}

TEST(PatchPolygon, OfTwentyThousandVerticesKeepsItsStatedError) {
  Outline vertices;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double r = 1.0 + 0.1 * std::sin(7 * angle);
    vertices.push_back({0.3 + r * std::cos(angle), r * std::sin(angle)});
  }
  expect_polygon(vertices,
                 {about({0, 0}), about({0.3, 0.2}), about({-0.9, 0.4}), about({2.0, 2.2}), about({5.0, -2.0})});
}

TEST(PatchPolygon, OfTenThousandVerticesIsTheDisc) {
  Outline vertices;
  constexpr int count = 10000;
  for (int i = 0; i < count; ++i)
    vertices.push_back({std::cos(2 * std::numbers::pi * i / count), std::sin(2 * std::numbers::pi * i / count)});
  const Patch patch = Patch::polygon(vertices);
  const Law law = uniform();
  for (const double c : {0.0, 1e-3, 0.4, 0.999, 1.0, 1.5, 3.1, 40.0, 1e6}) {
    const UnitForces<double> disc = law->forces(c);
    const PatchFriction friction = patch.evaluate(about({c, 0}));
    // Its radius of equal area is (2π/n)²/12 = 3.3e-8 short of 1.
    EXPECT_NEAR(-friction.wrench.fy, disc.force, 4e-8);
    EXPECT_NEAR(friction.wrench.moment, disc.moment, 4e-8);
  }
}

// Long edges side by side, in any direction, are compared with their neighbours alone.
TEST(PatchPolygon, ACombOfManyTeethIsChecked) {
  constexpr int teeth = 10000;
  for (const double angle : {0.0, 0.3, 0.785, 1.571}) {
    std::vector<PatchPoint> comb{{-5, 4.0 * teeth}, {-5, 0}};
    for (int i = 0; i < teeth; ++i) {
      const double y = 4.0 * i;
      comb.insert(comb.end(), {{1e5, y}, {1e5, y + 1}, {0, y + 1}, {0, y + 4}});
    }
    for (PatchPoint& at : comb)
      at = {at.x * std::cos(angle) - at.y * std::sin(angle), at.x * std::sin(angle) + at.y * std::cos(angle)};
    EXPECT_GT(Patch::polygon(comb).moment_ratio(), 0.0);
    std::swap(comb[2000], comb[2004]);
    EXPECT_THROW(Patch::polygon(comb), std::invalid_argument);
  }
}

}  // namespace
}  // namespace limitcurve::test
