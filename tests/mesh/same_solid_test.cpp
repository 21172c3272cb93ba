// SPDX-License-Identifier: MIT
// The same solid gives the same answer, however its faces are divided and whatever the pace of the
// finger.
#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/mesh_surface.hpp"

#include "godobject/surface.hpp"
#include "tests/mesh/shapes.hpp"
#include "tests/repetitions.hpp"
#include "tests/touch.hpp"

#include <gtest/gtest.h>

namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

/// The force for a stiffness of 1; 0 without contact.
Vector3d push(const Contact& contact) {
  return std::max(contact.depth, 0.0) * contact.normal;
}

struct Division {
  int n;
  double power;   // 1: equal parts
  bool as_float;  // vertices rounded as in an STL
};

// A finger wanders about a block and a thin plate, in and out, with leaps: what the mesh says is
// what the box says, which was written for it.
TEST(SameSolid, ABoxOfTrianglesIsTheBox) {
  const Vector3d margin = Vector3d::Constant(0.005);
  const Eigen::Matrix3d turn = Eigen::Quaterniond(0.5, -0.3, 0.7, 0.4).normalized().toRotationMatrix();
  for (const auto& [n, power, as_float] : {Division{1, 1.0, false},
                                           {2, 1.0, false},
                                           {3, 1.0, false},
                                           {7, 1.0, false},
                                           {40, 1.0, false},
                                           {3, 1.2, false},
                                           {7, 1.2, false},
                                           {7, 1.2, true}}) {
    for (const Vector3d& half : {Vector3d(0.06, 0.02, 0.02), Vector3d(0.03, 0.0005, 0.02)}) {
      const BoxSurface box(half);
      // A box along the axes is divided exactly in its planes; a turned one within the grid, or
      // the rounding to float.
      const bool is_turned = power != 1.0;
      const Eigen::Matrix3d rotation = is_turned ? turn : Eigen::Matrix3d::Identity();
      const MeshSurface mesh(divided(box_triangles(half), n, power, [&, rounds = as_float](const Vector3d& vertex) -> Vector3d {
        const Vector3d place = rotation * vertex;
        return rounds ? Vector3d(place.cast<float>().cast<double>()) : place;
      }));
      // As floats vertices move by 4e-9, and normals of parts of 2 mm by 2e-6, felt 2 cm deep.
      const double rounding = as_float ? 1e-7 : 2e-11;
      Random random(2);
      for (const double step : {0.0002, 0.001, 0.003}) {
        Vector3d finger(0.0, 0.0, half.z() + step);
        ContactMemory of_box;
        ContactMemory of_mesh;
        int touching = 0;
        for (int i = 0; i < study_cases(200000, 2000); ++i) {
          finger += anywhere(random, i % 100 == 0 ? 0.05 : step);
          finger = finger.cwiseMax(-half - margin).cwiseMin(half + margin);
          const Contact expected = touch(box, finger, of_box);
          const Contact contact = touch(mesh, rotation * finger, of_mesh);
          ASSERT_LT((push(contact) - rotation * push(expected)).norm(), rounding) << n << ' ' << step << ' ' << i;
          touching += contact.depth > 0.0;
        }
        EXPECT_GT(touching, study_cases(4000, 20));
      }
    }
  }
}

// Spikes, creases and pits, divided, uneven, and in a mirror; by micrometres and by leaps.
TEST(SameSolid, AnySolidDividedOrMirroredIsTheSame) {
  for (const std::string name : {"star.obj", "bracket.stl", "ball.obj"}) {
    const TriangleList list = read_triangles(data_mesh(name));
    const MeshSurface given{Mesh(list)};
    for (const auto& [n, power, mirrors] : {std::tuple{2, 1.0, false}, {3, 1.2, false}, {1, 1.0, true}, {2, 1.2, true}}) {
      const Vector3d sides(mirrors ? -1.0 : 1.0, 1.0, 1.0);
      const MeshSurface other(divided(
          list, n, power, [&](const Vector3d& vertex) -> Vector3d { return vertex.cwiseProduct(sides); }, mirrors));
      Random random(31);
      ContactMemory memory;
      ContactMemory other_memory;
      Vector3d finger(0.1, 0.0, 0.0);
      int touching = 0;
      int landed = 0;
      for (int i = 0; i < study_cases(200000, 1000); ++i) {
        finger += anywhere(random, random.logarithmic(1e-6, 2e-2));
        if (finger.cwiseAbs().maxCoeff() > 0.07) finger *= 0.5;
        if (random.bits() % 4 == 0) finger = 0.95 * list.vertices[random.bits() % list.vertices.size()] + anywhere(random, 1e-4);
        const Contact contact = touch(given, finger, memory);
        const Contact found = touch(other, finger.cwiseProduct(sides), other_memory);
        ASSERT_LT((push(found) - push(contact).cwiseProduct(sides)).norm(), 1e-10) << name << ' ' << n << ' ' << i;
        ASSERT_EQ(found.landed, contact.landed) << name << ' ' << n << ' ' << i;
        touching += contact.depth > 0.0;
        landed += contact.landed;
      }
      EXPECT_GT(touching, study_cases(10000, 50));
      EXPECT_TRUE(landed > study_cases(200, 0) || name != "star.obj");
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
