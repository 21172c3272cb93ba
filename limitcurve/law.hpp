// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

namespace limitcurve {

/// The arithmetic of references: 64 bits of mantissa on x86.
using Extended = long double;

class PressureLaw;

/// Laws are handed around by this: shared, immutable. laws.hpp makes them, pressure_law.hpp says what they can do.
using Law = std::shared_ptr<const PressureLaw>;

}  // namespace limitcurve
