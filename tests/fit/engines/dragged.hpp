// SPDX-License-Identifier: MIT
#pragma once

#include "fit/engine_coefficients.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/wrench.hpp"

#include <stdexcept>
#include <string>
#include <vector>

/// The contact that is translated, and how a finger is dragged in a physics engine.
namespace limitcurve::fit::engines {

inline const double friction = 0.8;
inline const double load = 3.0;  // [N]
inline Law law() {
  return hertz();
}
inline RadiusLaw radius_law() {
  return RadiusLaw::constant(0.005);
}

/// The translation of the contact to `engine` where it has the shape `model`.
inline EngineContact translated(const std::string& engine, const std::string& model) {
  for (EngineContact& contact : translate(law(), radius_law(), friction, load)) {
    if (contact.engine == engine && contact.model == model) return contact;
  }
  throw std::out_of_range(engine + " " + model);
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

}  // namespace limitcurve::fit::engines
