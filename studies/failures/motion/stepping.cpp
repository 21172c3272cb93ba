// SPDX-License-Identifier: MIT
// Entry "time": finger springs on a light body.
#include "../failures.hpp"
#include "../numerics/sampling.hpp"

#include "../../../tests/integrators.hpp"
#include "godobject/surfaces/surfaces.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace limitcurve::stability {

namespace {

using namespace godobject;
using test::Integrator;

constexpr double tick = 1e-3;

/// A body on two sticking fingers, displaced a little and released. κ = kΔt²/m of both fingers together.
bool gains_energy(Integrator integrator, double kappa) {
  BodyParameters body;
  body.mass = 0.1;
  body.inertia.setConstant(1e-4);
  body.gravity.setZero();
  body.free = {true, false, false, false, false, false};
  FingerParameters with;
  with.mu = 1e6;
  with.max_speed = 1e9;  // an unstable body flies
  with.stiffness = 0.5 * kappa * body.mass / (tick * tick);
  const SoftFinger finger(Ellipse::through_intercepts(hertz()->moment_ratio()), with);
  Grasp scene(body, BodyState{}, AnySurface(BoxSurface(Eigen::Vector3d::Constant(0.02))), {finger, finger});
  const std::array devices{DevicePose{{0.0, 0.0, 0.019}}, DevicePose{{0.0, 0.0, -0.019}}};
  scene.place(BodyState{}, devices);
  constexpr double little = 1e-9;
  BodyState start;
  start.position.x() = little;
  scene.place(start, devices);
  // Long enough to show a gain of κ/2 a step.
  const int steps = 800 + static_cast<int>(1.0 / kappa);
  const int swing = 60 + static_cast<int>(7.0 / std::sqrt(kappa));
  double first = 0.0;
  double last = 0.0;
  for (int i = 0; i < steps; ++i) {
    test::step_by(integrator, scene, devices, tick);
    const double away = std::fabs(scene.body().position.x());
    if (!(away <= 1e4 * little)) return true;
    if (i >= steps / 2 && i < steps / 2 + swing) raise(first, away);
    if (i >= steps - swing) raise(last, away);
  }
  // A decay to rounding is no growth.
  return last > 1.1 * std::max(first, 1e-3 * little);
}

/// The largest κ without a gain, of 1e-3 to 1e8.
double largest(Integrator integrator) {
  double low = std::log(1e-3);
  double high = std::log(1e8);
  if (!gains_energy(integrator, 1e8)) return 1e8;
  while (high - low > 1e-3) {
    const double middle = 0.5 * (low + high);
    (gains_energy(integrator, std::exp(middle)) ? high : low) = middle;
  }
  return std::exp(low);
}

}  // namespace

Hazard light_body() {
  return {{{"stiff fingers, light body", "symplectic Euler, undamped",
            "largest kΔt²/m without a gain of energy (tried: 1e-3 to 1e8)", largest(Integrator::symplectic_euler),
            largest(Integrator::implicit_euler)}},
          {}};
}

}  // namespace limitcurve::stability
