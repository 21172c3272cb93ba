// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve::bench {

/// Adds the god-object's step, boundary by projection, to `ways()`: its error is that of the wrench at which a finger
/// settles that is driven at a constant twist, against eq. (17).
void add_steps();

/// The same in batches of 1 to 65536 contacts, and how their cost grows from 10³ to 10⁷.
void register_batches();

}  // namespace limitcurve::bench
