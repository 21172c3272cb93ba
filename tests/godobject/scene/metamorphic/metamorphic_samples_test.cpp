// SPDX-License-Identifier: MIT
// What a replay must feel alike: a scene that is sampled otherwise, by repeated samples, halved steps and a row that is
// refused, on every surface, with every curve, projection and set of parameters.
#include "tests/godobject/scene/metamorphic/metamorphic.hpp"

namespace limitcurve::godobject::test::metamorphic {
namespace {

// A sample that is repeated, at once or later, changes nothing, whether the finger sticks or slips; but for dampers,
// which feel that the finger has stopped. The inserted rows are not compared: a finger that repeats its position does
// not slip.
TEST(Metamorphic, ARepeatedSampleChangesNothing) {
  for_each_scene(8, [](const Scene& scene, const std::vector<Felt>& felt, Random& random) {
    if (scene.finger.damping > 0.0) return;
    std::vector<Row> longer;
    std::vector<std::size_t> own;
    for (const Row& row : scene.rows) {
      own.push_back(longer.size());
      longer.push_back(row);
      while (random.uniform(0.0, 1.0) < 0.5) {
        longer.push_back(row);
        longer.back().time += random.uniform(0.0, 1.0) < 0.5 ? 0.0 : 0.25 * time_step;
        if (longer.back().time < longer[longer.size() - 2].time) longer.back().time = longer[longer.size() - 2].time;
      }
    }
    const std::vector<Felt> all = replay(scene, longer);
    std::vector<Felt> found;
    for (const std::size_t i : own) found.push_back(all[i]);
    expect_alike(scene, felt, found, {}, rounding(scene));
  });
}

// A step in two halves is the same step where the finger rests. Its twist is the path's integral of the spin: the mean
// of two normals stands for all between, which errs by at most a quarter of what they differ by.
TEST(Metamorphic, AStepInTwoHalvesIsTheSameWhereNothingSlips) {
  int halved = 0;
  for_each_scene(9, [&](const Scene& scene, const std::vector<Felt>& felt, Random&) {
    if (scene.finger.damping > 0.0) return;
    const auto rests = [](const Felt& row) {
      return row[0].state == ContactState::stick && row[1].state == ContactState::stick;
    };
    double spin_error = 0.0;
    Replay whole = scene.start;
    for (std::size_t i = 0; i < felt.size(); ++i) {
      const Row& row = scene.rows[i];
      if (i > 0 && rests(felt[i - 1]) && rests(felt[i])) {
        const Row& before = scene.rows[i - 1];
        Row middle = before;
        middle.time = 0.5 * (before.time + row.time);
        for (std::size_t finger = 0; finger < 2; ++finger) {
          const DevicePose& from = before.fingers[finger];
          const DevicePose& to = row.fingers[finger];
          middle.fingers[finger] = {0.5 * (from.position + to.position), from.orientation.slerp(0.5, to.orientation),
                                    0.5 * (from.twist + to.twist)};
        }
        Replay half = whole;
        half.step(middle.time, middle.fingers);
        const Felt at_half{half.contacts()[0], half.contacts()[1]};
        if (rests(at_half)) {
          half.step(row.time, row.fingers);
          whole.step(row.time, row.fingers);
          for (std::size_t finger = 0; finger < 2; ++finger) {
            const double turn = before.fingers[finger].orientation.angularDistance(row.fingers[finger].orientation);
            spin_error = 0.25 * turn * (felt[i][finger].normal - felt[i - 1][finger].normal).norm();
            if (!(spin_error < 1e-4)) continue;
            Tolerance within = rounding(scene);
            within.angle += spin_error;
            within.moment += scene.finger.twist_stiffness * spin_error;
            SCOPED_TRACE("row " + std::to_string(i) + ", finger " + std::to_string(finger));
            const SceneContact& one = whole.contacts()[finger];
            const SceneContact& other = half.contacts()[finger];
            if (other.state != ContactState::stick) continue;  // at the limit, but for the error of the spin
            expect_alike(scene, one, 0.0, other, {}, within);
            if (testing::Test::HasFatalFailure()) return;
            ++halved;
          }
          continue;
        }
      }
      whole.step(row.time, row.fingers);
    }
  });
  EXPECT_GT(halved, 500);
}

/// A row that must be refused: a place that is not finite, one farther than a finger moves in a sample, an orientation
/// that is none, a body nowhere, a time that is over.
Row refused(const Row& like, int how) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Row row = like;
  for (DevicePose& finger : row.fingers) {
    if (how == 0) finger.position.x() = nan;
    if (how == 1) finger.position += Vector3d(0.3, -0.7, 0.2);
    if (how == 2) finger.position.z() = -inf;
    if (how == 3) finger.orientation = Quaterniond(0.0, 0.0, 0.0, 0.0);
    if (how == 4) finger.twist = nan;
    if (how == 5) finger.position *= 1e200;
  }
  if (how == 6) row.body.position.y() = nan;
  if (how == 7) row.body.orientation = Quaterniond(nan, 0.0, 0.0, 1.0);
  if (how == 8) row.time = -1.0;
  if (how == 9) row.time = nan;
  return row;
}
constexpr int kinds_of_refusal = 10;

// One refused row after any row but before the first: it is `invalid`, and nothing that follows differs. Dampers only:
// the step after it knows no velocity; where the finger sticks, the one after that is as it was.
TEST(Metamorphic, ARefusedRowLeavesNoTrace) {
  for_each_scene(10, [](const Scene& scene, const std::vector<Felt>& felt, Random& random) {
    for (int how = 0; how < kinds_of_refusal; ++how) {
      const auto after = static_cast<std::size_t>(random.uniform(0.0, rows - 1.0));
      SCOPED_TRACE("refused " + std::to_string(how) + " after row " + std::to_string(after));
      std::vector<Row> longer = scene.rows;
      longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(after) + 1, refused(scene.rows[after], how));
      std::vector<Felt> other = replay(scene, longer);
      const Felt& held = other[after + 1];
      for (std::size_t finger = 0; finger < 2; ++finger) {
        ASSERT_EQ(to_string(held[finger].state), "invalid");
        ASSERT_EQ(held[finger].force, felt[after][finger].force);
        ASSERT_EQ(held[finger].moment, felt[after][finger].moment);
        ASSERT_EQ(held[finger].load, felt[after][finger].load);
        ASSERT_EQ(held[finger].proxy, felt[after][finger].proxy);
      }
      other.erase(other.begin() + static_cast<std::ptrdiff_t>(after) + 1);
      if (scene.finger.damping == 0.0) {
        expect_equal(felt, other);
        if (testing::Test::HasFatalFailure()) return;
        continue;
      }
      for (std::size_t finger = 0; finger < 2; ++finger) {
        bool as_before = true;
        for (std::size_t i = 0; i < felt.size() && as_before; ++i) {
          SCOPED_TRACE("row " + std::to_string(i) + ", finger " + std::to_string(finger));
          if (i == after + 1) {
            // A finger that slid, or would have, has another proxy from here on.
            as_before =
                felt[i][finger].proxy == other[i][finger].proxy && felt[i][finger].angle == other[i][finger].angle;
            continue;
          }
          expect_alike(scene, felt[i][finger], 0.0, other[i][finger], {}, rounding(scene));
          if (testing::Test::HasFatalFailure()) return;
        }
      }
    }
  });
}

}  // namespace
}  // namespace limitcurve::godobject::test::metamorphic
