// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/scene/replay.hpp"

#include "tests/godobject/random_scene.hpp"

/// Replays of two fingers in random scenes that must give the same output: on every surface, with every curve,
/// projection and set of parameters.
namespace limitcurve::godobject::test::metamorphic {

inline constexpr int rows = 150;
inline constexpr double time_step = 1.0 / 1024.0;  // so that times are exact
inline constexpr double rim = 0.005;               // a contact radius [m], to convert rotations to displacements
inline constexpr double least_curvature = 1e-3;    // [m]: no finger comes nearer to a jump of a surface's normal
inline constexpr double ulp = std::numeric_limits<double>::epsilon();

struct Row {
  double time;
  std::array<DevicePose, 2> fingers;
  BodyPose body;
};

/// What two fingers feel in a row.
using Felt = std::array<SceneContact, 2>;

/// Two fingers on a body that rests, unless a test moves it.
struct Scene {
  FingerParameters finger;
  Replay start;
  std::vector<Row> rows;
  bool is_plane;
};

inline std::vector<Felt> replay(const Scene& scene, const std::vector<Row>& with) {
  Replay replay = scene.start;
  std::vector<Felt> result;
  for (const Row& row : with) {
    replay.step(row.time, row.fingers, row.body);
    result.push_back({replay.contacts()[0], replay.contacts()[1]});
  }
  return result;
}

/// A replay of the choice with two fingers.
inline ReplayOptions options_of(const Choice& choice) {
  ReplayOptions options;
  options.law = hertz();
  options.curve = choice.curve.kind;
  options.projection = choice.curve.projection;
  options.surface = choice.surface.surface;
  options.finger = choice.parameters.finger;
  options.fingers = 2;
  return options;
}

/// Calls `body(scene, felt, random)` for every choice, with two fingers that move at random on a body at rest.
inline void for_each_scene(std::uint64_t seed,
                           const std::function<void(const Scene&, const std::vector<Felt>&, Random&)>& body) {
  int slips = 0;
  int sticks = 0;
  for_each_choice(seed, [&](const Choice& choice, Random& random) {
    ReplayOptions options = options_of(choice);
    options.motion = BodyMotion::prescribed;
    Scene scene{options.finger, Replay(options), {}, choice.surface.name == "plane"};
    const std::array devices{RandomDevice(options.surface, random), RandomDevice(options.surface, random)};
    for (int i = 0; i < rows; ++i) {
      const double time = i * time_step;
      scene.rows.push_back({time, {devices[0].at(time), devices[1].at(time)}, {}});
    }
    const std::vector<Felt> felt = replay(scene, scene.rows);
    for (const Felt& row : felt) {
      for (const SceneContact& contact : row) {
        slips += contact.state == ContactState::slip;
        sticks += contact.state == ContactState::stick;
      }
    }
    body(scene, felt, random);
  });
  EXPECT_GT(slips, 2000);
  EXPECT_GT(sticks, 2000);
}

/// The map of a comparison: `place` for positions, `vector` for vectors, the sign `sense` for moments and angles.
struct Map {
  std::function<Vector3d(const Vector3d&)> place = [](const Vector3d& at) { return at; };
  std::function<Vector3d(const Vector3d&)> vector = [](const Vector3d& way) { return way; };
  double sense = 1.0;
  double turned = 0.0;  // what α_p is shifted by [rad]
};

/// That `one`, mapped, is `other` within a tolerance. The centre of rotation is the direction of a slip, whose error is
/// that of the places by the length of the slip [m]; a slip not longer than the tolerance is one in one scene and none
/// in the other.
inline void expect_alike(const Scene& scene, const SceneContact& one, double slip, const SceneContact& other,
                         const Map& map, const Tolerance& within) {
  const double least = 10.0 * (within.length + rim * within.angle);
  const bool touch = one.load > 0.0 && other.load > 0.0;
  if (!(touch && slip <= least)) {
    ASSERT_EQ(to_string(one.state), to_string(other.state));
    ASSERT_EQ(std::isnan(one.cor), std::isnan(other.cor));
  }
  ASSERT_LE((map.place(one.proxy) - other.proxy).norm(), within.length);
  ASSERT_NEAR(map.sense * one.angle + map.turned, other.angle, within.angle);
  ASSERT_NEAR(one.depth, other.depth, within.length);
  ASSERT_NEAR(one.load, other.load, within.force);
  ASSERT_LE((map.vector(one.force) - other.force).norm(), within.force);
  ASSERT_NEAR(map.sense * one.moment, other.moment, within.moment);
  ASSERT_LE((map.vector(one.normal) - other.normal).norm(), within.length / least_curvature);
  // Force times displacement in every row, and the force is at most μP.
  ASSERT_NEAR(one.dissipated, other.dissipated,
              rows * (10.0 * within.length + 0.1 * within.angle + 0.01 * within.force));
  if (one.state == ContactState::slip && slip > 10.0 * least) {
    const auto direction = [](double cor) { return std::atan2(rim, cor); };
    ASSERT_NEAR(direction(one.cor), direction(other.cor), least / slip) << one.cor << ' ' << other.cor;
  }
  const double limit = scene.finger.mu_dynamic.value_or(scene.finger.mu) * one.load;
  if (limit > 1e-3 && !scene.finger.mu_r) {
    ASSERT_NEAR(one.margin, other.margin, 10.0 * (within.force + within.moment / 0.001) / limit);
    ASSERT_NEAR(one.load_to_hold, other.load_to_hold, 10.0 * (within.force + within.moment / 0.001) / scene.finger.mu);
  }
}

/// How far a finger's proxy slid in a row [m], its turn counted at the rim.
inline double slip_in(const std::vector<Felt>& felt, std::size_t row, std::size_t finger) {
  if (row == 0 || felt[row][finger].state != ContactState::slip) return 0.0;
  const SceneContact& now = felt[row][finger];
  const SceneContact& before = felt[row - 1][finger];
  return (now.proxy - before.proxy).norm() + rim * std::fabs(now.angle - before.angle);
}

/// Compares the output at rest, with each row's own map, with another.
inline void expect_alike_by_rows(const Scene& scene, const std::vector<Felt>& one, const std::vector<Felt>& other,
                                 const std::function<Map(std::size_t)>& map, const Tolerance& within) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t finger = 0; finger < 2; ++finger) {
      SCOPED_TRACE("row " + std::to_string(i) + ", finger " + std::to_string(finger));
      expect_alike(scene, one[i][finger], slip_in(one, i, finger), other[i][finger], map(i), within);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

inline void expect_alike(const Scene& scene, const std::vector<Felt>& one, const std::vector<Felt>& other,
                         const Map& map, const Tolerance& within) {
  expect_alike_by_rows(
      scene, one, other, [&](std::size_t) { return map; }, within);
}

/// That nothing differs but the sign of a zero.
inline void expect_equal(const SceneContact& one, const SceneContact& other) {
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  ASSERT_EQ(to_string(one.state), to_string(other.state));
  ASSERT_EQ(one.proxy, other.proxy);
  ASSERT_EQ(one.angle, other.angle);
  ASSERT_EQ(one.depth, other.depth);
  ASSERT_EQ(one.load, other.load);
  ASSERT_EQ(one.force, other.force);
  ASSERT_EQ(one.moment, other.moment);
  ASSERT_TRUE(same(one.cor, other.cor));
  ASSERT_EQ(one.normal, other.normal);
  ASSERT_EQ(one.margin, other.margin);
  ASSERT_TRUE(same(one.load_to_hold, other.load_to_hold));
  for (int axis = 0; axis < 3; ++axis) ASSERT_TRUE(same(one.centre_of_rotation[axis], other.centre_of_rotation[axis]));
  ASSERT_EQ(one.dissipated, other.dissipated);
}

inline void expect_equal(const std::vector<Felt>& one, const std::vector<Felt>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t finger = 0; finger < 2; ++finger) {
      SCOPED_TRACE("row " + std::to_string(i) + ", finger " + std::to_string(finger));
      expect_equal(one[i][finger], other[i][finger]);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

/// The scene with body and fingers moved together.
inline Row moved(const Row& row, const BodyPose& by) {
  Row result = row;
  for (DevicePose& finger : result.fingers) {
    finger.position = by.position + by.orientation * finger.position;
    finger.orientation = by.orientation * finger.orientation;
  }
  result.body = by;
  return result;
}

// A position within 0.3 m is right to its ulp, some 5e-17 m, after each of the products that turn it and turn it back;
// an angle likewise to 2e-16 rad.
inline Tolerance rounding(const Scene& scene, double size = 0.3) {
  return Tolerance::of(scene.finger, time_step, ulp * size, 4.0 * ulp, rows);
}

}  // namespace limitcurve::godobject::test::metamorphic
