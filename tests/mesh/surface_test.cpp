// SPDX-License-Identifier: MIT
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

Contact first_contact(const MeshSurface& surface, const Vector3d& finger) {
  ContactMemory memory;
  return touch(surface, finger, memory);
}

/// What holds for every contact: the point lies `depth` along the normal from the finger, the normal is of unit length.
void expect_consistent(const Contact& contact, const Vector3d& finger) {
  ASSERT_NEAR(contact.normal.norm(), 1.0, 1e-14);
  ASSERT_LT((finger + contact.normal * contact.depth - contact.point).norm(), 1e-12);
}

// A ball of 2048 triangles, corners on the sphere: its faces are inside by up to h = R(1 − cos ε), where ε is the angle that a
// face's circumcircle is seen under, and so are depth and normal.
TEST(MeshSurface, ABallIsTheSphereWithinTheChord) {
  const double radius = 0.05;
  const MeshSurface mesh(Mesh(ball_triangles(radius, 4)));
  double epsilon = 0.0;
  for (const Face& face : mesh.mesh().faces()) {
    const int number = static_cast<int>(&face - mesh.mesh().faces().data());
    epsilon =
        std::max(epsilon, std::acos(mesh.mesh().normal(number).dot(mesh.mesh().vertices()[static_cast<std::size_t>(face[0])] / radius)));
  }
  const double chord = radius * (1.0 - std::cos(epsilon));
  ASSERT_LT(chord, 3e-4);
  const SphereSurface sphere(radius);
  Random random(1);
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d finger = anywhere(random, 1.0).normalized() * random.uniform(0.3, 2.0) * radius;
    ContactMemory memory;
    const Contact exact = touch(sphere, finger, memory);
    const Contact contact = first_contact(mesh, finger);
    expect_consistent(contact, finger);
    ASSERT_LE(contact.depth, exact.depth + 1e-12);
    ASSERT_GE(contact.depth, exact.depth - chord - 1e-12);
    inside += contact.depth > 0.0;
    // Inside the normal is a face's, and the finger is beneath that face: beside its middle by the circumcircle's radius at most.
    if (contact.depth > 0.0) {
      const double beside = std::min(1.0, radius * std::sin(epsilon) / finger.norm());
      ASSERT_LE(std::acos(std::min(1.0, contact.normal.dot(exact.normal))), std::asin(beside) + 1e-7);
    }
  }
  EXPECT_GT(inside, 5000);
}

// The god-object slides along the top, over the edge to the side, round the corner, and is always on the surface.
TEST(MeshSurface, SlidesOverAnEdgeAndRoundACorner) {
  // An octagonal rod: edges of 45°, and ends.
  TriangleList rod;
  for (int i = 0; i < 8; ++i) {
    const double angle = std::numbers::pi * (0.25 * i + 0.125);
    for (const double z : {-0.03, 0.03}) rod.vertices.push_back({0.02 * std::cos(angle), 0.02 * std::sin(angle), z});
  }
  for (int i = 0; i < 8; ++i) {
    const int a = 2 * i, b = 2 * ((i + 1) % 8);
    rod.faces.push_back({a, b, b + 1});
    rod.faces.push_back({a, b + 1, a + 1});
    if (i > 0 && i < 7) rod.faces.push_back({0, b, a});
    if (i > 0 && i < 7) rod.faces.push_back({1, a + 1, b + 1});
  }
  const MeshSurface surface{Mesh(rod)};
  const double inner = 0.02 * std::cos(std::numbers::pi / 8.0);
  ContactMemory memory;
  ASSERT_LT(touch(surface, {0.025, 0.0, 0.0}, memory).depth, 0.0);
  const double depth = 0.001;
  double last = depth;
  int changes = 0;
  Vector3d normal = Vector3d::UnitX();
  for (double angle = 0.0; angle < 2.0 * std::numbers::pi; angle += 1e-3) {
    const Vector3d finger((inner - depth) * std::cos(angle), (inner - depth) * std::sin(angle), 0.01 * std::sin(3.0 * angle));
    const Contact contact = touch(surface, finger, memory);
    // Beneath a plane of the rod, never farther than the corner allows, and the normal is one of eight.
    ASSERT_GE(contact.depth, depth - 1e-12);
    ASSERT_LE(contact.depth, inner - (inner - depth) * std::cos(std::numbers::pi / 4.0));
    ASSERT_LT(distance_by_search(surface.mesh(), contact.point), 1e-12);
    const double turn = std::acos(std::min(1.0, contact.normal.dot(normal)));
    if (turn > 1e-6) {
      ++changes;
      ASSERT_NEAR(turn, std::numbers::pi / 4.0, 1e-6);
      // Over an edge of angle θ the force (depth along the normal) turns by d sin θ and no more.
      ASSERT_LE((contact.normal * contact.depth - normal * last).norm(), last * std::sin(std::numbers::pi / 4.0) + 1e-4);
    }
    normal = contact.normal;
    last = contact.depth;
  }
  EXPECT_EQ(changes, 8);
  // Round the corner to the end: out over the edge the finger is free, back in by the end it is beneath that.
  ASSERT_GT(touch(surface, {0.015, 0.0, 0.0295}, memory).depth, 0.0);
  EXPECT_LT(touch(surface, {0.015, 0.0, 0.0305}, memory).depth, 0.0);
  EXPECT_LT((touch(surface, {0.01, 0.0, 0.0295}, memory).normal - Vector3d::UnitZ()).norm(), 1e-12);
}

