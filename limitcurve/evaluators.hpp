// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

/// The evaluators of eq. (17) that serve every law. All integrands but those of `direct` are positive, so that
/// rounding stays at the level of one term; s ∈ [0, ∞].
namespace limitcurve::evaluators {

/// A value in extended precision with the truncation error of its quadrature.
struct ExtendedEstimate {
  UnitForces<Extended> forces;
  UnitForces<Extended> error;
};

/// Theory: the angular integral in closed form (complete elliptic integrals), the radial one by quadrature split at
/// ρ = s and at the law's breaks.
ExtendedEstimate ring(const PressureLaw& law, Extended s) noexcept;

/// The law as a superposition of flat punches of radius t, split at t = s. The law must have a punch density.
ExtendedEstimate punch(const PressureLaw& law, Extended s) noexcept;

/// Eq. (17) as printed, over radius and angle, split at r = c. Its force integrand changes sign: the error is absolute.
ExtendedEstimate direct(const PressureLaw& law, Extended s) noexcept;

/// Rounds to double and adds the rounding to the error.
WrenchEstimate rounded(const ExtendedEstimate& estimate) noexcept;

}  // namespace limitcurve::evaluators
