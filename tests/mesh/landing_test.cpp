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
  for (const double side : {-1.0, 1.0}) add(list, box_triangles({0.01, 0.03, 0.03}), Vector3d(side * (0.01 + 0.5 * gap), 0.0, 0.0));
  return list;
}

/// A plate, and beside and below its rim a block [m].
TriangleList plate_and_block() {
  TriangleList list = box_triangles({0.03, 0.03, 0.0005});
  add(list, box_triangles({0.01, 0.03, 0.01}), {0.045, 0.0, -0.01});
  return list;
}

/// A groove of radius 1 along y with its middle at the origin, in a block or in a sheet of this
/// thickness. The facets have this angle [rad] and reach to 1 rad on each side.
TriangleList groove(double facet, double thickness) {
  TriangleList list;
  const int count = static_cast<int>(std::lround(2.0 / facet));
  for (int i = 0; i <= count; ++i) {
    const double x = std::sin(facet * i - 1.0), z = 1.0 - std::cos(facet * i - 1.0);
    const double below = thickness < 1.0 ? z - thickness : -1.0;
    for (const Vector3d& vertex : {Vector3d(x, -0.5, z), {x, 0.5, z}, {x, -0.5, below}, {x, 0.5, below}}) list.vertices.push_back(vertex);
  }
  const auto add = [&](int a, int b, int c, int d) {
    list.faces.push_back({a, b, c});
    list.faces.push_back({a, c, d});
  };
  for (int i = 0; i < count; ++i) {
    const int a = 4 * i, b = a + 4;
    add(a, b, b + 1, a + 1);
    add(a + 2, a + 3, b + 3, b + 2);
    add(a, a + 2, b + 2, b);
    add(a + 1, b + 1, b + 3, a + 3);
  }
  const int last = 4 * count;
  add(0, 1, 3, 2);
  add(last, last + 2, last + 3, last + 1);
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
    Vector3d start, one, between, other;
  };
  const AnySurface slot{MeshSurface(jaws(0.001))};
  const std::array walls{
      Walls{AnySurface(MeshSurface(jaws(0.02))), {0, 0, 0}, {-0.011, 0, 0}, {0, 0, 0}, {0.011, 0, 0}},
      Walls{slot, {0, 0, 0}, {-0.0006, 0, 0}, {0, 0, 0}, {0.0006, 0, 0.001}},
      // From the top over the rim into the wall beyond the slot.
      Walls{slot, {-0.005, 0, 0.04}, {-0.005, 0, 0.029}, {0, 0, 0.029}, {0.0006, 0, 0.029}},
      Walls{AnySurface(bracket), {0.03, 0.03, 0.001}, {0.055, 0.019, 0.001}, {0.03, 0.03, 0.001}, {0.019, 0.055, 0.001}},
      // From the top of a plate, through which the finger is pressed, to what is behind it.
      Walls{AnySurface(MeshSurface(plate_and_block())), {0.02, 0, 0.01}, {0.02, 0, -0.002}, {0.033, 0, -0.005}, {0.036, 0, -0.005}},
  };
  const Patch patch = Patch::ellipse(hertz(), 0.01, 0.004);
  for (const auto& [surface, start, one, between, other] : walls) {
    const double depth = after(hertz_finger(), surface, {between, other}).depth;
    ASSERT_GT(depth, 0.0);
    for (const double mu : {0.0, 0.6}) {
      for (const SoftFinger& finger : {hertz_finger(parameters(mu)), SoftFinger(patch, parameters(mu))}) {
        const FingerOutput jumped = after(finger, surface, {start, one, other});
        const FingerOutput expected = after(finger, surface, {start, one, between, other});
        EXPECT_NEAR(jumped.load, 1000.0 * depth, 1e-9);
        EXPECT_EQ(jumped.load, expected.load);
        EXPECT_EQ(jumped.state, expected.state);
        EXPECT_TRUE(same_bits(jumped.proxy, expected.proxy) && same_bits(jumped.force, expected.force));
        EXPECT_EQ(jumped.moment, expected.moment);
      }
    }
  }
}

// A finger slides along a groove, 30 µm deep at the least, at 0.1 m/s. While its own way stays
// inside (s²/8R below that depth) it never lands, and friction is that of the load, at any rate
// and however fine the facets are. At lower rates it leaves in each sample.
TEST(Landing, AFingerThatStaysInAGrooveKeepsItsFriction) {
  constexpr double radius = 0.01, depth = 30e-6;
  for (const auto& [facet, thickness] : {std::pair(0.08, 1.0), {0.02, 1.0}, {0.005, 1.0}, {0.02, 0.002}}) {
    TriangleList list = groove(facet, thickness);
    for (Vector3d& vertex : list.vertices) vertex *= radius;
    const MeshSurface surface{Mesh(list)};
    for (const double rate : {50.0, 70.0, 80.0, 100.0, 125.0, 150.0, 1000.0}) {
      SoftFinger finger = hertz_finger();
      const double step = 0.1 / rate;
      const bool stays = step * step / (8.0 * radius) < depth;
      finger.update(surface.contact({-0.5 * radius, 3e-4, 0.5 * radius}, finger.state().contact), 0.0);
      int slides = 0;
      for (double angle = -0.9; angle < 0.9; angle += step / (radius + depth)) {
        const Vector3d place((radius + depth) * std::sin(angle), 3e-4, radius - (radius + depth) * std::cos(angle));
        const Contact contact = surface.contact(place, finger.state().contact);
        const FingerOutput output = finger.update(contact, 0.0);
        if (angle < -0.6) continue;  // until it slides
        ++slides;
        ASSERT_EQ(contact.landed, !stays) << facet << ' ' << rate << ' ' << angle;
        ASSERT_NEAR(output.force.norm(), stays ? 0.6 * output.load : 0.0, 0.01 * output.load) << facet << ' ' << rate << ' ' << angle;
      }
      EXPECT_GE(slides, 5);
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

// A star of spikes: whatever flight ends on its surface, the load is k d; and none does while the
// finger's own way stays inside.
TEST(Landing, OnAStarOfSpikes) {
  const MeshSurface star = read_mesh(data_mesh("star.obj"));
  SoftFinger finger = hertz_finger();
  Random random(29);
  Vector3d place(0.1, 0.0, 0.0);
  int landings = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d last = place;
    place = i % 2 == 0 ? anywhere(random, 0.05) : Vector3d(place + anywhere(random, 0.01));
    const Contact contact = star.contact(place, finger.state().contact);
    const FingerOutput output = finger.update(contact, 0.0);
    if (!contact.landed) continue;
    ++landings;
    ASSERT_TRUE(winding_by_search(star.mesh(), last) < 0.5 || clearly_crosses(star.mesh(), last, place)) << i;
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
