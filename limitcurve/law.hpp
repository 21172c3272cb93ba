// SPDX-License-Identifier: MIT
#pragma once

#include "version.hpp"

#include <memory>

namespace limitcurve {

/// Floating-point type of reference values: 64 bits of mantissa on x86, double where the platform has nothing wider.
using Extended = long double;

class PressureLaw;

/// A pressure law is a shared pointer to an immutable object. A factory of laws.hpp can make one, and
/// pressure_law.hpp declares the member functions.
using Law = std::shared_ptr<const PressureLaw>;

}  // namespace limitcurve
