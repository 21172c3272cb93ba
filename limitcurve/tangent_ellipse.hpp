// SPDX-License-Identifier: MIT
#pragma once

#include "table.hpp"

/// The two coefficients of an engine whose friction cone is elliptic, such that it finds the exact curve.
namespace limitcurve {

/// Semi-axes of the ellipse (f/p)² + (m/q)² = 1 in unit wrenches: friction coefficients μp and μaq. p ≤ 1 and q ≤ m₀ for most laws; where
/// the pressure has a sharp peak, p exceeds 1.
struct TangentEllipse {
  double p;
  double q;
};

/// The ellipse that touches the curve where the contact slips: it has the curve's wrench there, and its normal. Elsewhere it is up to 26 %
/// too weak. Signs are ignored; no slip gives the ellipse through the intercepts, (1, m₀), NaN gives NaN. A table's checked error is that of
/// f and m, not the slope that p (q) has near pure spin (pure sliding): there the relative error of a table of 1e-8 is 2e-6, for a sharp peak
/// (xydas-kao:k=0.05) 3e-4, and for uniform-wear, whose pressure is infinite at the centre, 1e-8/f.
[[nodiscard]] TangentEllipse tangent_ellipse(const Table& curve, SlipTwist slip) noexcept;

/// The same where the slip is known only as an engine's unit wrench, found with the ellipse (p, q), p, q > 0. Set after each step, the
/// semi-axes converge, so that wrench and centre of rotation become the curve's: touches where the curve splits the power between sliding
/// and turning as the engine did. The error shrinks by (|s| − 1)/(|s| + 1) or better, s = d log(m/f)/d log c, whether the scene imposes the
/// slip or the wrench (proof: docs/theory.md, "The tangent ellipse"). One search; infinite input gives NaN.
[[nodiscard]] TangentEllipse tangent_ellipse(const Table& curve, double force, double moment, double p, double q) noexcept;

/// The same on the ray of the wrench: exact at once where the scene imposes the wrench, but it may not converge where it imposes the slip.
[[nodiscard]] TangentEllipse tangent_ellipse(const Table& curve, double force, double moment) noexcept;

}  // namespace limitcurve
