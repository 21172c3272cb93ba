// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/radial_projection.hpp"

#include <cmath>
#include <limits>

namespace limitcurve::godobject {

/// The paper's Fig. 5 in general: the centre of rotation is kept while the load is brought back. The load λP whose p-curve
/// runs through the trial wrench has its centre of rotation at c; the result is the point of the p-curve of P with that c.
/// Where the radius does not depend on the load c-curves are rays, and this is the radial projection.
struct CCurve {
  /// Newton steps for the load; the residual is nearly linear in log λ, so that 3 or 4 suffice as a rule.
  static constexpr int iteration_limit = 60;

  template <LimitBoundary Boundary>
  Projected operator()(const Boundary& boundary, const Trial& trial) const noexcept {
    if (trial.radius_law == nullptr) return Radial{}(boundary, trial);
    const double gauge = boundary.gauge(trial.wrench);
    if (!(gauge > 1.0 + slip_guard)) return Radial::onto(trial, gauge);
    // At load λP the trial is (x̂/λ, ŷ/(λ a(λP)/a(P))) in unit wrenches: find λ where its gauge is 1. The logarithm of the
    // gauge falls by at most 2 a unit of log λ, which tells where to begin; bracketed, for the kinks of a sampled law. There is one
    // root, since P·a(P) grows with P. The growth is the law's own from P to λP; its exponent serves only as the derivative at
    // λP, so that of a sampled law it is that of the stretch at hand.
    double low = 0.5 * std::log(gauge);
    double high = std::numeric_limits<double>::infinity();
    double log_load = std::log(gauge) / (1.0 + trial.radius_law->exponent(trial.load));
    double growth = 1.0;
    RadialPoint foot{};
    for (int i = 0; i < iteration_limit; ++i) {
      const double ratio = std::exp(log_load);
      growth = trial.radius_law->growth(ratio, trial.load);
      const double gamma = trial.radius_law->exponent(ratio * trial.load);
      const UnitWrench at_load{trial.wrench.force / ratio, trial.wrench.moment / (ratio * growth)};
      foot = boundary.along(at_load);
      const double excess = std::log(gauge_from(at_load, foot.wrench));
      (excess > 0.0 ? low : high) = log_load;
      const double slide_part = foot.normal.slide * foot.wrench.force;
      const double spin_part = foot.normal.spin * foot.wrench.moment;
      const double step = excess * (slide_part + spin_part) / (slide_part + (1.0 + gamma) * spin_part);
      if (std::fabs(step) <= 1e-14) break;
      double next = log_load + step;
      if (!(next > low && next < high)) next = high < std::numeric_limits<double>::infinity() ? 0.5 * (low + high) : low + 1.0;
      log_load = next;
    }
    // c = s·a(λP) is kept, and a(P) is smaller by the growth. At either end of the curve c/a is the same, 0 or ∞, and the foot with it.
    UnitWrench wrench = foot.wrench;
    if (foot.normal.slide > 0.0 && foot.normal.spin > 0.0) {
      wrench = boundary.wrench({foot.normal.slide * growth, foot.normal.spin});
    }
    // For a pressure heaped at the rim, or a boundary with corners, f(s) can grow faster than s and the same c would
    // add force instead of taking it off. The same c/a never does.
    if (wrench.force > trial.wrench.force || wrench.moment > trial.wrench.moment) wrench = foot.wrench;
    return {true, true, wrench, slip_between(trial, wrench)};
  }
};

}  // namespace limitcurve::godobject
