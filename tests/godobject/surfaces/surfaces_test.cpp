// SPDX-License-Identifier: MIT
#include "godobject/surfaces/surfaces.hpp"

#include "tests/godobject/scene.hpp"
#include "tests/touch.hpp"

namespace limitcurve::godobject::test::surfaces_test {
namespace {

template <class Shape>
Contact first_contact(const Shape& shape, const Vector3d& finger) {
  ContactMemory memory;
  return touch(shape, finger, memory);
}

/// Along each edge of the cube that is searched.
constexpr int cells = repetitions(60, 15);

/// Outside: the distance of `finger` from the nearest of many points of the solid, found by brute force.
template <class Inside>
double distance_by_search(const Vector3d& finger, double reach, Inside&& inside) {
  double least = infinity;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      for (int k = 0; k <= cells; ++k) {
        const Vector3d point = reach * (Vector3d(i, j, k) * (2.0 / cells) - Vector3d::Ones());
        if (inside(point)) least = std::min(least, (point - finger).norm());
      }
    }
  }
  return least;
}

/// What holds for every contact: the point lies `depth` along the normal from the finger, the normal is of unit length.
void expect_consistent(const Contact& contact, const Vector3d& finger) {
  EXPECT_NEAR(contact.normal.norm(), 1.0, 1e-14);
  EXPECT_LT((finger + contact.normal * contact.depth - contact.point).norm(), 1e-14);
}

template <class Shape, class Inside>
void check_distance(const Shape& shape, Inside&& inside) {
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const Vector3d finger{random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5)};
    const Contact contact = first_contact(shape, finger);
    expect_consistent(contact, finger);
    if (inside(finger)) {
      EXPECT_GT(contact.depth, 0.0);
    } else {
      // The grid's points are at most half a diagonal of 2.5/30 from the nearest, or of what is coarser in a short
      // build.
      const double distance = distance_by_search(finger, 1.25, inside);
      EXPECT_LE(-contact.depth, distance + 1e-12);
      EXPECT_GE(-contact.depth, distance - 0.08 * (60.0 / cells));
    }
  }
}

TEST(Surfaces, FindTheNearestPoint) {
  check_distance(SphereSurface(0.9), [](const Vector3d& p) { return p.norm() <= 0.9; });
  check_distance(CapsuleSurface(0.4, 0.7), [](const Vector3d& p) {
    return (p - Vector3d(0.0, 0.0, std::clamp(p.z(), -0.7, 0.7))).norm() <= 0.4;
  });
  check_distance(CylinderSurface(0.6, 0.9),
                 [](const Vector3d& p) { return std::hypot(p.x(), p.y()) <= 0.6 && std::fabs(p.z()) <= 0.9; });
  check_distance(BoxSurface({0.5, 0.9, 0.7}), [](const Vector3d& p) {
    return std::fabs(p.x()) <= 0.5 && std::fabs(p.y()) <= 0.9 && std::fabs(p.z()) <= 0.7;
  });
}

TEST(Surfaces, AThinPlateIsNotPassedThrough) {
  const BoxSurface plate({0.1, 0.1, 0.0005});
  ContactMemory memory;
  EXPECT_LT(touch(plate, {0.02, 0.0, 0.01}, memory).depth, 0.0);
  // In one step from above it to far below it, and slowly deeper.
  for (const double z : {-0.003, -0.01, -0.05}) {
    const Contact contact = touch(plate, {0.02, 0.0, z}, memory);
    EXPECT_EQ(contact.normal, Vector3d::UnitZ());
    EXPECT_NEAR(contact.depth, 0.0005 - z, 1e-15);
  }
  // Along the plate and over its edge: then it is free, and comes back from below.
  EXPECT_GT(touch(plate, {0.0999, 0.0, -0.05}, memory).depth, 0.0);
  EXPECT_LT(touch(plate, {0.11, 0.0, -0.05}, memory).depth, 0.0);
  EXPECT_LT(touch(plate, {0.05, 0.0, -0.05}, memory).depth, 0.0);
  EXPECT_EQ(touch(plate, {0.05, 0.0, -0.0001}, memory).normal, -Vector3d::UnitZ());
}

TEST(Surfaces, ABoxKeepsTheFaceThatTheFingerCameInBy) {
  const BoxSurface cube(Vector3d::Constant(0.01));
  ContactMemory memory;
  EXPECT_LT(touch(cube, {0.0, 0.0, 0.011}, memory).depth, 0.0);
  for (double x = 0.0; x < 0.01; x += 0.001) {
    // Nearer to the side than to the top, in the end.
    const Contact contact = touch(cube, {x, 0.0, 0.002}, memory);
    EXPECT_EQ(contact.normal, Vector3d::UnitZ());
    EXPECT_NEAR(contact.depth, 0.008, 1e-15);
  }
  EXPECT_LT(touch(cube, {0.0101, 0.0, 0.002}, memory).depth, 0.0);
  EXPECT_EQ(touch(cube, {0.0099, 0.0, 0.002}, memory).normal, Vector3d::UnitX());
}

TEST(Surfaces, AreDefinedAtTheirCentres) {
  for (const Vector3d& finger : {Vector3d(0.0, 0.0, 0.0), Vector3d(1e-320, 0.0, 0.0)}) {
    expect_consistent(first_contact(SphereSurface(0.9), finger), finger);
    expect_consistent(first_contact(CapsuleSurface(0.4, 0.7), finger), finger);
    expect_consistent(first_contact(CylinderSurface(0.6, 0.9), finger), finger);
    expect_consistent(first_contact(BoxSurface({0.5, 0.9, 0.7}), finger), finger);
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test::surfaces_test
