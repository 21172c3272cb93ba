// SPDX-License-Identifier: MIT
#pragma once

#include "../atlas.hpp"

/// Entry e: springs, dampers and bodies in steps of time.
namespace limitcurve::stability {

/// The stiffest springs that each integrator bears on a light body, sliding and twisting.
Hazard light_body();
/// The same over stiffness and damping.
Hazard stiffness_and_damping();
/// A block of 10 g between two fingers of 2000 N/m at 1 kHz.
Hazard block_of_ten_grams();
/// A grip that is released in one step, and the energy that is in the springs.
Hazard released_grip();
/// Forces that reach the device one or two samples late.
Hazard delayed_forces();
/// The damping that a device needs for a sampled contact to be passive.
Hazard sampled_contact();
/// Positions in steps of an encoder, and the speeds that one takes from them.
Hazard encoder_steps();

}  // namespace limitcurve::stability
