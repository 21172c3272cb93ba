// SPDX-License-Identifier: MIT
// Job 3, drive: a finger pressed on a plane slides straight on and turns, v/ω = a, in a 1 kHz loop. Its wrench settles
// at that of eq. (17) for c = a.
#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <cmath>
#include <cstdio>

namespace lc = limitcurve;
namespace god = limitcurve::godobject;

int main() {
  const lc::Law law = lc::hertz();
  const god::FingerParameters parameters{
      .mu = 0.6, .radius_law = lc::RadiusLaw::constant(0.005), .stiffness = 1000.0, .twist_stiffness = 0.025};
  god::SoftFinger finger(lc::Table::build(law, 1e-8), parameters);

  const double depth = 0.002, radius = 0.005, mu = 0.6;  // so the load is 2 N
  for (int step = 0; step < 2000; ++step) {
    const double slid = 0.02 * step * 1e-3;  // 20 mm/s and 4 rad/s: c = 5 mm
    finger.update({{slid, 0.0, 0.0}, {0.0, 0.0, 1.0}, depth}, slid / 0.005);
  }

  const god::FingerOutput felt = finger.output();
  const auto unit = law->forces(1.0);
  const double force = mu * felt.load * unit.force, moment = mu * felt.load * radius * unit.moment;
  std::printf("felt %.9f N and %.9f N mm; eq. (17) at c = a: %.9f N and %.9f N mm; COR at %.6f mm\n", felt.force.norm(),
              1e3 * std::abs(felt.moment), force, 1e3 * moment, 1e3 * felt.cor);
  return felt.state == god::ContactState::slip && std::abs(felt.force.norm() - force) < 1e-6 * force &&
                 std::abs(std::abs(felt.moment) - moment) < 1e-6 * moment && std::abs(felt.cor - radius) < 1e-6 * radius
             ? 0
             : 1;
}
