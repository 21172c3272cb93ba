// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/measured/cubic_pieces.hpp"
#include "limitcurve/measured/samples.hpp"

#include <span>
#include <string_view>

namespace limitcurve {

/// A measured profile as cubics that carry the unit load, its radii in units of `rim`. If that is `named`, a sample
/// without pressure divides the profile like a jump: then what is beyond it does not change the slope before it,
/// however little it is.
CubicPieces cubics(std::span<const PressureSample> profile, std::string_view source, double rim, bool named);

}  // namespace limitcurve
