// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"

/// Entry "geometry": angles. A device reports its twist on a circle; a spring must not use it so.
namespace limitcurve::stability {

/// The device's angle jumps from π to −π.
Hazard half_a_turn();
/// A finger that is turned ten thousand times.
Hazard ten_thousand_turns();

}  // namespace limitcurve::stability
