// SPDX-License-Identifier: MIT
//
// engine_drag: the friction that ODE makes of one finger (Hertz, mu = 0.8, a = 5 mm, 3 N) with the
// translated coefficients, measured by dragging it about imposed centres of rotation, as CSV:
// engine,version,model,c,force,moment, with c over the radius, force and moment over their limits;
// and exact_force,exact_moment of the law there. studies/engines/measure runs it.
#include "limitcurve/engines/engine_coefficients.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/wrench.hpp"

#include <ode/ode.h>
#include <ode/version.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

namespace {

using namespace limitcurve;

constexpr double friction = 0.8;
constexpr double radius = 0.005;  // [m]
constexpr double load = 3.0;      // [N]

/// The wrench of one step over mu N and mu N a, N the normal force of that step. The contact is at the body's centre,
/// so that force and moment do not mix.
UnitWrench drag(std::map<std::string, dReal>& typed, SlipTwist twist) {
  constexpr double gravity = 10.0;
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, 0, static_cast<dReal>(-gravity));
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetZero(&mass);
  // Inert enough about the normal that a step's friction does not stop the twist.
  dMassSetParameters(&mass, static_cast<dReal>(load / gravity), 0, 0, 0, 1, 1, 1, 0, 0, 0);
  dBodySetMass(body, &mass);
  dContact touch{};
  touch.surface.mode = dContactAxisDep | dContactRolling | dContactApprox1 | dContactFDir1;
  touch.surface.mu = typed["surface.mu"];
  touch.surface.mu2 = typed["surface.mu2"];
  touch.surface.rho = typed["surface.rho"];
  touch.surface.rho2 = typed["surface.rho2"];
  touch.surface.rhoN = typed["surface.rhoN"];
  touch.geom.normal[2] = 1;
  touch.fdir1[0] = 1;
  const dJointID joint = dJointCreateContact(world, nullptr, &touch);
  dJointAttach(joint, body, nullptr);
  dJointFeedback feedback{};
  dJointSetFeedback(joint, &feedback);
  dBodySetLinearVel(body, static_cast<dReal>(twist.slide), 0, 0);
  dBodySetAngularVel(body, 0, 0, static_cast<dReal>(twist.spin / radius));
  dWorldStep(world, static_cast<dReal>(1e-3));
  const double limit = friction * static_cast<double>(feedback.f1[2]);
  dWorldDestroy(world);
  dCloseODE();
  return {std::fabs(static_cast<double>(feedback.f1[0])) / limit,
          std::fabs(static_cast<double>(feedback.t1[2])) / (limit * radius)};
}

}  // namespace

int main() {
  std::puts("engine,version,model,c,force,moment,exact_force,exact_moment");
  std::map<std::string, dReal> typed;
  for (const engines::EngineContact& contact :
       engines::translate(hertz(), RadiusLaw::constant(radius), friction, load)) {
    if (contact.engine != "ode") continue;
    for (const engines::EngineCoefficient& one : contact.coefficients)
      typed[one.parameter] = static_cast<dReal>(one.value);
  }
  const double moment_ratio = hertz()->moment_ratio();
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i) {
    // Evenly from pure slide to pure twist in the normalised plane's slip.
    const double spin = static_cast<double>(i) / steps;
    const SlipTwist twist{(1.0 - spin) * moment_ratio, spin};
    const UnitWrench found = drag(typed, twist);
    const UnitWrench truth = hertz()->evaluate(twist.cor()).wrench;
    std::printf("ode,%s,box,%.6g,%.6f,%.6f,%.6f,%.6f\n", dODE_VERSION, twist.cor(), found.force,
                found.moment / moment_ratio, truth.force, truth.moment / moment_ratio);
  }
  return 0;
}
