// SPDX-License-Identifier: MIT
#pragma once

#include "version.hpp"

#include <memory>

namespace limitcurve {

/// Floating-point type of reference values: 64 bits of mantissa on x86, double where the platform has nothing wider.
using Extended = long double;

class PressureLaw;

/// A pressure law: a shared pointer to an immutable object. laws.hpp has the factories, pressure_law.hpp the member
/// functions.
using Law = std::shared_ptr<const PressureLaw>;

}  // namespace limitcurve
