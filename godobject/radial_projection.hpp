// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/projection.hpp"
#include "limitcurve/ellipse.hpp"

#include <concepts>

namespace limitcurve::godobject {

/// The paper's coupled algorithm (eq. 23, r′/r = ρ′/ρ): force and moment shrink by one factor, along the ray to the
/// origin. Cheapest; but a finger that keeps sliding settles at F/M = (k_l/k_r)·c, a wrench that the stiffnesses choose and
/// not the curve. Right only for k_r/k_l = (m₀a)² on the ellipse.
struct Radial {
  template <LimitBoundary Boundary>
  Projected operator()(const Boundary& boundary, const Trial& trial) const noexcept {
    return onto(trial, boundary.gauge(trial.wrench));
  }

  /// The same for a trial of known gauge.
  static Projected onto(const Trial& trial, double gauge) noexcept {
    if (!(gauge > 1.0)) return {};
    const double share = 1.0 / gauge;
    // The proxy moves along the trial, whatever the normal of the curve there.
    return {true,
            gauge > 1.0 + slip_guard,
            {trial.wrench.force * share, trial.wrench.moment * share},
            {trial.wrench.force, trial.compliance_ratio * trial.wrench.moment}};
  }

  /// On the ellipse through its intercepts the step needs no more than squares (paper, eq. 21): no root of r.
  template <class Boundary>
  static constexpr bool needs_squares_only = std::same_as<Boundary, Ellipse>;
};

}  // namespace limitcurve::godobject
