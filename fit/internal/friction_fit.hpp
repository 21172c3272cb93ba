// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "limitcurve/patch.hpp"

#include <span>

namespace limitcurve::fit {

/// A push of a patch that slid: the wrench that was applied [N, N m] and the displacement, both of the origin [m, rad].
struct Push {
  PatchWrench wrench;
  PatchTwist displacement;
};

/// What one push tells.
struct PushFriction {
  double share;      ///< of rotation in its motion, 0 to 1
  double exact;      ///< power over P H, μ where the patch explains the push
  double ellipsoid;  ///< power over that of the ellipsoid
};

/// For each push. Throws as `fit_friction`, but for their number.
std::vector<PushFriction> push_friction(const Patch& patch, std::span<const Push> pushes, double load);

/// μ from power: W·T/(P H(T)) of every push, which must not depend on how much of the motion is rotation. The estimates are
///   mu        its mean; standard error from its scatter,
///   drift     least-squares slope of μ over the share of rotation |ω|m₀/√(v² + ω²m₀²), v of the centre of pressure, divided by the mean,
/// and mu_ellipsoid, drift_ellipsoid: the same with the ellipsoid √(v² + m₀²ω²) in place of H, v taken as (mx v_x, my v_y) if friction is
/// orthotropic. `load` P [N]; with load 1, where it is not known, mu is μP [N]. Where all shares are equal drift is nan.
/// Throws std::invalid_argument for fewer than 3 pushes, or one that does not move (it names it, counted from 1).
std::vector<Estimate> fit_friction(const Patch& patch, std::span<const Push> pushes, double load, const std::string& unit);

}  // namespace limitcurve::fit
