// SPDX-License-Identifier: MIT
#pragma once

namespace limitcurve::bench {

/// The god-object's step, curve by projection: one finger, sixteen in turn, batches of 1 to 65536 contacts, and how
/// their cost grows from 10³ to 10⁷. The error is that of the steady wrench under a constant twist, against eq. (17).
void register_steps();

/// Contacts that are not round: exact sums, tables of the patch and its ellipsoid. The error of a wrench, and of a
/// finger's friction in a slow motion, is that against the sums.
void register_patches();

}  // namespace limitcurve::bench