// In the inner edge of an L the god-object rests against both walls, and the force turns steadily from one wall's normal to the other's.
TEST(MeshSurface, TheForceIsContinuousInACrease) {
  const MeshSurface surface = read_mesh(data_mesh("bracket.stl"));
  ContactMemory memory;
  ASSERT_LT(touch(surface, {0.03, 0.03, 0.0}, memory).depth, 0.0);
  Vector3d last = Vector3d::Zero();
  bool first = true;
  int between = 0;
  const double step = 1e-6;
  for (int i = 0; i < 12000; ++i) {
    // From beneath the lower arm's top, past the crease, to behind the upper arm's side.
    const double along = -0.006 + step * i;
    const Vector3d finger =
        Vector3d(0.02, 0.02, 0.001) + (along < 0 ? Vector3d(-along, -0.002, 0.0) : Vector3d(-0.5 * along, -0.002 + along, 0.0));
    const Contact contact = touch(surface, finger, memory);
    expect_consistent(contact, finger);
    const Vector3d push = contact.normal * std::max(contact.depth, 0.0);
    if (!first) {
      ASSERT_LE((push - last).norm(), 1.2 * step) << i;
    }
    first = false;
    last = push;
    between += contact.depth > 0.0 && contact.normal.x() > 0.01 && contact.normal.y() > 0.01;
  }
  EXPECT_GT(between, 500);
}

// A cube with a pit in its top: beneath its lowest vertex a god-object is exactly at the vertex, and holds it bit for bit.
TEST(MeshSurface, RestsExactlyAtAVertex) {
  TriangleList list = box_triangles(Vector3d::Constant(0.02));
  // The top's corners are 1, 3, 5, 7.
  std::erase_if(list.faces, [](const Face& face) { return (face[0] & face[1] & face[2] & 1) != 0; });
  const Vector3d pit(0.001, 0.002, 0.013);
  list.vertices.push_back(pit);
  for (const Face& face : {Face{1, 5, 8}, Face{5, 7, 8}, Face{7, 3, 8}, Face{3, 1, 8}}) list.faces.push_back(face);
  const MeshSurface surface{Mesh(list)};
  const Vector3d vertex = surface.mesh().vertices()[8];
  Random random(10);
  ContactMemory memory;
  ASSERT_LT(touch(surface, {0.0, 0.0, 0.03}, memory).depth, 0.0);
  // At the vertex itself, then ever deeper beneath it, trembling by less than its walls give.
  ASSERT_NEAR(touch(surface, vertex, memory).depth, 0.0, 1e-12);
  SoftFinger finger = hertz_finger();
  Vector3d proxy = Vector3d::Zero();
  for (int i = 0; i < 1000; ++i) {
    const double depth = 0.001 + 1e-6 * i;
    const Vector3d place = vertex - Vector3d(0.0, 0.0, depth) + anywhere(random, 1e-4);
    const Contact contact = touch(surface, place, memory);
    expect_consistent(contact, place);
    ASSERT_TRUE(same_bits(contact.point, vertex));
    ASSERT_NEAR(contact.depth, (vertex - place).norm(), 1e-15);
    const FingerOutput output = finger.update(contact, 0.0);
    if (i == 0) proxy = output.proxy;
    ASSERT_EQ(output.state, ContactState::stick);
    ASSERT_TRUE(same_bits(output.proxy, proxy));
  }
  // Aside by more, it slides up a wall.
  EXPECT_GT((touch(surface, vertex + Vector3d(0.004, 0.0, -0.002), memory).point - vertex).norm(), 1e-3);
}

