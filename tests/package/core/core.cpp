// SPDX-License-Identifier: MIT
// Hertz at c = a/2: m/m₀ = 99/128 exactly.
#include "limitcurve/laws.hpp"

#include <cmath>
#include <cstdio>

int main() {
  const limitcurve::Law law = limitcurve::hertz();
  const double ratio = law->forces(0.5).moment / law->moment_ratio();
  std::printf("hertz: m(1/2)/m0 = %.16g\n", ratio);
  return std::abs(ratio - 99.0 / 128.0) < 1e-14 ? 0 : 1;
}
