// SPDX-License-Identifier: MIT
// Compiled with -ffast-math, as a user's file may be.
#include "tests/godobject/host_settings_user.hpp"

#ifndef __FAST_MATH__
#error "compile this file with -ffast-math"
#endif

namespace limitcurve::godobject::test {

UsersRun use_with_fast_math(const SoftFinger& finger, const AnySurface& surface, const std::vector<DevicePose>& path,
                            double time_step) {
  return use(finger, surface, path, time_step);
}

std::array<double, 2> rub_with_fast_math(const FingerCurve& curve, Projection projection, double force, double moment) {
  FrictionMemory<double> memory;
  const FrictionLimits<double> limits{{1.0, 0.005}, {1.0, 0.005}, 25000.0};
  const FrictionResult<double> result = apply_friction(curve.view(), projection, limits, {force, moment}, memory);
  return {result.force_fraction, result.moment_fraction};
}

Rub rub_of_fast_math() {
  return &apply_friction<double, double>;
}
OnRay on_ray_of_fast_math() {
  return &point_on_ray<double, double>;
}

}  // namespace limitcurve::godobject::test
