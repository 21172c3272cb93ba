// SPDX-License-Identifier: MIT
// From a tactile image to the slip margin: the fraction of a grip's friction that a held object uses, and the required
// grip. The usual disc in place of the image over-estimates the friction.
#include "limitcurve/patch/patch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

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
  const double needed = load_to_hold(contact, mu, weight);
  const double needed_by_disc = load_to_hold(disc, mu, weight);
  std::printf("largest moment: %.3f mN m, %.3f for the disc of equal area\n", 1e3 * mu * load * contact.moment_ratio(),
              1e3 * mu * load * disc.moment_ratio());
  std::printf("slip margin %.1f %% (disc: %.1f %%); the least grip that holds is %.2f N (disc: %.2f N)\n",
              100.0 * (1.0 - needed / load), 100.0 * (1.0 - needed_by_disc / load), needed, needed_by_disc);

  // Force and moment together need more than each alone, and less than both.
  const double force_alone = 3.0 / mu;
  const double moment_alone = 0.006 / (mu * contact.moment_ratio());
  const bool right = needed < load && needed > std::max(force_alone, moment_alone) &&
                     needed < force_alone + moment_alone && needed_by_disc < needed;
  return right ? 0 : 1;
}
