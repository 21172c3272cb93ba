// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/projection.hpp"

namespace limitcurve::godobject {

/// The paper's coupled algorithm (eq. 23, r′/r = ρ′/ρ): force and moment shrink by one factor, along the ray to the
/// origin. Cheapest; but a finger that keeps sliding settles at F/M = (k_l/k_r)·c, a wrench that the stiffnesses choose and
/// not the curve. Right only for k_r/k_l = (m₀a)² on the ellipse.
struct Radial {
  template <LimitBoundary Boundary>
  Projected operator()(const Boundary& boundary, const Trial& trial) const noexcept {
    const UnitWrench foot = boundary.along(trial.wrench).wrench;
    // The proxy moves along the trial, whatever the normal of the curve there.
    return {gauge_from(trial.wrench, foot) > 1.0 + slip_guard, foot, {trial.wrench.force, trial.compliance_ratio * trial.wrench.moment}};
  }
};

}  // namespace limitcurve::godobject
