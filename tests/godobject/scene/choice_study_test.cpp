// SPDX-License-Identifier: MIT
#include "tests/godobject/scene/choice_study.hpp"

#include "godobject/scene/replay.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

namespace limitcurve::godobject::test {
namespace {

TEST(ChoiceStudy, TheStatedErrorHoldsInRandomMotionsAndIsNotTooLarge) {
  const int scenes = study_cases(200);
  int cheaper_would_do = 0;
  int cheaper_is_chosen = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    const StudyResult result = study_scene(static_cast<std::uint64_t>(seed), 20);
    EXPECT_LE(result.worst_of_all, 1.0) << "scene " << seed << ", " << result.worst_model;
    EXPECT_LE(result.worst_of_chosen, 1.0) << "scene " << seed << ", " << result.chosen;
    if (!result.cheaper_would_do) continue;
    ++cheaper_would_do;
    if (result.cheaper_is_chosen) ++cheaper_is_chosen;
  }
  EXPECT_GT(cheaper_would_do, scenes / 5);
  EXPECT_GE(cheaper_is_chosen, 0.7 * cheaper_would_do);
}

// The chosen step is one that a replay runs, and it is the one that its name says.
TEST(ChoiceStudy, WhatIsChosenCanBeReplayed) {
  for (std::uint64_t seed = 301; seed <= 310; ++seed) {
    Random random(seed);
    const auto [scene, tolerance] = random_study_scene(random);
    const StepChoice choice = choose_step(scene, tolerance);
    const auto best = std::find_if(choice.candidates.begin(), choice.candidates.end(), [](const auto& one) { return one.chosen; });
    SoftFinger finger = named_finger(scene, *best);
    ASSERT_TRUE(choice.chosen);
    Replay replay(*choice.chosen);
    double time = 0.0;
    for (const StudySample& at : random_motion(scene, random)) {
      DevicePose pose;
      pose.position = {at.x, at.y, -at.load / scene.stiffness};
      pose.twist = at.twist;
      replay.step(time, {&pose, 1});
      time += scene.sample_time;
      const FingerOutput output = finger.update(AnySurface(PlaneSurface{}), pose);
      ASSERT_EQ(replay.contacts().front().force, output.force) << best->model;
      ASSERT_EQ(replay.contacts().front().moment, output.moment) << best->model;
    }
  }
}

}  // namespace
}  // namespace limitcurve::godobject::test
