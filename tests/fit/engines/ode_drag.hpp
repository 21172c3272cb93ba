// SPDX-License-Identifier: MIT
#pragma once

#include "fit/engine_coefficients.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/wrench.hpp"

#include <ode/ode.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

/// The contact that is translated, and how a finger is dragged in ODE.
namespace limitcurve::fit::engines {

inline const double friction = 0.8;
inline const double load = 3.0;  // [N]
inline Law law() {
  return hertz();
}
inline RadiusLaw radius_law() {
  return RadiusLaw::constant(0.005);
}

/// The translation of the contact to ODE.
inline EngineContact translated() {
  for (EngineContact& contact : translate(law(), radius_law(), friction, load)) {
    if (contact.engine == "ode") return contact;
  }
  throw std::out_of_range("ode");
}

inline double coefficient(const EngineContact& contact, const std::string& parameter) {
  for (const EngineCoefficient& item : contact.coefficients) {
    if (item.parameter == parameter) return item.value;
  }
  throw std::out_of_range(parameter);
}

/// What the engine answered: the wrench over μN and μNa, N being the normal force [N] of the same step.
struct Measured {
  UnitWrench wrench;
  double normal = 0.0;
};

/// Slip twists (|v| : a|ω|) to impose: both ends, and between.
inline const std::vector<SlipTwist> twists{
    SlipTwist::about_cor(0.0), SlipTwist::about_cor(0.1), SlipTwist::about_cor(0.3), SlipTwist::about_cor(0.6),
    SlipTwist::about_cor(1.0), SlipTwist::about_cor(2.0), SlipTwist::about_cor(5.0), {1.0, 0.0}};

/// A finger in ODE: the wrench of one step, with the contact at the body's centre so that force and moment do not mix.
inline Measured drag_in_ode(const EngineContact& contact, SlipTwist twist) {
  constexpr double gravity = 10.0;
  const double radius = radius_law().radius(load);
  dInitODE2(0);
  const dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, 0, static_cast<dReal>(-gravity));
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetZero(&mass);
  // Inert enough about the normal that a step's friction does not stop the twist.
  const auto weight = static_cast<dReal>(load / gravity);
  dMassSetParameters(&mass, weight, 0, 0, 0, 1, 1, 1, 0, 0, 0);
  dBodySetMass(body, &mass);
  dContact touch{};
  touch.surface.mode = dContactAxisDep | dContactRolling | dContactApprox1 | dContactFDir1;
  touch.surface.mu = static_cast<dReal>(coefficient(contact, "surface.mu"));
  touch.surface.mu2 = static_cast<dReal>(coefficient(contact, "surface.mu2"));
  touch.surface.rho = static_cast<dReal>(coefficient(contact, "surface.rho"));
  touch.surface.rho2 = static_cast<dReal>(coefficient(contact, "surface.rho2"));
  touch.surface.rhoN = static_cast<dReal>(coefficient(contact, "surface.rhoN"));
  touch.geom.normal[2] = 1;
  touch.fdir1[0] = 1;
  const dJointID joint = dJointCreateContact(world, nullptr, &touch);
  dJointAttach(joint, body, nullptr);
  dJointFeedback feedback{};
  dJointSetFeedback(joint, &feedback);
  constexpr double speed = 1.0;
  dBodySetLinearVel(body, static_cast<dReal>(speed * twist.slide), 0, 0);
  dBodySetAngularVel(body, 0, 0, static_cast<dReal>(speed * twist.spin / radius));
  dWorldStep(world, static_cast<dReal>(1e-3));
  const double limit = friction * static_cast<double>(feedback.f1[2]);
  const UnitWrench wrench{std::fabs(static_cast<double>(feedback.f1[0])) / limit,
                          std::fabs(static_cast<double>(feedback.t1[2])) / (limit * radius)};
  dJointDestroy(joint);
  dWorldDestroy(world);
  dCloseODE();
  return {wrench, limit / friction};
}

}  // namespace limitcurve::fit::engines
