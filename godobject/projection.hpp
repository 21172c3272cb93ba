// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/radius_law.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>

namespace limitcurve::godobject {

/// A contact slips when the gauge of its trial exceeds 1 by more than this; within it, rounding of a proxy that lies on the
/// boundary would be taken for slip. What is felt is within the boundary there too.
inline constexpr double slip_guard = 1e-12;

/// The wrench that the springs between proxy and finger would cause if the proxy stayed where it is, in unit wrenches of
/// the load: x̂ = k_l r/(μP), ŷ = k_r ρ/(μPa) (paper, eqs. 7 and 21), and what a projection needs to know beside it.
struct Trial {
  UnitWrench wrench;                      ///< (x̂, ŷ), finite, ≥ 0, not both 0
  double compliance_ratio = 1.0;          ///< χ = a²k_l/k_r: how soft the twist is against the sliding, > 0
  double start = -1.0;                    ///< place of the last slip, where a search may start; ≤ 0: none
  const RadiusLaw* radius_law = nullptr;  ///< a(P), where it depends on the load
  double load = 0.0;                      ///< P [N]
  std::uint32_t piece = 0;                ///< Projected::piece of the last slip, or any number
};

/// What a projection finds.
struct Projected {
  bool outside;             ///< the trial is outside the boundary. If not, the rest is void
  bool slips;               ///< … by more than slip_guard
  UnitWrench wrench;        ///< on the boundary; no component is larger than the trial's
  SlipTwist slip;           ///< direction of the slip, (r − r′ : a(ρ − ρ′)) in the frame of the contact
  double start = 0.0;       ///< where the next search may start: a place (SlipTwist::at_place), or 0 for none
  std::uint32_t piece = 0;  ///< of the boundary, where the next search may look first
};

/// A rule that tells whether a trial wrench lies outside a limit boundary, and if so moves it on to the boundary.
/// Written once, for every boundary; bounded, without allocation, trigonometry or exceptions. It must dissipate:
/// force·(r − r′) + moment·(ρ − ρ′) ≥ 0.
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
