// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"

/// Entry "time": springs, dampers and bodies in steps of time.
namespace limitcurve::stability {

/// The stiffest springs for which each integrator is stable on a light body, sliding and twisting.
Hazard light_body();
/// The same over stiffness and damping.
Hazard stiffness_and_damping();
/// A block of 10 g between two fingers of 2000 N/m at 1 kHz.
Hazard block_of_ten_grams();
/// A grip released in one step, and the energy of the springs.
Hazard released_grip();
/// Forces that reach the device one or two samples late.
Hazard delayed_forces();
/// The damping that a device needs for a sampled contact to be passive.
Hazard sampled_contact();
/// Positions in steps of an encoder, and velocities from their differences.
Hazard encoder_steps();

}  // namespace limitcurve::stability
