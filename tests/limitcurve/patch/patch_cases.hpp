// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch/patch.hpp"
#include "patch_reference.hpp"
#include "tests/limitcurve/shared.hpp"

/// Outlines and twists for the tests of patches.
namespace limitcurve::test {

using Outline = std::vector<PatchPoint>;

inline PatchTwist about(PatchPoint cor, double omega = 1.0) {
  return {omega * cor.y, -omega * cor.x, omega};
}

inline Outline rectangle(double x, double y) {
  return {{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}};
}

inline const Outline ell{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};

inline Outline star(std::size_t points, double inner) {
  Outline vertices;
  for (std::size_t i = 0; i < 2 * points; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double r = i % 2 == 0 ? 1.0 : inner;
    vertices.push_back({0.3 + r * std::cos(angle), -2.0 + r * std::sin(angle)});
  }
  return vertices;
}

/// CORs near, on the rim's scale and far away, in all directions, of a patch of radius 1; seeded.
inline std::vector<PatchTwist> twists(double radius, std::size_t count, double least = -4.0, double most = 6.0) {
  std::mt19937 bits(12);
  const auto uniform = [&bits] { return std::generate_canonical<double, 53>(bits); };
  std::vector<PatchTwist> made;
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = radius * std::pow(10.0, least + (most - least) * uniform());
    const double angle = 2.0 * std::numbers::pi * uniform();
    made.push_back(about({distance * std::cos(angle), distance * std::sin(angle)}, uniform() < 0.5 ? -1.0 : 1.0));
  }
  return made;
}

/// The error that the patch states for a twist about its centre.
inline double stated(const Patch& patch, const PatchTwist& twist) {
  const PatchPoint c = patch.centre();
  return patch.about_origin({twist.vx + twist.omega * c.y, twist.vy - twist.omega * c.x, twist.omega}).error;
}

/// Against brute force: within `bound`, and within the error that the patch states, but for the reference's own.
inline void expect_exact(const Patch& patch, const PatchTwist& twist, const PatchFriction& exact, double bound,
                         double own = 0.0) {
  const double error = difference(patch.evaluate(twist), exact, patch.moment_ratio());
  EXPECT_LE(error, std::min(bound, stated(patch, twist)) + own) << twist.vx << ' ' << twist.vy << ' ' << twist.omega;
}

/// What the reference of polygons loses where long double is double.
inline constexpr double witness_error = accuracy::has_extended ? 0.0 : 1e-13;

}  // namespace limitcurve::test
