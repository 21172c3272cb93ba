// SPDX-License-Identifier: MIT
// What a replay must feel alike: a scene that is turned, carried a kilometre away, mirrored, delayed, or moved as a
// whole, on every surface, with every curve, projection and set of parameters.
#include "tests/godobject/scene/metamorphic/metamorphic.hpp"

namespace limitcurve::godobject::test::metamorphic {
namespace {

TEST(Metamorphic, ATurnedSceneFeelsTheSame) {
  for_each_scene(1, [](const Scene& scene, const std::vector<Felt>& felt, Random& random) {
    const BodyPose by{Vector3d::Zero(), random_orientation(random)};
    std::vector<Row> turned;
    for (const Row& row : scene.rows) turned.push_back(moved(row, by));
    const auto turn = [&](const Vector3d& way) { return Vector3d(by.orientation * way); };
    expect_alike(scene, felt, replay(scene, turned), {turn, turn}, rounding(scene));
  });
}

// A kilometre away positions are resolved to 1.1e-13 m. The body's frame is exact; on the plane, without a body, so is
// the depth.
TEST(Metamorphic, ASceneAKilometreAwayFeelsTheSame) {
  for_each_scene(2, [](const Scene& scene, const std::vector<Felt>& felt, Random& random) {
    const Vector3d away = 1000.0 * random_direction(random);
    const auto carried = [&](const Vector3d& at) { return Vector3d(at + away); };
    const auto same = [](const Vector3d& way) { return way; };
    std::vector<Row> far;
    for (const Row& row : scene.rows) far.push_back(moved(row, {away, Quaterniond::Identity()}));
    expect_alike(scene, felt, replay(scene, far), {carried, same}, rounding(scene, 1000.0));
    if (!scene.is_plane || testing::Test::HasFatalFailure()) return;
    const Vector3d along(away.x(), away.y(), 0.0);
    std::vector<Row> on_plane = scene.rows;
    for (Row& row : on_plane) {
      for (DevicePose& finger : row.fingers) finger.position += along;
    }
    const auto slid = [&](const Vector3d& at) { return Vector3d(at + along); };
    expect_alike(scene, felt, replay(scene, on_plane), {slid, same}, rounding(scene, 1000.0));
  });
}

// All these surfaces are their own mirror image at x = 0. No number is rounded otherwise, but sums may be added in
// another order.
TEST(Metamorphic, AMirroredSceneFeelsMirrored) {
  for_each_scene(3, [](const Scene& scene, const std::vector<Felt>& felt, Random&) {
    const auto mirror = [](const Vector3d& way) { return Vector3d(-way.x(), way.y(), way.z()); };
    std::vector<Row> mirrored = scene.rows;
    for (Row& row : mirrored) {
      for (DevicePose& finger : row.fingers) {
        finger.position = mirror(finger.position);
        const Quaterniond& turn = finger.orientation;
        finger.orientation = Quaterniond(turn.w(), turn.x(), -turn.y(), -turn.z());
        finger.twist = -finger.twist;
      }
    }
    expect_alike(scene, felt, replay(scene, mirrored), {mirror, mirror, -1.0}, rounding(scene));
  });
}

// Times are multiples of 1/1024 s: time steps are the same to the last bit.
TEST(Metamorphic, ALaterSceneFeelsTheSame) {
  for_each_scene(4, [](const Scene& scene, const std::vector<Felt>& felt, Random& random) {
    const double later = 1024.0 * std::floor(random.uniform(-1000.0, 1000.0));
    std::vector<Row> shifted = scene.rows;
    for (Row& row : shifted) row.time += later;
    expect_equal(felt, replay(scene, shifted));
  });
}

// What a device calls its own zero, any turn of it about any of its axes, does not matter; a twist that begins
// elsewhere only shifts α.
TEST(Metamorphic, TheZeroOfTheDevicesAnglesDoesNotMatter) {
  for_each_scene(5, [](const Scene& scene, const std::vector<Felt>& felt, Random& random) {
    const Quaterniond yaw(AngleAxisd(random.uniform(-3.0, 3.0), Vector3d::UnitZ()));
    const Quaterniond any = random_orientation(random);
    for (const Quaterniond& zero : {yaw, any}) {
      std::vector<Row> other = scene.rows;
      for (Row& row : other) {
        for (DevicePose& finger : row.fingers) finger.orientation = finger.orientation * zero;
      }
      expect_alike(scene, felt, replay(scene, other), {}, rounding(scene));
    }
    const double shift = random.uniform(-2.0, 2.0);
    std::vector<Row> other = scene.rows;
    for (Row& row : other) {
      for (DevicePose& finger : row.fingers) finger.twist += shift;
    }
    Map map;
    map.turned = shift;
    expect_alike(scene, felt, replay(scene, other), map, rounding(scene));
  });
}

// The body is carried about with the fingers on it, 0.3 m and half a turn to and fro.
TEST(Metamorphic, ABodyMovedWithItsFingersFeelsLikeOneAtRest) {
  for_each_scene(6, [](const Scene& scene, const std::vector<Felt>& felt, Random& random) {
    const std::array<Wave, 4> waves{Wave(random, 0.0, 0.3, 1.0, 20.0), Wave(random, 0.0, 0.3, 1.0, 20.0),
                                    Wave(random, 0.0, 0.3, 1.0, 20.0), Wave(random, 0.0, 3.0, 1.0, 20.0)};
    const Vector3d axis = random_direction(random);
    const auto pose = [&](double time) {
      return BodyPose{{waves[0].at(time), waves[1].at(time), waves[2].at(time)},
                      Quaterniond(AngleAxisd(waves[3].at(time), axis))};
    };
    std::vector<Row> carried;
    for (const Row& row : scene.rows) carried.push_back(moved(row, pose(row.time)));
    const auto map = [&](std::size_t row) {
      const BodyPose at = pose(scene.rows[row].time);
      return Map{[at](const Vector3d& place) { return Vector3d(at.position + at.orientation * place); },
                 [at](const Vector3d& way) { return Vector3d(at.orientation * way); }};
    };
    expect_alike_by_rows(scene, felt, replay(scene, carried), map, rounding(scene, 1.0));
  });
}

}  // namespace
}  // namespace limitcurve::godobject::test::metamorphic
