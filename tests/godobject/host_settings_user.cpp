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
  return rub(curve, projection, force, moment);
}

Rub rub_of_fast_math() {
  return &apply_friction<double, double>;
}
OnRay on_ray_of_fast_math() {
  return &point_on_ray<double, double>;
}

}  // namespace limitcurve::godobject::test
