// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/patch/patch.hpp"
#include "estimate.hpp"

#include <span>
#include <string>
#include <vector>

namespace limitcurve::fit {

/// A push of a patch that slid: the applied wrench [N, N m] and the displacement [m, rad], both at the origin.
struct Push {
  PatchWrench wrench;
  PatchTwist displacement;
  std::size_t row = 0;  ///< the number by which messages name the push; 0: count from 1
};

/// The result of a push.
struct PushFriction {
  double share;      ///< rotation share of the motion, 0 to 1
  double exact;      ///< power divided by P H; equals μ if the patch explains the push
  double ellipsoid;  ///< power divided by that of the ellipsoid
};

/// What all pushes say of a patch.
struct FrictionFit {
  std::vector<Estimate> estimates;
  std::vector<std::string> warnings;  ///< for people: pushes that were left out, quantities that look like another unit
  std::string note;                   ///< after few pushes, how wide a 95 % interval is; otherwise empty
};

/// The results of all pushes. Throws like `fit_friction`, but there may be any number of pushes.
std::vector<PushFriction> push_friction(const Patch& patch, std::span<const Push> pushes, double load);

/// μ from power: W·T/(P H(T)) of every push, which must not depend on the rotation share. The estimates are
///   mu        the mean over the pushes; the standard error comes from the scatter,
///   drift     least-squares slope of μ against the rotation share |ω|m₀/√(v² + ω²m₀²), v of the centre of pressure,
///             divided by the mean,
/// and mu_ellipsoid, drift_ellipsoid, computed with the ellipsoid √(v² + m₀²ω²) instead of H, with v = (mx v_x, my v_y)
/// if friction is orthotropic. `load` is P [N]; if you do not know the load, pass 1, and mu is μP [N]. drift is nan if
/// all shares are equal, or if drift would exceed 1. Errors of a direction make mu too small, by 1 % for errors of 20
/// %, because no motion takes less power than the true motion. A push of negative power is left out, with a warning.
/// Throws std::invalid_argument if most pushes have negative power (the wrenches are then the reactions), if there are
/// fewer than 3 pushes, if a push does not move or has a number that is not finite (the message names the
/// push), or for a load that is not > 0.
FrictionFit fit_friction(const Patch& patch, std::span<const Push> pushes, double load, const std::string& unit);

}  // namespace limitcurve::fit
