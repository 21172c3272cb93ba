// SPDX-License-Identifier: MIT
// Whether `choose_step` states errors that hold: random scenes, in each of which fingers by every candidate feel random
// motions that share nothing with the walk by which `choose_step` judges.
#include "godobject/scene/choose_step.hpp"

#include "godobject/scene/replay.hpp"
#include "tests/godobject/scene.hpp"

namespace limitcurve::godobject::test::choice_study {
namespace {

/// A finger's contact, how it may move, and how large an error may be.
struct StudyScene {
  Scene scene;
  double tolerance;
};

/// Springs that suit the law or are up to thirty times too stiff or too soft in twist, a sample time in which they are
/// wound up by a third or by a three-hundredth, one load or up to eight times as much, no slide or no twist at all, or
/// little of them.
StudyScene random_study_scene(Random& random) {
  const std::vector<std::string> laws{"hertz",
                                      "uniform",
                                      "parabolic",
                                      "flat-punch",
                                      "cone",
                                      "power:n=2.3",
                                      "power:n=-0.5",
                                      "xydas-kao:k=3",
                                      "xydas-kao:k=1",
                                      "gaussian:sigma=0.4",
                                      "mix:0.7*hertz+0.3*uniform"};
  const auto one_of = [&](int count) { return static_cast<int>(random.uniform(0.0, count)); };
  Scene scene;
  scene.law = parse_law(laws.at(static_cast<std::size_t>(one_of(static_cast<int>(laws.size())))));
  const double m0 = scene.law->moment_ratio();
  scene.mu = random.logarithmic(0.2, 1.5);
  scene.least_load = random.logarithmic(0.2, 3.0);
  scene.most_load = one_of(4) == 0 ? scene.least_load : scene.least_load * random.logarithmic(1.05, 8.0);
  const double radius = random.logarithmic(0.002, 0.012);
  scene.radius_law = one_of(2) == 0 ? RadiusLaw::constant(radius) : RadiusLaw::power(radius, random.uniform(0.05, 0.4));
  if (one_of(8) == 0) scene.mu_r = random.uniform(0.5, 1.5) * scene.mu * radius * m0;
  scene.stiffness = random.logarithmic(200.0, 3000.0);
  const double load = scene.most_load;
  const double moment = scene.mu_r ? *scene.mu_r * load : m0 * scene.mu * load * scene.radius_law.radius(load);
  scene.twist_stiffness = scene.stiffness * std::pow(moment / (scene.mu * load), 2.0) *
                          (one_of(4) == 0 ? random.logarithmic(0.03, 30.0) : random.logarithmic(0.2, 5.0));
  scene.sample_time = random.logarithmic(3e-4, 2e-3);
  const double slide = scene.mu * load / scene.stiffness;
  const double twist = moment / scene.twist_stiffness;
  scene.slide_speed = one_of(10) == 0 ? 0.0 : slide / (random.logarithmic(3.0, 300.0) * scene.sample_time);
  scene.twist_rate =
      one_of(10) == 0 && scene.slide_speed > 0.0 ? 0.0 : twist / (random.logarithmic(3.0, 300.0) * scene.sample_time);
  if (one_of(5) == 0) scene.slide = slide * random.logarithmic(0.1, 10.0);
  if (one_of(5) == 0) scene.twist = twist * random.logarithmic(0.1, 10.0);
  return {scene, random.logarithmic(2e-3, 0.4)};
}

/// A finger relative to where it touched down.
struct StudySample {
  double x;
  double y;
  double twist;
  double load;
};

/// A random motion within the scene's rates, displacements and loads, sample by sample: velocities that change again
/// and again, or turn back, or a slide and a twist in turn. The load is constant, oscillates or jumps.
std::vector<StudySample> random_motion(const Scene& scene, Random& random) {
  const auto one_of = [&](int count) { return static_cast<int>(random.uniform(0.0, count)); };
  constexpr int samples = 4000;
  const int kind = one_of(3);
  const int load_kind = one_of(3);
  const double load_speed = 6.3 / random.logarithmic(50.0, 2000.0);  // a sample
  double vx = 0.0;
  double vy = 0.0;
  double spin = 0.0;
  bool slides = false;
  double left = 0.0;
  StudySample at{0.0, 0.0, 0.0, random.uniform(scene.least_load, scene.most_load)};
  std::vector<StudySample> motion{at};
  for (int i = 0; i < samples; ++i, left -= 1.0) {
    if (left <= 0.0) {
      slides = !slides;
      const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
      const double speed = kind == 0 && !slides ? 0.0 : random.uniform(0.2, 1.0) * scene.slide_speed;
      const double twist_rate = kind == 0 && slides ? 0.0 : random.uniform(-1.0, 1.0) * scene.twist_rate;
      const bool turns_back = kind == 1 && one_of(3) > 0;
      vx = turns_back ? -vx : speed * std::cos(direction);
      vy = turns_back ? -vy : speed * std::sin(direction);
      spin = turns_back && one_of(2) == 0 ? -spin : twist_rate;
      left = random.logarithmic(20.0, 1500.0);
      if (load_kind == 2) at.load = random.uniform(scene.least_load, scene.most_load);
    }
    const StudySample next{at.x + vx * scene.sample_time, at.y + vy * scene.sample_time,
                           at.twist + spin * scene.sample_time, at.load};
    if (std::hypot(next.x, next.y) > scene.slide || std::fabs(next.twist) > scene.twist) {
      left = 0.0;
    } else {
      at = next;
    }
    if (load_kind == 1) at.load = std::lerp(scene.least_load, scene.most_load, 0.5 + 0.5 * std::sin(load_speed * i));
    motion.push_back(at);
  }
  return motion;
}

/// The rendered wrench in a motion, in units of the friction limits.
std::vector<Vector3d> felt(const Scene& scene, SoftFinger finger, const std::vector<StudySample>& motion) {
  std::vector<Vector3d> result;
  const double m0 = scene.law->moment_ratio();
  for (const StudySample& at : motion) {
    const FingerOutput output =
        finger.update({{at.x, at.y, 0.0}, Vector3d::UnitZ(), at.load / scene.stiffness}, at.twist);
    const double force = scene.mu * at.load;
    const double moment = scene.mu_r ? *scene.mu_r * at.load : m0 * force * scene.radius_law.radius(at.load);
    result.emplace_back(output.force.x() / force, output.force.y() / force, output.moment / moment);
  }
  return result;
}

/// The finger of a candidate's name, as in the manual of `choose`.
SoftFinger named_finger(const Scene& scene, const Candidate& candidate) {
  FingerParameters finger;
  finger.max_speed = infinity;
  finger.mu = scene.mu;
  finger.radius_law = scene.radius_law;
  finger.mu_r = scene.mu_r;
  finger.stiffness = scene.stiffness;
  finger.twist_stiffness = scene.twist_stiffness;
  std::string name = candidate.model;
  if (name == "no torsion") {
    finger.mu_r = 0.0;
    name = "ellipse/radial";
  }
  const std::size_t projection = name.find('/') + 1;
  if (name.ends_with("/a(P)")) {
    name.resize(name.size() - 5);
  } else {
    finger.radius_law = RadiusLaw::constant(scene.radius_law.radius(0.5 * (scene.least_load + scene.most_load)));
  }
  const CurveKind kind = parse_curve_kind(name.substr(0, projection - 1));
  const double tolerance = kind == CurveKind::table ? candidate.parameter : 1e-3;
  return {make_finger_curve(kind, scene.law, tolerance), finger, parse_projection(name.substr(projection))};
}

/// What a scene showed.
struct StudyResult {
  double worst_of_all = 0.0;      ///< found error over stated error, of any candidate
  double worst_of_chosen = 0.0;   ///< of the chosen one
  bool cheaper_would_do = false;  ///< one that is cheaper than the full step stayed below half the tolerance
  bool cheaper_is_chosen = false;
  std::string worst_model = {};
  std::string chosen = {};
};

StudyResult study(const Scene& scene, double tolerance, int motions, Random& random) {
  const StepChoice choice = choose_step(scene, tolerance);
  constexpr double reference_error = 1e-9;
  const SoftFinger first = named_finger(scene, choice.candidates.front());
  FingerParameters full = first.parameters();
  full.radius_law = scene.radius_law;
  full.mu_r = scene.mu_r;
  const SoftFinger truth(finest_table(scene.law, reference_error), full);
  std::vector<SoftFinger> fingers;
  for (const Candidate& candidate : choice.candidates) fingers.push_back(named_finger(scene, candidate));
  std::vector<double> found(fingers.size(), 0.0);
  for (int i = 0; i < motions; ++i) {
    const auto motion = random_motion(scene, random);
    const auto right = felt(scene, truth, motion);
    for (std::size_t k = 0; k < fingers.size(); ++k) {
      const auto wrong = felt(scene, fingers[k], motion);
      for (std::size_t j = 0; j < right.size(); ++j) found[k] = std::max(found[k], (right[j] - wrong[j]).norm());
    }
  }
  // The step of which nothing is left out.
  double full_cost = 0.0;
  for (const Candidate& candidate : choice.candidates) {
    if (candidate.model.starts_with("table/closest-point")) full_cost = std::max(full_cost, candidate.nanoseconds);
  }
  StudyResult result;
  for (std::size_t k = 0; k < fingers.size(); ++k) {
    const Candidate& candidate = choice.candidates[k];
    // The reference is off by its own error, and springs that are far from equal show it larger.
    const double ratio = std::max(found[k] - 100.0 * reference_error, 0.0) / candidate.error;
    if (ratio > result.worst_of_all) {
      result.worst_of_all = ratio;
      result.worst_model = candidate.model;
    }
    if (candidate.chosen) {
      result.worst_of_chosen = ratio;
      result.chosen = candidate.model;
      result.cheaper_is_chosen = candidate.nanoseconds < full_cost && candidate.error <= tolerance;
    }
    if (candidate.nanoseconds < full_cost && found[k] < 0.5 * tolerance) result.cheaper_would_do = true;
  }
  return result;
}

TEST(ChoiceStudy, TheStatedErrorHoldsInRandomMotionsAndIsNotTooLarge) {
  const int scenes = study_cases(200);
  int cheaper_would_do = 0;
  int cheaper_is_chosen = 0;
  for (int seed = 1; seed <= scenes; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) * 7919 + 17);
    const auto [scene, tolerance] = random_study_scene(random);
    const StudyResult result = study(scene, tolerance, 20, random);
    EXPECT_LE(result.worst_of_all, 1.0) << "scene " << seed << ", " << result.worst_model;
    EXPECT_LE(result.worst_of_chosen, 1.0) << "scene " << seed << ", " << result.chosen;
    if (!result.cheaper_would_do) continue;
    ++cheaper_would_do;
    if (result.cheaper_is_chosen) ++cheaper_is_chosen;
  }
  EXPECT_GT(cheaper_would_do, scenes / 5);
  EXPECT_GE(cheaper_is_chosen, 0.7 * cheaper_would_do);
}

