// SPDX-License-Identifier: MIT
// From a tactile image to the slip margin: the fraction of a grip's friction that a held object uses, and the required grip. The usual
// disc in place of the image over-estimates the friction.
#include "limitcurve/patch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>
#include <vector>

namespace {

/// The fraction of friction that a wrench about the centre of pressure uses: the largest W·T/(μP H(T)) over all twists, by a search over
/// directions with shrinking steps. (A control loop uses `margin` and `load_to_hold` of godobject/soft_finger.hpp.)
double used(const limitcurve::Patch& patch, const limitcurve::PatchWrench& wrench, double friction) {
  const double arm = patch.moment_ratio();
  double azimuth = std::atan2(wrench.fy, wrench.fx);
  double height = std::atan2(wrench.moment / arm, std::hypot(wrench.fx, wrench.fy));
  const auto share = [&](double a, double h) {
    const limitcurve::PatchTwist twist{std::cos(h) * std::cos(a), std::cos(h) * std::sin(a), std::sin(h) / arm};
    return (wrench.fx * twist.vx + wrench.fy * twist.vy + wrench.moment * twist.omega) / (friction * patch.power(twist));
  };
  double best = share(azimuth, height);
  for (double step = 0.5; step > 1e-7;) {
    const double before = best;
    for (const auto& [da, dh] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
      const double there = share(azimuth + da, height + dh);
      if (there <= best) continue;
      best = there;
      azimuth += da;
      height += dh;
    }
    if (best == before) step /= 2.0;
  }
  return best;
}

}  // namespace

int main() {
  // A tactile pad of 12 × 8 taxels of 1 mm on an oblique edge: a long, narrow contact.
  constexpr int columns = 12;
  constexpr int rows = 8;
  std::vector<double> pressures;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double across = (row - 3.5) - 0.3 * (column - 5.5);
      const double along = column - 5.5;
      pressures.push_back(std::max(0.0, 1.0 - across * across / 4.0 - along * along / 36.0));
    }
  }
  const limitcurve::Patch contact = limitcurve::Patch::image(pressures, columns, 1e-3);
  const limitcurve::Patch::RoundMeasures round = contact.round_measures();
  const double radius = std::sqrt(round.area / std::numbers::pi);
  const limitcurve::Patch disc = limitcurve::Patch::ellipse(round.law, radius, radius);

  // It holds 3 N of weight beside its centre under a grip of 10 N.
  const double mu = 0.5;
  const double load = 10.0;
  const limitcurve::PatchWrench weight{0.0, -3.0, 0.006};
  const double share = used(contact, weight, mu * load);
  const double share_of_disc = used(disc, weight, mu * load);
  std::printf("largest moment: %.3f mN m, %.3f for the disc of equal area\n", 1e3 * mu * load * contact.moment_ratio(),
              1e3 * mu * load * disc.moment_ratio());
  std::printf("slip margin %.1f %% (disc: %.1f %%); the least grip that holds is %.2f N (disc: %.2f N)\n", 100.0 * (1.0 - share),
              100.0 * (1.0 - share_of_disc), load * share, load * share_of_disc);

  // Friction is proportional to the grip; the margin includes force and moment together.
  const double again = used(contact, weight, mu * load * share);
  const double force_alone = 3.0 / (mu * load);
  const double moment_alone = 0.006 / (mu * load * contact.moment_ratio());
  const bool right = std::abs(again - 1.0) < 1e-6 && share < 1.0 && share > std::max(force_alone, moment_alone) &&
                     share < force_alone + moment_alone && share_of_disc < share;
  return right ? 0 : 1;
}
