// SPDX-License-Identifier: MIT
// Where a point is with respect to a mesh: inside or outside, where a way enters, and the nearest place.
#include "godobject/mesh/mesh.hpp"

#include "tests/mesh/shapes.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

// Inside or outside, and the entry of a segment, against the solid angle and each face; also points on vertices and edges, or in line
// with them.
TEST(Mesh, InsideIsExact) {
  const Mesh mesh(read_triangles(data_mesh("star.obj")));
  Random random(5);
  int inside = 0;
  constexpr int points = repetitions(20000, 2000);
  for (int i = 0; i < points; ++i) {
    Vector3d point{random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06)};
    // In line with a vertex along the axis of the inside test.
    const Vector3d& vertex = mesh.vertices()[static_cast<std::size_t>(random.bits() % mesh.vertices().size())];
    if (i % 4 == 1) point = {point.x(), vertex.y(), vertex.z()};
    if (i % 4 == 2) point = {point.x(), 0.0, 0.0};
    if (distance_by_search(mesh, point) < 1e-11) continue;
    const bool holds = mesh.holds(point);
    ASSERT_EQ(holds, winding_by_search(mesh, point) > 0.5) << point.transpose();
    inside += holds;
  }
  EXPECT_GT(inside, points / 20);
}

// Less than half a step off a box's side a place is rounded on to it, and how ties are broken decides: the lower sides are inside, the
// upper ones are not. A point outside by this rule has an entry.
TEST(Mesh, JustOffItsSidesInsideIsExactToo) {
  const Mesh mesh(box_triangles({0.06, 0.03, 0.02}));
  const double step = mesh.grid().step();
  const Vector3d high = mesh.grid().snap({0.06, 0.03, 0.02});
  Random random(14);
  Vector3d from = 2.0 * high;
  int entries = 0;
  int rounded = 0;
  for (int i = 0; i < 20000; ++i) {
    Vector3d place = high.cwiseProduct(Vector3d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)));
    for (int axis = 0; axis < 3; ++axis) {
      const double side = random.bits() % 2 != 0 ? high[axis] : -high[axis];
      if (random.bits() % 3 == 0) place[axis] = side + 0.25 * step * static_cast<double>(static_cast<int>(random.bits() % 11) - 5);
    }
    const Vector3d on_grid = mesh.grid().snap(place);
    const bool inside = (on_grid.array() >= -high.array()).all() && (on_grid.array() < high.array()).all();
    ASSERT_EQ(mesh.holds(place), inside) << i;
    rounded += inside && (place.array() < -high.array()).any();
    const bool enters = !mesh.holds(from) && inside;
    entries += enters;
    if (enters) {
      ASSERT_TRUE(mesh.entry(from, place).has_value()) << i;
    }
    from = place;
  }
  EXPECT_GT(rounded, 500);
  EXPECT_GT(entries, 2000);
}

TEST(Mesh, EveryWayInHasAnEntry) {
  const Mesh mesh(read_triangles(data_mesh("star.obj")));
  Random random(6);
  const auto any_vertex = [&] { return mesh.vertices()[static_cast<std::size_t>(random.bits() % mesh.vertices().size())]; };
  int entries = 0;
  constexpr int ways = repetitions(100000, 10000);
  for (int i = 0; i < ways; ++i) {
    Vector3d from{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    Vector3d to{random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03)};
    if (i % 4 == 1) to = 2.0 * any_vertex() - from;           // through a vertex
    if (i % 4 == 2) to = any_vertex() + any_vertex() - from;  // often through the middle of an edge
    if (i % 4 == 3) from = any_vertex(), to = -from;          // from one
    const bool enters = !mesh.holds(from) && mesh.holds(to);
    entries += enters;
    if (enters) {
      ASSERT_TRUE(mesh.entry(from, to).has_value()) << i;
      // From afar as well.
      ASSERT_TRUE(mesh.entry(from + 1e8 * (from - to), from).has_value() || mesh.entry(from, to).has_value());
    }
  }
  EXPECT_GT(entries, ways / 10);
}

TEST(Mesh, TheNearestPlaceIsThatOfASearch) {
  const Mesh mesh(read_triangles(data_mesh("star.obj")));
  Random random(7);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    const MeshPlace place = mesh.nearest(point, i % 240);
    ASSERT_NEAR((place.point - point).norm(), distance_by_search(mesh, point), 1e-15);
    ASSERT_LT(distance_by_search(mesh, place.point), 1e-16);
  }
}

// Slivers of 1.2e-6: a long plate cut lengthwise into strips, with closest points on them.
TEST(Mesh, SliversHaveNearestPlacesToo) {
  TriangleList list = box_triangles({0.05, 6e-8, 0.01});
  const Mesh mesh(list);
  Random random(8);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point{random.uniform(-0.1, 0.1), random.uniform(-0.01, 0.01), random.uniform(-0.02, 0.02)};
    const Vector3d exact = point.cwiseMax(Vector3d(-0.05, -6e-8, -0.01)).cwiseMin(Vector3d(0.05, 6e-8, 0.01));
    ASSERT_NEAR((mesh.nearest(point, 0).point - exact).norm(), 0.0, 1e-11);
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
