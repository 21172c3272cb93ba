// SPDX-License-Identifier: MIT
#pragma once

#include "../atlas.hpp"

/// Entry g: what a device really delivers.
namespace limitcurve::stability {

/// Rates from 100 Hz to 10 kHz, with jitter.
Hazard rates_and_jitter();
/// Dampers, and a clock that the program does not read, that stands still or runs backwards.
Hazard clocks();
/// Samples that are no numbers, that leap, or that do not come.
Hazard bad_samples();
/// A plate that lies between two samples.
Hazard plate_between_samples();
/// A device that freezes, and goes on from somewhere else.
Hazard frozen_device();

}  // namespace limitcurve::stability
