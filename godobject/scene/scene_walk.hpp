// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/choose_step.hpp"

#include <vector>

namespace limitcurve::godobject {

/// A finger in a scene: where it is from where it touched down, and how hard it presses.
struct WalkSample {
  double x;      ///< [m]
  double y;      ///< [m]
  double twist;  ///< [rad]
  double load;   ///< [N]
};

/// One long motion within a scene's rates, loads and ways.
struct SceneWalk {
  std::vector<WalkSample> samples;
  /// The scene's sample time over that of the walk, where it is largest, ∈ (0, 1]. Friction knows no rate: what is sampled finely is walked in
  /// coarser steps along the same way.
  double finest_step = 0.0;
};

/// Γ, the largest friction moment at a load [N m]; `moment_ratio` is the law's m₀.
double largest_moment(const Scene& scene, double moment_ratio, double load);

/// A thousand legs, the same for the same scene. Each slides, twists, or does both in any ratio; the slide goes on, turns aside or reverses, the
/// twist goes on or reverses. Half of the legs end where the springs have forgotten how they began. Meanwhile the load stays, changes along the
/// leg or, as the leg begins, at once; some legs change the load alone. It has up to 3e5 samples, as a rule a third of that.
SceneWalk walk(const Scene& scene, double moment_ratio);

}  // namespace limitcurve::godobject
