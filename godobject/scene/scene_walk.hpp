// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/scene/choose_step.hpp"

#include <vector>

namespace limitcurve::godobject {

/// A sample of a test motion: the finger's position and twist since the touch-down, and its load.
struct WalkSample {
  double x;      ///< [m]
  double y;      ///< [m]
  double twist;  ///< [rad]
  double load;   ///< [N]
};

/// A long test motion within a scene's rates, loads and distances.
struct SceneWalk {
  std::vector<WalkSample> samples;
  /// The largest ratio of the scene's sample time to that of the test motion, ∈ (0, 1]. Friction does not depend on
  /// rates, so a finely sampled motion is tested with larger steps along the same path.
  double finest_step = 0.0;
  /// The test motion is of springs that are so many times as stiff as the scene's, which slide and twist so many times
  /// less far to the same wrenches: very soft ones would leave the 1e6 m and rad where fingers are valid.
  double stiffening = 1.0;
};

/// Γ, the largest friction moment at a load [N m]; `moment_ratio` is the law's m₀.
double largest_moment(const Scene& scene, double moment_ratio, double load);

/// The test motion of a scene: a thousand random legs, the same for the same scene. Each leg slides, twists, or does
/// both in some ratio; the slide goes on, turns aside or reverses, the twist goes on or reverses. Half of the legs are
/// so long that the wrench no longer depends on their start. The load stays, changes along the leg, or changes at its
/// start; some legs change the load only. Up to 3e5 samples, usually a third of that.
SceneWalk walk(Scene scene, double moment_ratio);

}  // namespace limitcurve::godobject
