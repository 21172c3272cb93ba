// SPDX-License-Identifier: MIT
#pragma once

#include "../failures.hpp"

/// Entry "reality": real devices.
namespace limitcurve::stability {

/// Rates from 100 Hz to 10 kHz, with jitter.
Hazard rates_and_jitter();
/// Dampers, with a clock that is not read, stands still or runs backwards.
Hazard clocks();
/// Samples that are NaN, jump, or are missing.
Hazard bad_samples();
/// A plate between two samples.
Hazard plate_between_samples();
/// A device that freezes and continues elsewhere.
Hazard frozen_device();

}  // namespace limitcurve::stability