// Radii that are equal at the least and the most load and not between them: a table of the mean load was chosen, 17 and
// 81 % off.
TEST(ChoiceStudy, ARadiusThatVariesBetweenTheLoadsCounts) {
  for (const double middle : {0.0052, 0.006}) {
    Scene scene;
    scene.law = hertz();
    scene.mu = 0.6;
    scene.stiffness = 1000.0;
    scene.twist_stiffness = 1000.0 * 0.006 * 0.006 * 0.589 * 0.589;
    scene.radius_law = RadiusLaw::sampled(std::vector<LoadSample>{{0.5, 0.005}, {1.0, middle}, {2.0, 0.005}});
    Random random(1);
    const StudyResult result = study(scene, 0.02, 3, random);
    EXPECT_EQ(result.chosen, "table/closest-point/a(P)");
    EXPECT_LE(result.worst_of_chosen, 1.0) << middle;
  }
}

// The chosen step is one that a replay runs, and it is the one that its name says.
TEST(ChoiceStudy, WhatIsChosenCanBeReplayed) {
  for (std::uint64_t seed = 301; seed <= 310; ++seed) {
    Random random(seed);
    const auto [scene, tolerance] = random_study_scene(random);
    const StepChoice choice = choose_step(scene, tolerance);
    const auto best =
        std::find_if(choice.candidates.begin(), choice.candidates.end(), [](const auto& one) { return one.chosen; });
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
}  // namespace limitcurve::godobject::test::choice_study
