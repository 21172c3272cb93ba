// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch/patch.hpp"

#include <cstddef>

namespace limitcurve::patch {

/// Σ w √(|u|² + s²) over points with velocity u = (v_x − ωy, v_y + ωx), and its gradient; `softness` is s² = ε²ω² > 0.
/// Σ|w| = 1. Rounding error at most n/8 ε. Cost: 1 ns a point with AVX2, 3 ns without.
PatchFriction sum_soft_points(const double* x, const double* y, const double* weight, std::size_t count,
                              const PatchTwist& twist, double softness) noexcept;

}  // namespace limitcurve::patch
