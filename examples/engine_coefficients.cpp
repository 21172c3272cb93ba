// SPDX-License-Identifier: MIT
// Which coefficient does MuJoCo need, and which error remains? For a silicone fingertip: mu = 0.8, a = 4 mm at 2 N,
// growing as P^(1/3).
#include "limitcurve/engines/engine_coefficients.hpp"
#include "limitcurve/laws.hpp"

#include <cmath>
#include <cstdio>

int main() {
  const limitcurve::Law law = limitcurve::hertz();
  const auto radius_law = limitcurve::RadiusLaw::power(0.004 / std::cbrt(2.0), 1.0 / 3.0);
  bool right = false;
  for (const auto& contact : limitcurve::engines::translate(law, radius_law, 0.8, 2.0, {1.0, 4.0})) {
    std::printf("%s, a %s: off by up to %.0f %% from 1 to 4 N\n", contact.engine.c_str(), contact.model.c_str(),
                100.0 * contact.max_error_over_loads);
    for (const auto& coefficient : contact.coefficients) {
      std::printf("  %-45s %.6g\n", coefficient.parameter.c_str(), coefficient.value);
      // Torsional friction in MuJoCo is the radius at which the moment limit is mu_r P: m0 mu a, and m0 of Hertz is 3
      // pi/16.
      if (contact.engine == "mujoco" && coefficient.parameter == "geom.friction[1]")
        right = std::abs(coefficient.value - 3.0 * 3.14159265358979 / 16.0 * 0.8 * 0.004) < 1e-12;
    }
  }
  return right ? 0 : 1;
}
