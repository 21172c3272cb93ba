// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"
#include "godobject/contact_law.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

/// The finger whose steps are timed and counted, and how it moves.
namespace limitcurve::godobject::bench {

/// At 2 mm depth it bears 2 N, of which friction takes 1.2 N: 1.2 mm of sliding.
inline FingerParameters parameters() {
  FingerParameters result;
  result.mu = 0.6;
  result.radius_law = RadiusLaw::constant(0.005);
  result.stiffness = 1000.0;
  result.twist_stiffness = 0.04;
  return result;
}

/// What one step is given: contact and twist [rad].
struct Sample {
  Contact contact;
  double twist;
};

/// A finger at (x, y), `depth` beneath the plane z = 0 [m].
inline Contact on_plane(double x, double y, double depth) {
  return {{x, y, 0.0}, Eigen::Vector3d::UnitZ(), depth};
}

/// Slides and twists so that the centre of rotation wanders slowly over the whole range: every step slips.
inline std::vector<Sample> slow_motion(std::size_t count) {
  std::vector<Sample> samples;
  double x = 0.0;
  double twist = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = 0.5 - 0.45 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count));
    x += 1e-4 * (1.0 - u);
    twist += 1e-4 * u / 0.005;
    samples.push_back({on_plane(x, 0.0, 0.002), twist});
  }
  return samples;
}

}  // namespace limitcurve::godobject::bench
