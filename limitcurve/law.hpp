// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

namespace limitcurve {

class PressureLaw;

/// Laws are handed around by this: shared, immutable. laws.hpp makes them, pressure_law.hpp says what they can do.
using Law = std::shared_ptr<const PressureLaw>;

}  // namespace limitcurve