// Leaps over thousands of narrow faces in one sample, within a rod and a ball: where the god-object arrives is beneath the finger, not on the
// way there. In the rod the finger runs at 4 m/s at 1 kHz, the other way, and half a turn at once.
TEST(MeshSurface, ALongWalkArrives) {
  constexpr int sides = 4096;
  const double radius = 0.025;
  TriangleList rod;
  rod.vertices = {{0, 0, -0.05}, {0, 0, 0.05}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    for (const double z : {-0.05, 0.05}) rod.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    const int a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % sides);
    for (const Face& face : {Face{a, b, b + 1}, Face{a, b + 1, a + 1}, Face{0, b, a}, Face{1, a + 1, b + 1}}) rod.faces.push_back(face);
  }
  const MeshSurface surface{Mesh(rod)};
  SoftFinger finger = hertz_finger(parameters(0.0));
  const auto step = [&](double angle, double z) {
    const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    const FingerOutput output = finger.update(surface, {out * (radius - 0.001) + Vector3d(0, 0, z)}, 1e-3);
    ASSERT_NEAR(output.load, 1.0, 1e-4) << angle;
    ASSERT_GT(output.normal.dot(out), 0.9999) << angle;
  };
  finger.update(surface, {{0.03, 0.0, 0.0}}, 1e-3);
  double angle = 0.0;
  for (int i = 0; i < 200; ++i) step(angle += 0.004 / (radius - 0.001), 0.0);
  for (int i = 0; i < 200; ++i) step(angle -= 0.004 / (radius - 0.001), 0.001 * (i % 20));
  for (int i = 0; i < 20; ++i) step(angle += 3.0, 0.0);

  const MeshSurface ball(Mesh(ball_triangles(0.05, 6)));
  ContactMemory memory;
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Vector3d place = anywhere(random, 1.0).normalized() * 0.045;
    ASSERT_NEAR(touch(ball, place, memory).depth, 0.005, 2e-5) << i;
  }
}

// Slivers to a vertex 845 km out, almost as far as fingers may be: along them contacts are finite and on the surface, and beyond the range
// a finger is refused, as one that is not finite is, without forgetting where the god-object was.
TEST(MeshSurface, TouchesAsFarAsFingersMayBe) {
  TriangleList list;
  list.vertices = {{0, 0, 2}, {844674, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2, -1, -30}};
  list.faces = {{0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}};
  const MeshSurface surface{Mesh(list)};
  const Mesh& mesh = surface.mesh();
  Random random(13);
  ContactMemory memory;
  int touching = 0;
  int refused = 0;
  for (int i = 0; i < 10000; ++i) {
    const double along = random.uniform(-0.5, 1.5);
    const Vector3d finger = mesh.vertices()[random.bits() % 5] * (1.0 - along) + along * mesh.vertices()[1] + anywhere(random, 1.0);
    const ContactMemory before = memory;
    const Contact contact = touch(surface, finger, memory);
    ASSERT_NEAR(contact.normal.norm(), 1.0, 1e-14);
    if (finger.cwiseAbs().maxCoeff() > farthest) {
      ++refused;
      ASSERT_TRUE(std::isnan(contact.depth));
      ASSERT_TRUE(memory.face == before.face && same_bits(vector(memory.finger), vector(before.finger)));
      continue;
    }
    ASSERT_TRUE(contact.point.allFinite() && std::isfinite(contact.depth));
    ASSERT_TRUE(memory.face >= 0 || !mesh.holds(finger));
    if (memory.face < 0) continue;
    ++touching;
    ASSERT_LT(distance_by_search(mesh, contact.point), mesh.grid().step());
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(refused, 1000);
}

TEST(MeshSurface, AThinPlateIsNotPassedThrough) {
  const MeshSurface plate = read_mesh(data_mesh("plate.stl"));
  for (const bool slowly : {false, true}) {
    ContactMemory memory;
    ASSERT_LT(touch(plate, {0.005, 0.0, 0.01}, memory).depth, 0.0);
    for (double z = slowly ? 0.0005 : -0.0025; z >= -0.0025; z -= 1e-5) static_cast<void>(touch(plate, {0.005, 0.0, z}, memory));
    // 3 mm through: still below the top, wherever it goes below the plate, by steps or by jumps.
    Random random(3);
    for (int i = 0; i < 5000; ++i) {
      const Vector3d finger(random.uniform(-0.0299, 0.0299), random.uniform(-0.0199, 0.0199), -0.0025);
      const Contact contact = touch(plate, finger, memory);
      ASSERT_EQ(contact.normal, Vector3d::UnitZ());
      ASSERT_NEAR(contact.depth, 0.003, 1e-12);
      ASSERT_NEAR(contact.point.z(), 0.0005, 1e-12);
    }
    // Past its rim it is free, and comes back from below.
    ASSERT_LT(touch(plate, {0.0301, 0.0, -0.0025}, memory).depth, 0.0);
    ASSERT_LT(touch(plate, {0.0, 0.0, -0.0025}, memory).depth, 0.0);
    ASSERT_LT((touch(plate, {0.0, 0.0, 0.0025}, memory).normal + Vector3d::UnitZ()).norm(), 1e-12);
  }
}

// Two plates, one above the other: a finger that jumps off the lower one, through the upper one and beyond, is held below the upper.
TEST(MeshSurface, AFlightEndsAtWhatIsInItsWay) {
  TriangleList list = box_triangles({0.03, 0.02, 0.0005});
  for (int i = 0; i < 8; ++i) list.vertices.push_back(list.vertices[static_cast<std::size_t>(i)] + Vector3d(0.0, 0.0, 0.01));
  for (std::size_t i = 0; i < 12; ++i) list.faces.push_back({list.faces[i][0] + 8, list.faces[i][1] + 8, list.faces[i][2] + 8});
  const MeshSurface plates{Mesh(list)};
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    ContactMemory memory;
    const double x = random.uniform(-0.029, 0.029);
    const double y = random.uniform(-0.019, 0.019);
    ASSERT_LT(touch(plates, {x, y, 0.005}, memory).depth, 0.0);
    ASSERT_EQ(touch(plates, {x, y, -0.002}, memory).normal, Vector3d::UnitZ());
    const Contact contact = touch(plates, {0.9 * y, 0.5 * x, 0.015}, memory);
    ASSERT_EQ(contact.normal, -Vector3d::UnitZ());
    ASSERT_NEAR(contact.depth, 0.0055, 1e-12);
    // And back: through the lower plate, held on its top.
    ASSERT_EQ(touch(plates, {x, y, -0.02}, memory).normal, Vector3d::UnitZ());
    // Between them it is free.
    ASSERT_LT(touch(plates, {x, y, 0.006}, memory).depth, 0.0);
  }
}

