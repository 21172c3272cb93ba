// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

/// The motions of finger_bench: endless loops of one finger.
namespace limitcurve::bench {

inline constexpr double pi = std::numbers::pi;

inline constexpr std::size_t samples = 4096;
inline constexpr std::size_t stretch_steps = 128;

enum class Motion { held, slow, wild };
inline constexpr std::array<std::pair<Motion, const char*>, 3> motions{
    {{Motion::held, "held"}, {Motion::slow, "slow"}, {Motion::wild, "wild"}}};

/// A number between −1 and 1.
class Random {
 public:
  double operator()() { return share_(engine_); }

 private:
  std::mt19937 engine_{1};
  std::uniform_real_distribution<double> share_{-1.0, 1.0};
};

/// Motion of the finger along a surface: displacement in two directions [m], depth [m] and twist [rad].
struct Sample {
  double x, y, depth, twist;
};

/// Held: trembles within the limit. Slow: slips in every step of 0.1 mm, the centre of rotation wanders once over its
/// range and back, the load changes a little. Wild: jumps of centimetres and radians in all directions, under any load.
/// At 2 mm the load is 2 N and the friction limit 1.2 N, a deflection of 1.2 mm.
inline std::vector<Sample> move(Motion motion) {
  Random random;
  std::vector<Sample> result;
  // The spin is half of the motion in the mean: so the device turns six times, and begins again where it began.
  constexpr double spin_step = 6.0 * 2.0 * pi / (0.5 * samples);
  double x = 0.0, y = 0.0, twist = 0.0;
  for (std::size_t i = 0; i < samples; ++i) {
    switch (motion) {
      case Motion::held:
        result.push_back({5e-5 * random(), 5e-5 * random(), 0.002 + 1e-4 * random(), 0.002 * random()});
        break;
      case Motion::slow: {
        const double phase = 2.0 * pi * static_cast<double>(i) / samples;
        const double u = 0.5 - 0.45 * std::cos(phase);
        x += 1e-4 * (1.0 - u) * std::cos(2.0 * phase);
        y += 1e-4 * (1.0 - u) * std::sin(2.0 * phase);
        twist += spin_step * u;
        result.push_back({x, y, 0.002 + 2e-4 * std::sin(7.0 * phase), std::remainder(twist, 2.0 * pi)});
        break;
      }
      case Motion::wild:
        result.push_back({0.01 * random(), 0.01 * random(), 0.002 + 0.001 * random(), 1.5 * random()});
        break;
    }
  }
  return result;
}

}  // namespace limitcurve::bench
