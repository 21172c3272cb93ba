// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

/// The evaluators of eq. (17) for every law, s ∈ [0, ∞]. All integrands except those of `direct` are positive, so that
/// rounding stays at the level of one term. docs/theory.md has the kernels.
namespace limitcurve::evaluators {

/// The angular integral in closed form (complete elliptic integrals), the radial one by quadrature, split at ρ = s and
/// at the law's breaks.
Quadrature<Extended> ring(const PressureLaw& law, Extended s, Slope slope = Slope::wanted) noexcept;
Quadrature<double> ring(const PressureLaw& law, double s, Slope slope = Slope::wanted) noexcept;

/// Unit wrench of a ring of radius ρ, in contact radii, that carries the whole load: the kernel of `ring`. s finite.
UnitWrench ring_wrench(double rho, double s) noexcept;

/// The law as a superposition of flat punches of radius t, split at t = s. The law must have a punch density.
Quadrature<Extended> punch(const PressureLaw& law, Extended s) noexcept;

/// Eq. (17) as printed, over radius and angle, split at r = c. Its force integrand changes sign: the error is absolute.
Quadrature<Extended> direct(const PressureLaw& law, Extended s) noexcept;

/// The kernels of `ring` by Carlson's integrals, the radius by Boost's tanh–sinh rule, which ends where the estimate of
/// its error, that of the last row but one, is below `tolerance` of the integral. Shares no integral with `ring`. The
/// error includes rounding.
Quadrature<double> boost(const PressureLaw& law, double s, Slope slope = Slope::wanted,
                         double tolerance = 1e-14) noexcept;

/// The law's pressure projected on a line through the contact centre, at the coordinate t ≥ 0 on the line: with G(t) =
/// ⟨|t − x|⟩, `force` is G′ and `moment` is N = G − tG′. For contacts that are not round.
Quadrature<double> line_profile(const PressureLaw& law, double t) noexcept;

/// Rounds to double and adds the rounding to the error.
WrenchEstimate rounded(const Quadrature<Extended>& estimate) noexcept;

}  // namespace limitcurve::evaluators
