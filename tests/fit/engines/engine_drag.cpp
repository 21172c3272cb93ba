// SPDX-License-Identifier: MIT
//
// engine_drag: the friction that ODE makes of one finger (Hertz, mu = 0.8, a = 5 mm, 3 N) with the
// translated coefficients, measured by dragging it about imposed centres of rotation, as CSV:
// engine,version,model,c,force,moment, with c over the radius, force and moment over their limits;
// and exact_force,exact_moment of the law there. scripts/maintain/engines/measure runs it.
#include <ode/version.h>
#include "tests/fit/engines/ode_drag.hpp"

#include <cstdio>

int main() {
  using namespace limitcurve;
  using namespace limitcurve::fit::engines;
  std::puts("engine,version,model,c,force,moment,exact_force,exact_moment");
  const fit::EngineContact contact = translated();
  const Law exact = law();
  const double moment_ratio = exact->moment_ratio();
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i) {
    // Evenly from pure slide to pure twist in the normalised plane's slip.
    const double spin = static_cast<double>(i) / steps;
    const SlipTwist twist{(1.0 - spin) * moment_ratio, spin};
    const UnitWrench found = drag_in_ode(contact, twist).wrench;
    const UnitWrench truth = exact->evaluate(twist.cor()).wrench;
    std::printf("ode,%s,box,%.6g,%.6f,%.6f,%.6f,%.6f\n", dODE_VERSION, twist.cor(), found.force, found.moment / moment_ratio, truth.force,
                truth.moment / moment_ratio);
  }
  return 0;
}