// A star of spikes, slivers and creases, and a finger that moves at random, by micrometres and by jumps, often exactly to a vertex or
// along an edge. In all cases: free means outside, by the solid angle; nothing blocks a free move; contact means a
// god-object on the surface with no point near it that is closer to the finger.
TEST(MeshSurface, AMillionRandomMovesNeverFallThrough) {
  const MeshSurface surface = read_mesh(data_mesh("star.obj"));
  const Mesh& mesh = surface.mesh();
  Random random(4);
  ContactMemory memory;
  Vector3d finger(0.1, 0.0, 0.0);
  static_cast<void>(touch(surface, finger, memory));
  int touching = 0;
  int checked_free = 0;
  const auto vertex = [&] { return mesh.vertices()[static_cast<std::size_t>(random.bits() % mesh.vertices().size())]; };
  constexpr int moves = repetitions(1'000'000);
  for (int i = 0; i < moves; ++i) {
    const std::uint64_t kind = random.bits() % 64;
    if (kind == 0) {
      finger = anywhere(random, 0.1);
    } else if (kind == 1) {
      finger = vertex();
    } else if (kind == 2) {
      finger = -finger;
    } else if (kind == 3) {
      const Face& face = mesh.faces()[static_cast<std::size_t>(random.bits() % mesh.faces().size())];
      const Vector3d& a = mesh.vertices()[static_cast<std::size_t>(face[0])];
      finger = a + random.uniform(-1.0, 2.0) * (mesh.vertices()[static_cast<std::size_t>(face[1])] - a);
    } else if (kind == 4) {
      finger *= random.uniform(0.0, 1.5);
    } else {
      finger += anywhere(random, random.logarithmic(1e-13, 1e-2));
    }
    if (finger.cwiseAbs().maxCoeff() > 0.2) finger *= 0.1;
    const bool was_free = memory.face < 0;
    const Vector3d last = vector(memory.finger);
    const Contact contact = touch(surface, finger, memory);
    ASSERT_NEAR(contact.normal.norm(), 1.0, 1e-14);
    ASSERT_TRUE(contact.point.allFinite());
    touching += contact.depth > 0.0;
    if (memory.face >= 0) {
      ASSERT_EQ(contact.depth > 0.0 || mesh.holds(finger), true);
      if (i % 16 != 0) continue;
      ASSERT_LT(distance_by_search(mesh, contact.point), 1e-12);
    } else if (i % 16 == 0) {
      ++checked_free;
      // A move from free to free goes through no face, or slides off one, as over the tip of a spike.
      ASSERT_TRUE(!was_free || mesh.entry(last, finger) || !clearly_crosses(mesh, last, finger)) << i;
      const double distance = distance_by_search(mesh, finger);
      if (distance > 1e-11) {
        ASSERT_LT(std::fabs(winding_by_search(mesh, finger)), 0.5) << i;
      }
      ASSERT_NEAR(-contact.depth, distance, 1e-12);
    }
  }
  EXPECT_GT(touching, moves / 5);
  EXPECT_GT(checked_free, moves / 100);
}

}  // namespace
}  // namespace limitcurve::godobject::test
