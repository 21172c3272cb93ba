// SPDX-License-Identifier: MIT
#include "limitcurve/patch/point_sums.hpp"

#include <cmath>

// The loops exist for AVX2, too, and the loader chooses. Lanes are added in the same order, so that both give the same
// bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__)
#define LIMITCURVE_WIDE __attribute__((target_clones("default", "avx2")))
#else
#define LIMITCURVE_WIDE
#endif

namespace limitcurve::patch {

namespace {

constexpr std::size_t lanes = 8;

/// The sum of each lane.
struct LaneSums {
  double power[lanes] = {};
  double fx[lanes] = {};
  double fy[lanes] = {};
  double moment[lanes] = {};
  double inverse[lanes] = {};  ///< Σ w/√(|u|² + s²)
};

LIMITCURVE_WIDE void add_blocks(const double* __restrict x, const double* __restrict y, const double* __restrict weight,
                                std::size_t blocks, double vx, double vy, double omega, double softness,
                                LaneSums* __restrict sums) noexcept {
  for (std::size_t block = 0; block < blocks; ++block) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const std::size_t i = block * lanes + k;
      const double ux = vx - omega * y[i];
      const double uy = vy + omega * x[i];
      const double length = std::sqrt(ux * ux + uy * uy + softness);
      const double fraction = weight[i] / length;
      sums->power[k] += weight[i] * length;
      sums->fx[k] += fraction * ux;
      sums->fy[k] += fraction * uy;
      sums->moment[k] += fraction * (x[i] * uy - y[i] * ux);
      sums->inverse[k] += fraction;
    }
  }
}

double total(const double* lane) noexcept {
  return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

}  // namespace

PatchFriction sum_soft_points(const double* x, const double* y, const double* weight, std::size_t count,
                              const PatchTwist& twist, double softness) noexcept {
  LaneSums sums;
  const std::size_t blocks = count / lanes;
  add_blocks(x, y, weight, blocks, twist.vx, twist.vy, twist.omega, softness, &sums);
  for (std::size_t i = blocks * lanes; i < count; ++i) {
    const double ux = twist.vx - twist.omega * y[i];
    const double uy = twist.vy + twist.omega * x[i];
    const double length = std::sqrt(ux * ux + uy * uy + softness);
    const double fraction = weight[i] / length;
    const std::size_t k = i % lanes;
    sums.power[k] += weight[i] * length;
    sums.fx[k] += fraction * ux;
    sums.fy[k] += fraction * uy;
    sums.moment[k] += fraction * (x[i] * uy - y[i] * ux);
    sums.inverse[k] += fraction;
  }
  // d√(|u|² + ε²ω²)/dω has the term ε²ω/√… of the points' own radius beside that of the lever.
  const double own = twist.omega != 0.0 ? softness / twist.omega * total(sums.inverse) : 0.0;
  return {total(sums.power), {total(sums.fx), total(sums.fy), total(sums.moment) + own}, 0.0};
}

}  // namespace limitcurve::patch
