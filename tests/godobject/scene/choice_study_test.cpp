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

// Once ellipse/radial was recommended with an error of 0.051, and a slide followed by a twist showed 0.286.
TEST(ChoiceStudy, ATwistAfterASlideIsAmongTheMotions) {
  Scene scene;
  scene.law = parse_law("xydas-kao:k=3");
  scene.mu = 1.126;
  scene.radius_law = RadiusLaw::constant(0.007428);
  scene.least_load = scene.most_load = 2.0;
  scene.stiffness = 510.184;
  scene.twist_stiffness = 0.00468116;
  scene.slide_speed = 0.008314;
  scene.twist_rate = 0.1404;
  std::vector<StudySample> motion;
  const double slide = 8.0 * scene.mu * 2.0 / scene.stiffness;
  for (StudySample at{0.0, 0.0, 0.0, 2.0}; at.x < slide; at.x += scene.slide_speed * scene.sample_time) motion.push_back(at);
  for (StudySample at = motion.back(); at.twist < 12.0; at.twist += scene.twist_rate * scene.sample_time) motion.push_back(at);

  const StepChoice choice = choose_step(scene, 0.0858);
  const Candidate full{"table/closest-point", 1e-9, 0.0, 0.0};
  const auto right = felt(scene, named_finger(scene, full), motion);
  double of_ellipse = 0.0;
  for (const Candidate& candidate : choice.candidates) {
    const auto wrong = felt(scene, named_finger(scene, candidate), motion);
    double found = 0.0;
    for (std::size_t i = 0; i < right.size(); ++i) found = std::max(found, (right[i] - wrong[i]).norm());
    EXPECT_LE(found, candidate.error) << candidate.model;
    if (candidate.chosen) {
      EXPECT_LE(found, 0.0858) << candidate.model;
    }
    if (candidate.model == "ellipse/radial") of_ellipse = found;
  }
  EXPECT_NEAR(of_ellipse, 0.286, 5e-4);
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
