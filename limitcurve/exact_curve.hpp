// SPDX-License-Identifier: MIT
#pragma once

#include "limit_curve.hpp"
#include "pressure_law.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace limitcurve {

/// The exact unit limit curve of a pressure law (eq. 17); models LimitCurve. Relative error of the wrench: that of the law's `forces`, ≤
/// 1e-14 to 1e-13. Wrenches are scaled by 1 − 9e-16, so that rounding seldom puts a wrench of the curve outside the curve; not
/// at both ends, which are exact.
/// Cost: that of `forces`, nanoseconds for a closed form, microseconds by quadrature. In a control loop use a table.
class ExactCurve {
 public:
  /// Throws std::invalid_argument for a law that `checked` refuses.
  explicit ExactCurve(Law law) : law_(checked(std::move(law))), moment_ratio_(law_->moment_ratio()) {}

  [[nodiscard]] const PressureLaw& law() const noexcept { return *law_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }

  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    twist = twist.magnitudes();
    const double sum = twist.slide + twist.spin;
    if (!(sum > 0.0)) return {sum, sum};
    const double s = twist.cor();
    return s == 0.0 ? UnitWrench{0.0, moment_ratio_} : inwards(law_->forces(s, Slope::unwanted));
  }

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept {
    twist = twist.magnitudes();
    // du = −u² ds. Towards pure sliding df/ds vanishes like u³; the lower bound on u keeps u⁻² finite and the limit correct.
    const double u = (std::max)(twist.spin_fraction(), 1e-80);
    const double s = (std::min)(twist.cor(), 1e80);
    const UnitForces<double> forces = law_->forces(s);
    const double slope = forces.force_slope / (u * u);
    return {twist.spin > 0.0 ? inwards(forces) : UnitWrench{1.0, 0.0}, {-slope, s * slope}};
  }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    direction = direction.magnitudes();
    // First guess: the ellipse's normal, which is within a factor of two of the curve's.
    const double spin = direction.moment / moment_ratio_;
    return search_along(*this, direction, spin / (direction.force * moment_ratio_ + spin));
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept { return gauge_along(*this, wrench); }

 private:
  static UnitWrench inwards(const UnitForces<double>& forces) noexcept {
    // Both ends, pure spin and pure sliding, are exact.
    if (forces.force == 0.0 || forces.moment == 0.0) return {forces.force, forces.moment};
    // Most errors of the closed forms are below four units in the last place; the documented bound is accuracy::forces_closed.
    constexpr double fraction = 1.0 - 4.0 * std::numeric_limits<double>::epsilon();
    return {fraction * forces.force, fraction * forces.moment};
  }

  Law law_;
  double moment_ratio_;
};

static_assert(LimitCurve<ExactCurve>);

}  // namespace limitcurve
