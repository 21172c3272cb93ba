// SPDX-License-Identifier: MIT
// A replay on a mesh gives the same output if the mesh is turned or moved by a kilometre, with a delay, or with a refused row.
#include "godobject/mesh/mesh_surface.hpp"

#include "tests/godobject/metamorphic/metamorphic.hpp"
#include "tests/mesh/shapes.hpp"

#include <gtest/gtest.h>

namespace limitcurve::godobject::test {
namespace {

TEST(Metamorphic, OnAMesh) {
  Random random(51);
  int touched = 0;
  const std::array meshes{AnySurface(MeshSurface(Mesh(ball_triangles(0.03, 3)))),
                          AnySurface(MeshSurface(Mesh(box_triangles({0.03, 0.02, 0.04}))))};
  for (const AnySurface& surface : meshes) {
    for (const NamedParameters& with : all_parameters()) {
      ReplayOptions options;
      options.law = hertz();
      options.curve = CurveKind::table;
      options.surface = surface;
      options.finger = with.finger;
      options.fingers = 2;
      options.motion = BodyMotion::prescribed;
      Scene scene{options.finger, Replay(options), {}, false};
      const std::array devices{RandomDevice(surface, random), RandomDevice(surface, random)};
      for (int i = 0; i < rows; ++i) {
        const double time = i * time_step;
        scene.rows.push_back({time, {devices[0].at(time), devices[1].at(time)}, {}});
      }
      const std::vector<Felt> felt = replay(scene, scene.rows);
      for (const Felt& row : felt) touched += row[0].state == ContactState::slip || row[0].state == ContactState::stick;
      SCOPED_TRACE(with.name);

      const Eigen::Vector3d away = 1000.0 * random_direction(random);
      const BodyPose by{away, random_orientation(random)};
      std::vector<Row> far;
      std::vector<Row> later = scene.rows;
      for (const Row& row : scene.rows) far.push_back(moved(row, by));
      for (Row& row : later) row.time += 1024.0;
      const auto turn = [&](const Eigen::Vector3d& way) { return Eigen::Vector3d(by.orientation * way); };
      const auto carry = [&](const Eigen::Vector3d& at) { return Eigen::Vector3d(by.position + by.orientation * at); };
      expect_alike(scene, felt, replay(scene, far), {carry, turn}, rounding(scene, 1000.0));
      expect_equal(felt, replay(scene, later));
      if (testing::Test::HasFatalFailure()) return;
      if (with.finger.damping > 0.0) continue;
      for (const double x : {std::numeric_limits<double>::quiet_NaN(), 1.0, -1e300}) {
        const auto after = static_cast<std::ptrdiff_t>(random.uniform(0.0, rows - 1.0));
        std::vector<Row> longer = scene.rows;
        longer.insert(longer.begin() + after + 1, longer[static_cast<std::size_t>(after)]);
        for (DevicePose& finger : longer[static_cast<std::size_t>(after) + 1].fingers) finger.position.x() = x;
        std::vector<Felt> other = replay(scene, longer);
        ASSERT_EQ(to_string(other[static_cast<std::size_t>(after) + 1][0].state), "invalid");
        other.erase(other.begin() + after + 1);
        expect_equal(felt, other);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
  EXPECT_GT(touched, 1000);
}

}  // namespace
}  // namespace limitcurve::godobject::test
