// SPDX-License-Identifier: MIT
#pragma once

#include "../table.hpp"

/// Two coefficients that you can set after each step, so that an engine whose friction cone is elliptic finds the exact
/// curve.
namespace limitcurve {

/// Semi-axes of the ellipse (f/p)² + (m/q)² = 1 in unit wrenches: friction coefficients μp and μaq. p ≤ 1 and q ≤ m₀
/// for most laws; if the pressure has a sharp peak, p can exceed 1.
struct TangentEllipse {
  double p;
  double q;
};

/// The ellipse that touches the curve where the contact slips, so that wrench and normal are those of the curve.
/// Elsewhere it is up to 24 % (Hertz) to 26.5 % (flat punch) too weak. Signs are ignored; no slip gives the ellipse
/// through the intercepts, (1, m₀), NaN gives NaN. A table's checked error bounds f and m, but p near pure spin (q near
/// pure sliding) depends on their slope: there the relative error of a table of 1e-8 is 2e-6, for a sharp peak
/// (xydas-kao:k=0.05) 3e-4, and for uniform-wear, whose pressure is infinite at the centre, 1e-8/f.
[[nodiscard]] TangentEllipse tangent_ellipse(const Table& curve, SlipTwist slip) noexcept;

/// The same if you know only an engine's unit wrench, found with the ellipse (p, q), p, q > 0. The new ellipse touches
/// the curve where it splits the power between sliding and turning as the engine did. If you set it after each
/// step, wrench and centre of rotation converge to the curve's, whether the scene imposes the slip or the wrench. A
/// step shrinks the error by |1 − |s||/(1 + |s|) or better, s = d log(m/f)/d log c (proof: docs/theory.md, "The tangent
/// ellipse"). An infinite force or moment gives NaN. Cost: one search.
[[nodiscard]] TangentEllipse tangent_ellipse(const Table& curve, double force, double moment, double p,
                                             double q) noexcept;

/// The ellipse on the ray of the wrench. It is exact at once if the scene imposes the wrench, but may not converge if
/// the scene imposes the slip.
[[nodiscard]] TangentEllipse tangent_ellipse(const Table& curve, double force, double moment) noexcept;

}  // namespace limitcurve
