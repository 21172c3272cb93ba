// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"
#include "limitcurve/wrench.hpp"

#include <cmath>

/// Entry "projection": how a step finds the friction wrench.
namespace limitcurve::stability {

/// Quotients of the paper's step that are 0/0: no offset, no twist, no depth, no friction, no torsional friction.
Hazard degenerate_steps();
/// Springs of twist and sliding whose ratio differs by up to a million, under a steady twist.
Hazard stiffness_ratios();
/// A contact with an almost zero moment limit and the springs of a larger one, under a steady twist.
Hazard small_contacts();
/// A contact radius that grows with the load, under a steady twist: the result of the c-curve through the trial.
Hazard growing_radius();
/// Newton's method for the closest point without a bracket, over stiffness ratios and distances of the trial.
Hazard newton_without_bracket();
/// A box, given to a search for smooth curves.
Hazard corners();
/// Limits of force and moment applied one after the other.
Hazard order_of_limits();
/// Static friction above dynamic friction: false chatter, and real stick–slip.
Hazard chatter();
/// A load that drops in one step while the finger rests.
Hazard collapsing_load();

/// Distance of two unit wrenches in the normalised plane.
inline double normalised_distance(UnitWrench one, UnitWrench other, double moment_ratio) {
  return std::hypot(one.force - other.force, (one.moment - other.moment) / moment_ratio);
}

}  // namespace limitcurve::stability
