// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_boundary.hpp"

#include <algorithm>
#include <concepts>

namespace limitcurve::godobject {

/// The wrench that the springs between proxy and finger would cause if the proxy stayed where it is, in unit wrenches of
/// the load: x̂ = k_l r/(μP), ŷ = k_r ρ/(μPa) (paper, eqs. 7 and 21), and what a projection needs to know beside it.
struct Trial {
  UnitWrench wrench;              ///< (x̂, ŷ), finite, ≥ 0, outside the boundary
  double compliance_ratio = 1.0;  ///< χ = a²k_l/k_r: how soft the twist is against the sliding, > 0
  double radius_exponent = 0.0;   ///< γ of a ∝ P^γ
  double start = -1.0;            ///< spin fraction of the last slip, where a search may start; < 0: none
};

/// Where the proxy's wrench comes to lie when it slips, and how it slips there.
struct Projected {
  UnitWrench wrench;  ///< on the boundary; no component is larger than the trial's
  SlipTwist slip;     ///< direction of the slip, (r − r′ : a(ρ − ρ′)) in the frame of the contact
};

/// A rule that moves a trial wrench on to a limit boundary. Written once, for every boundary; bounded, without
/// allocation, trigonometry or exceptions. It must dissipate: force·(r − r′) + moment·(ρ − ρ′) ≥ 0.
// clang-format off
template <class Rule, class Boundary>
concept ProjectionOnto = requires(const Rule& rule, const Boundary& boundary, const Trial& trial) {
  { rule(boundary, trial) } noexcept -> std::same_as<Projected>;
};
// clang-format on

/// The direction of a slip that ends at `wrench`: the compliance times what was taken off the trial (never negative,
/// but for rounding, which is cut off).
constexpr SlipTwist slip_between(const Trial& trial, UnitWrench wrench) noexcept {
  return {std::max(trial.wrench.force - wrench.force, 0.0), std::max(trial.compliance_ratio * (trial.wrench.moment - wrench.moment), 0.0)};
}

}  // namespace limitcurve::godobject
