// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/patch/patch.hpp"

namespace limitcurve::godobject {

/// The result of closest-point friction on a patch.
struct PatchProjection {
  bool slips = false;
  PatchWrench wrench;     ///< [N, N m]: the trial if it sticks, else a point of the limit surface
  PatchTwist slip;        ///< [m, rad]: the displacement that takes the springs from the trial to the wrench
  int evaluations = 0;    ///< of the patch's friction
  bool converged = true;  ///< false: `wrench` is on the limit surface, but it is not the closest point
};

/// Closest-point friction of a patch in its tangent plane. With springs S = diag(k, k, k_r) the slip T and the wrench W
/// of a trial W_t satisfy
///   W_t − W = S T,  W = ∇(μP H)(T):
/// W is the point of the limit surface closest to W_t in the springs' metric, and T its outward normal there (maximum
/// dissipation). In q = S^½T, ŵ = S^−½W_t, q maximises ρ(q) = ŵ·q − Ĥ(q) on the unit sphere; if ρ > 0 the contact
/// slips, and T = ρ S^−½q. Newton's method on the sphere:
///   (∇²Ĥ + ρI) δ = P(ŵ − ∇Ĥ), two numbers, Armijo's rule on ρ, the Hessian from differences of the wrench.
/// If the first guess has ρ ≤ 0, Ĥ is first minimised on the plane ŵ·q = 1: the minimum shows slip, or proves stick.
/// Where a kink stops Newton's method (a small radius of a heavy point), hulls of points of the surface find the
/// closest point.
class PatchProjector {
 public:
  /// The patch must be smooth (`Patch::smoothed`). One evaluation.
  explicit PatchProjector(const Patch& patch);

  [[nodiscard]] const Patch& patch() const noexcept { return patch_; }

  /// `limit` is μP [N] > 0, `compliance_radius` √(k_r/k) [m] > 0, the stiffness k [N/m]. `warm` is a slip for a warm
  /// start, or zero. At most `most_evaluations` of the patch; usually 8 to 20 from a cold start, none for a trial
  /// within the hull of pure slides and pure spins. Does not throw or allocate.
  [[nodiscard]] PatchProjection project(const PatchWrench& trial, double limit, double stiffness,
                                        double compliance_radius, const PatchTwist& warm) const noexcept;
  static constexpr int most_evaluations = 400;

 private:
  Patch patch_;
  PatchWrench spin_;  ///< of a pure spin about the centre of pressure
};

}  // namespace limitcurve::godobject
