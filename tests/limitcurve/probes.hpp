// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/wrench.hpp"

#include <vector>

namespace limitcurve::test {

/// Slip twists from pure sliding to pure spin, the rim among them, and crowding to the rim and to both ends.
inline std::vector<SlipTwist> probes() {
  std::vector<SlipTwist> twists;
  for (int i = 0; i <= 1000; ++i) twists.push_back(SlipTwist::of_spin_fraction(i / 1000.0));
  for (double gap = 0.3; gap > 1e-17; gap *= 0.3) {
    twists.push_back({1.0 - gap, 1.0});
    twists.push_back({1.0, 1.0 - gap});
    twists.push_back({gap, 1.0});
    twists.push_back({1.0, gap});
  }
  return twists;
}

}  // namespace limitcurve::test
