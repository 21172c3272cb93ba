// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch.hpp"

namespace limitcurve::godobject {

/// Where closest-point friction on a patch brings a trial wrench.
struct PatchProjection {
  bool slips = false;
  PatchWrench wrench;     ///< [N, N m]: the trial, or where it slips the point of the limit surface
  PatchTwist slip;        ///< [m, rad]: the displacement that takes the springs from the trial to the wrench
  int evaluations = 0;    ///< of the patch's friction
  bool converged = true;  ///< false: `wrench` is on the limit surface and slip does work, but it is not the closest point
};

/// Friction of a patch in its tangent plane, three numbers. With springs S = diag(k, k, k_r) the slip T and the wrench W of a trial W_t obey
///   W_t − W = S T,  W = ∇(μP H)(T):
/// W is the point of the limit surface that is closest to W_t in the springs' metric, and T its outward normal there (maximum dissipation). In
/// q = S^½T, ŵ = S^−½W_t it is where ρ(q) = ŵ·q − Ĥ(q) is largest on the unit sphere; slip where that is > 0, T = ρ S^−½q. Newton's method there:
///   (∇²Ĥ + ρI) δ = P(ŵ − ∇Ĥ), two numbers, Armijo's rule on ρ, the Hessian from differences of the wrench.
/// Where a first guess has ρ ≤ 0 Ĥ is made least on the plane ŵ·q = 1, which ends in slip, or proves that all holds.
class PatchProjector {
 public:
  /// The patch must be smooth (`Patch::smoothed`). Finds how far the ellipsoid √(v² + m₀²ω²) must shrink to lie within it: 3e3 evaluations.
  explicit PatchProjector(Patch patch);

  [[nodiscard]] const Patch& patch() const noexcept { return patch_; }

  /// `limit` is μP [N] > 0, `compliance_radius` √(k_r/k) [m] > 0, the stiffness k [N/m]. `warm` is a slip near which to begin, or zero. At most
  /// `most_evaluations` of the patch; from a cold start 8 to 20 as a rule, none where the trial is within the ellipsoid. Never throws or allocates.
  [[nodiscard]] PatchProjection project(const PatchWrench& trial, double limit, double stiffness, double compliance_radius,
                                        const PatchTwist& warm) const noexcept;
  static constexpr int most_evaluations = 400;

  /// The factor by which the wrench, in units of μP, exceeds the limit surface: 1 on it, 0 for no wrench.
  [[nodiscard]] double gauge(const PatchWrench& unit_wrench) const noexcept;

 private:
  Patch patch_;
  double inner_;  ///< of the ellipsoid that lies within
};

}  // namespace limitcurve::godobject
