// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/wrench.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace limitcurve::test {

/// Degenerate, nearly degenerate, generic and seeded random twists, from pure spin to pure sliding.
inline std::vector<SlipTwist> many_twists() {
  std::vector<double> cors{0.0,  1e-300,      1e-150, 1e-16,       1e-8,
                           1e-3, 1.0 - 1e-12, 1.0,    1.0 + 1e-12, 1e3,
                           1e8,  1e16,        1e150,  1e300,       std::numeric_limits<double>::infinity()};
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> decade(-4.0, 4.0);
  for (int i = 0; i < 150; ++i) cors.push_back(std::pow(10.0, decade(random)));
  std::uniform_real_distribution<double> angle(0.0, 1.5707963);
  for (int i = 0; i < 150; ++i) cors.push_back(std::tan(angle(random)));
  std::sort(cors.begin(), cors.end());
  std::vector<SlipTwist> twists;
  for (const double cor : cors) twists.push_back(SlipTwist::about_cor(cor));
  return twists;
}

/// What a wrench takes from a twist, per μPaω: the distance along the normal.
inline double power_of(SlipTwist twist, UnitWrench wrench) {
  return twist.slide * wrench.force + twist.spin * wrench.moment;
}

}  // namespace limitcurve::test
