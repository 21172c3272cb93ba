// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace limitcurve::stability {

/// Friction as bristles (P. Dahl 1968; LuGre without its viscous parts), a step a sample: dz/dt = v − |v| k z/(μP), force k z.
class Bristles {
 public:
  Bristles(double stiffness, double start) : stiffness_(stiffness), last_(start) {}

  /// Friction [N] at x under the limit μP, along the motion that it resists.
  double update(double x, double limit) {
    const double moved = x - last_;
    last_ = x;
    stretch_ += moved - std::fabs(moved) * stiffness_ * stretch_ / limit;
    return stiffness_ * stretch_;
  }

 private:
  double stiffness_;
  double last_;
  double stretch_ = 0.0;
};

}  // namespace limitcurve::stability
