// SPDX-License-Identifier: MIT
//
// engine_drag: the friction that physics engines make of one finger (Hertz, mu = 0.8, a = 5 mm, 3 N) with the translated
// coefficients, measured by dragging it about imposed centres of rotation, as CSV: engine,version,model,c,force,moment, with c
// over the radius, force and moment over their limits; and exact_force,exact_moment of the law there. scripts/maintain/engines/measure runs it.
#include "tests/fit/engines/dragged.hpp"

#ifdef LIMITCURVE_HAS_BULLET
#include "tests/fit/engines/bullet_drag.hpp"
#endif
#ifdef LIMITCURVE_HAS_MUJOCO
#include "tests/fit/engines/mujoco_drag.hpp"
#endif
#ifdef LIMITCURVE_HAS_ODE
#include <ode/version.h>
#include "tests/fit/engines/ode_drag.hpp"
#endif

#include <cstdio>
#include <functional>

namespace limitcurve::fit::engines {
namespace {

using Drag = std::function<Measured(const EngineContact&, SlipTwist)>;

[[maybe_unused]] void rows(const char* engine, const std::string& version, const char* model, const Drag& drag) {
  const EngineContact contact = translated(engine, model);
  const Law exact = law();
  const double moment_ratio = exact->moment_ratio();
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i) {
    // Evenly from pure slide to pure twist in the normalised plane's slip.
    const double spin = static_cast<double>(i) / steps;
    const SlipTwist twist{(1.0 - spin) * moment_ratio, spin};
    const UnitWrench found = drag(contact, twist).wrench;
    const UnitWrench truth = exact->evaluate(twist.cor()).wrench;
    std::printf("%s,%s,%s,%.6g,%.6f,%.6f,%.6f,%.6f\n", engine, version.c_str(), model, twist.cor(), found.force,
                found.moment / moment_ratio, truth.force, truth.moment / moment_ratio);
  }
}

}  // namespace
}  // namespace limitcurve::fit::engines

int main() {
  using namespace limitcurve::fit::engines;
  std::puts("engine,version,model,c,force,moment,exact_force,exact_moment");
#ifdef LIMITCURVE_HAS_MUJOCO
  rows("mujoco", mj_versionString(), "ellipse", [](const auto& contact, auto twist) { return drag_in_mujoco(contact, true, twist); });
  rows("mujoco", mj_versionString(), "diamond", [](const auto& contact, auto twist) { return drag_in_mujoco(contact, false, twist); });
#endif
#ifdef LIMITCURVE_HAS_ODE
  rows("ode", dODE_VERSION, "box", drag_in_ode);
#endif
#ifdef LIMITCURVE_HAS_BULLET
  rows("bullet", std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100), "box", drag_in_bullet);
#endif
  return 0;
}
