// SPDX-License-Identifier: MIT
#pragma once

#include "tests/godobject/random_scene.hpp"

/// What a user's file does with a finger. Two files hold it, one of them compiled with -ffast-math; static, so that
/// each has its own.
namespace limitcurve::godobject::test {

/// A finger's states and outputs along a path, of which every tenth sample is NaN.
struct UsersRun {
  std::vector<FingerState> states;
  std::vector<FingerOutput> outputs;
  std::vector<double> margins;
};

static inline UsersRun use(SoftFinger finger, const AnySurface& surface, const std::vector<DevicePose>& path,
                           double time_step) {
  UsersRun run;
  for (std::size_t i = 0; i < path.size(); ++i) {
    DevicePose device = path[i];
    if (i % 10 == 9) device.position.x() = std::numeric_limits<double>::quiet_NaN();
    if (i % 30 == 25) device.twist = std::numeric_limits<double>::infinity();
    run.outputs.push_back(finger.update(surface, device, time_step));
    run.states.push_back(finger.state());
    run.margins.push_back(finger.margin());
  }
  return run;
}

/// Friction by itself: the ratios of force and moment that are kept.
static inline std::array<double, 2> rub(const FingerCurve& curve, Projection projection, double force, double moment) {
  FrictionMemory<double> memory;
  const FrictionLimits<double> limits{{1.0, 0.005}, {1.0, 0.005}, 25000.0};
  const FrictionResult<double> result = apply_friction(curve.view(), projection, limits, {force, moment}, memory);
  return {result.force_fraction, result.moment_fraction};
}

/// What that file gives.
UsersRun use_with_fast_math(const SoftFinger& finger, const AnySurface& surface, const std::vector<DevicePose>& path,
                            double time_step);
std::array<double, 2> rub_with_fast_math(const FingerCurve& curve, Projection projection, double force, double moment);

/// The functions that a file's linker may share with others.
using Rub = FrictionResult<double> (*)(const CurveView<double>&, Projection, const FrictionLimits<double>&,
                                       const FrictionTrial<double>&, FrictionMemory<double>&) noexcept;
using OnRay = CurvePoint<double> (*)(const CurveView<double>&, double, double, double, double&) noexcept;
Rub rub_of_fast_math();
OnRay on_ray_of_fast_math();

}  // namespace limitcurve::godobject::test
