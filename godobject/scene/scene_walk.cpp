// SPDX-License-Identifier: MIT
#include "godobject/scene/scene_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>

namespace limitcurve::godobject {

namespace {

constexpr int legs = 1000;
// Steps in the shorter of the two distances that load the springs to the limit, and in a leg. Twice as many give the
// same errors.
constexpr double resolution = 32.0;
constexpr double most_steps = 512.0;
// A finger would take a step of more than half a turn for one in the other direction [rad].
constexpr double largest_twist_step = 3.0;

/// Random numbers that are the same with every standard library.
class RandomNumbers {
 public:
  int one_of(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  double between(double low, double high) { return low + (high - low) * 0x1p-32 * static_cast<double>(engine_()); }
  /// Evenly distributed in the logarithm.
  double of_any_size(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }

 private:
  std::mt19937 engine_;
};

/// The distances that load the springs of a contact to the limit.
struct Reach {
  double radius;   ///< of a Hertz contact with the same moment [m]: a law's nominal radius may be any length
  double shorter;  ///< the shorter of a slide by μP/k_l and of the rim's path in a twist by Γ/k_r [m]
  double longer;   ///< the longer of both [m]
};

Reach reach(const Scene& scene, double moment_ratio, double load) {
  const double moment = largest_moment(scene, moment_ratio, load);
  constexpr double hertz_moment_ratio = 3.0 * std::numbers::pi / 16.0;
  const double radius = moment / (hertz_moment_ratio * scene.mu * load);
  const auto [shorter, longer] =
      std::minmax({scene.mu * load / scene.stiffness, radius * (moment / scene.twist_stiffness)});
  return {radius, shorter, longer};
}

/// Whether the longest legs have too few steps for their twists, or all together may leave where fingers are valid.
bool is_too_far(const Scene& scene, const Reach& reach) {
  const double length = 5.0 * reach.longer;
  return length > most_steps * largest_twist_step * reach.radius || length * legs > 5e5 ||
         scene.most_load / scene.stiffness > 5e5;
}

/// The change of the load in a leg.
struct LoadChange {
  double load;     ///< at the end [N]
  bool at_once;    ///< in the first step of the leg
  bool by_itself;  ///< without a slide or a twist
};

LoadChange change_load(RandomNumbers& random, const Scene& scene, double load) {
  const int kind = random.one_of(8);
  if (kind < 3) return {load, false, false};
  const int place = random.one_of(5);
  const double to = place < 2   ? scene.least_load
                    : place < 4 ? scene.most_load
                                : random.between(scene.least_load, scene.most_load);
  return {to, kind >= 6, kind == 5};
}

/// The length of a slide in a direction up to the circle of the scene's largest slide [m].
double room(const Scene& scene, const WalkSample& at, double cosine, double sine) {
  if (std::isinf(scene.slide)) return scene.slide;
  const double along = at.x * cosine + at.y * sine;
  const double square = scene.slide * scene.slide - (at.x * at.x + at.y * at.y);
  return std::max(std::sqrt(std::max(along * along + square, 0.0)) - along, 0.0);
}

}  // namespace

double largest_moment(const Scene& scene, double moment_ratio, double load) {
  return scene.mu_r ? *scene.mu_r * load : moment_ratio * scene.mu * load * scene.radius_law.radius(load);
}

SceneWalk walk(Scene scene, double moment_ratio) {
  using std::numbers::pi;
  SceneWalk result;
  // Powers of two change no bit of a wrench.
  constexpr double stiffest = 0.5e15;  // half of what a finger takes
  while (std::max(scene.stiffness, scene.twist_stiffness) <= stiffest &&
         is_too_far(scene, reach(scene, moment_ratio, scene.most_load))) {
    result.stiffening *= 2.0;
    scene.stiffness *= 2.0;
    scene.twist_stiffness *= 2.0;
    for (double* const way : {&scene.slide, &scene.slide_speed, &scene.twist, &scene.twist_rate}) *way *= 0.5;
  }
  const bool slides = scene.slide_speed > 0.0 && scene.slide > 0.0;
  const bool twists = scene.twist_rate > 0.0 && scene.twist > 0.0;
  RandomNumbers random;
  WalkSample at{0.0, 0.0, 0.0, scene.most_load};
  result.samples.push_back(at);
  double direction = 0.0;
  for (int leg = 0; leg < legs; ++leg) {
    const LoadChange change = change_load(random, scene, at.load);
    const auto [radius, shorter, longer] =
        reach(scene, moment_ratio, change.at_once ? change.load : std::max(at.load, change.load));

    // Length, and its parts in slide and twist.
    const double length = random.one_of(2) == 0 ? 5.0 * longer : random.of_any_size(0.1 * shorter, 3.0 * longer);
    const std::array parts{0.0, 0.5 * pi, random.between(0.0, 0.5 * pi)};
    const double part = parts.at(static_cast<std::size_t>(random.one_of(3)));
    double slide = slides && !change.by_itself ? length * (twists ? std::cos(part) : 1.0) : 0.0;
    double twist = twists && !change.by_itself ? length / radius * (slides ? std::sin(part) : 1.0) : 0.0;

    // Direction, within the scene's largest slide and twist.
    const std::array turns{0.0, std::copysign(0.5 * pi, random.between(-1.0, 1.0)), pi, random.between(0.0, 2.0 * pi)};
    direction += turns.at(static_cast<std::size_t>(random.one_of(4)));
    if (room(scene, at, std::cos(direction), std::sin(direction)) < 0.1 * scene.slide) direction += pi;
    const double cosine = std::cos(direction);
    const double sine = std::sin(direction);
    slide = std::min(slide, room(scene, at, cosine, sine));
    const double sense = std::fabs(at.twist) > 0.9 * scene.twist ? -at.twist : random.between(-1.0, 1.0);
    twist = std::copysign(std::min(twist, most_steps * largest_twist_step), sense);
    twist = std::clamp(at.twist + twist, -scene.twist, scene.twist) - at.twist;

    // Number of steps: that of the scene's sample time, or fewer.
    const double pace = random.of_any_size(0.25, 1.0);
    double time = 0.0;
    if (slide > 0.0) time = std::max(time, slide / (pace * scene.slide_speed));
    if (twist != 0.0) time = std::max(time, std::fabs(twist) / (pace * scene.twist_rate));
    const double samples = std::max(std::ceil(time / scene.sample_time), 1.0);
    const double enough =
        std::max(resolution * std::hypot(slide, radius * twist) / shorter, std::fabs(twist) / largest_twist_step);
    double steps = std::min({samples, std::ceil(enough), most_steps});
    steps = std::max(steps, change.by_itself ? resolution : 1.0);
    if (time > 0.0) result.finest_step = std::max(result.finest_step, steps / samples);

    const WalkSample from = at;
    for (int i = 1; i <= static_cast<int>(steps); ++i) {
      const double fraction = i / steps;
      at = {from.x + fraction * slide * cosine, from.y + fraction * slide * sine, from.twist + fraction * twist,
            change.at_once ? change.load : from.load + fraction * (change.load - from.load)};
      result.samples.push_back(at);
    }
  }
  return result;
}

}  // namespace limitcurve::godobject
