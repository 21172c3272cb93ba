// SPDX-License-Identifier: MIT
#include "godobject/body/grasp.hpp"
#include "godobject/mesh/mesh.hpp"
#include "godobject/mesh/mesh_surface.hpp"
#include "tests/mesh/shapes.hpp"

#include <gtest/gtest.h>

/// From one wall to another within a sample: the finger left the one and landed on the other, and its springs are relaxed there.
namespace limitcurve::godobject::test {
namespace {

using Eigen::Vector3d;

/// Two blocks with a gap along x about the origin [m].
TriangleList jaws(double gap) {
  TriangleList list;
  for (const double side : {-1.0, 1.0}) {
    const int first = static_cast<int>(list.vertices.size());
    const TriangleList block = box_triangles({0.01, 0.03, 0.03});
    for (const Vector3d& vertex : block.vertices) list.vertices.push_back(vertex + Vector3d(side * (0.01 + 0.5 * gap), 0.0, 0.0));
    for (const auto& [a, b, c] : block.faces) list.faces.push_back({first + a, first + b, first + c});
  }
  return list;
}

FingerOutput after(SoftFinger finger, const AnySurface& surface, std::initializer_list<Vector3d> places) {
  FingerOutput output;
  for (const Vector3d& place : places) output = finger.update(surface, {place}, 1e-3);
  return output;
}

// Within a sample from 1 mm deep in one wall to 1 mm deep in the other: what is felt is what a sample in the gap would have led to.
TEST(Landing, FromWallToWallIsATouchDown) {
  const MeshSurface bracket = read_mesh(data_mesh("bracket.stl"));
  struct Walls {
    AnySurface surface;
    Vector3d one, between, other;
  };
  const std::array walls{
      Walls{AnySurface(MeshSurface(Mesh(jaws(0.02)))), {-0.011, 0, 0}, {0, 0, 0}, {0.011, 0, 0}},
      Walls{AnySurface(MeshSurface(Mesh(jaws(0.001)))), {-0.0006, 0, 0}, {0, 0, 0}, {0.0006, 0, 0.001}},
      Walls{AnySurface(bracket), {0.055, 0.019, 0.001}, {0.03, 0.03, 0.001}, {0.019, 0.055, 0.001}},
  };
  const Patch patch = Patch::ellipse(hertz(), 0.01, 0.004);
  for (const auto& [surface, one, between, other] : walls) {
    const double depth = after(hertz_finger(), surface, {between, other}).depth;
    ASSERT_GT(depth, 0.0);
    for (const double mu : {0.0, 0.6}) {
      for (const SoftFinger& finger : {hertz_finger(parameters(mu)), SoftFinger(patch, parameters(mu))}) {
        const FingerOutput jumped = after(finger, surface, {between, one, other});
        const FingerOutput expected = after(finger, surface, {between, one, between, other});
        EXPECT_NEAR(jumped.load, 1000.0 * depth, 1e-9);
        EXPECT_EQ(jumped.load, expected.load);
        EXPECT_EQ(jumped.state, expected.state);
        EXPECT_TRUE(same_bits(jumped.proxy, expected.proxy) && same_bits(jumped.force, expected.force));
        EXPECT_EQ(jumped.moment, expected.moment);
      }
    }
  }
}

// A finger that jumps about two blocks at random, deep and with friction. A block is convex: no finger flies from it to itself. So it lands
// anew where it touches the other block than in the sample before, and nowhere else; and there the load is k d.
TEST(Landing, OnlyFromOneBlockToTheOther) {
  const MeshSurface surface{Mesh(jaws(0.002))};
  SoftFinger finger = hertz_finger();
  Random random(28);
  Vector3d place = Vector3d::Zero();
  int landings = 0;
  double block = 0.0;
  for (int i = 0; i < 20000; ++i) {
    place += Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) * random.logarithmic(1e-6, 1e-2);
    place = place.cwiseMax(-0.004).cwiseMin(0.004);
    const Contact contact = surface.contact(place, finger.state().contact);
    const FingerOutput output = finger.update(contact, 0.0);
    const double now = contact.depth > 0.0 ? std::copysign(1.0, contact.point.x()) : 0.0;
    const bool changes = block != 0.0 && now == -block;
    if (changes) {
      ++landings;
      ASSERT_NEAR(output.load, 1000.0 * output.depth, 1e-9) << i;
      ASSERT_EQ(output.force.norm(), 0.0);
    }
    ASSERT_EQ(contact.landed, changes) << i;
    block = now;
  }
  EXPECT_GT(landings, 200);
}

// A star of spikes: whatever flight ends on its surface, the load is k d.
TEST(Landing, TheLoadOfALandingIsThatOfItsDepth) {
  const MeshSurface star = read_mesh(data_mesh("star.obj"));
  SoftFinger finger = hertz_finger();
  Random random(29);
  int landings = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d place(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05));
    const Contact contact = star.contact(place, finger.state().contact);
    const FingerOutput output = finger.update(contact, 0.0);
    if (!contact.landed) continue;
    ++landings;
    ASSERT_LE(output.load, 1000.0 * std::max(output.depth, 0.0) + 1e-9) << i;
  }
  EXPECT_GT(landings, 100);
}

// A block with a slot is carried about a finger that rests: in each sample the finger is in the other wall.
TEST(Landing, ACarriedSlotDoesNotLoadTheFinger) {
  Grasp grasp(BodyParameters::block(0.1, {0.04, 0.06, 0.06}), BodyState{}, AnySurface(MeshSurface(Mesh(jaws(0.001)))), {hertz_finger()});
  const std::array<DevicePose, 1> device{};
  grasp.place(BodyState{}, device);
  for (int i = 0; i < 10; ++i) {
    BodyState state;
    state.position.x() = i % 2 == 0 ? 0.0006 : -0.0006;
    grasp.carry(state, device, 1e-2);
    EXPECT_NEAR(grasp.finger(0).output().depth, 1e-4, 1e-9);
    EXPECT_NEAR(grasp.force_on_user(0).norm(), 0.1, 1e-6);
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
