// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

namespace limitcurve {

/// A measured profile with the last radius that has pressure as its named rim, unless one is named: for a contact of
/// just the profile's size. Other laws as they are.
Law with_own_radii(const Law& law);

}  // namespace limitcurve
