// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_curve.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace limitcurve {

/// The unit limit curve of a pressure law, exact: a limit curve. Relative error of the wrench: that of the law's `forces`,
/// ≤ 1e-14 to 1e-13, and 9e-16 inwards, so that a wrench that is brought back onto the curve is not as often outside.
/// Cost: that of the law's `forces`: nanoseconds where it is closed, microseconds by quadrature. A loop uses a table.
class ExactCurve {
 public:
  explicit ExactCurve(Law law) : law_(std::move(law)), moment_ratio_(law_->moment_ratio()) {}

  [[nodiscard]] const PressureLaw& law() const noexcept { return *law_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }

  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept { return inwards(law_->forces(twist.cor(), Slope::unwanted)); }

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept {
    // du = −u² ds. Towards pure sliding df/ds vanishes like u³; the floor keeps u⁻² finite and the limit right.
    const double u = (std::max)(twist.spin_fraction(), 1e-80);
    const double s = (std::min)(twist.cor(), 1e80);
    const UnitForces<double> forces = law_->forces(s);
    const double slope = forces.force_slope / (u * u);
    return {inwards(forces), {-slope, s * slope}};
  }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    // The ellipse's normal is within a factor two of the curve's.
    const double spin = direction.moment / moment_ratio_;
    return search_along(*this, direction, spin / (direction.force * moment_ratio_ + spin));
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return wrench.force + wrench.moment > 0.0 ? gauge_from(wrench, along(wrench).wrench) : 0.0;
  }

 private:
  static UnitWrench inwards(const UnitForces<double>& forces) noexcept {
    // The closed forms are mostly off by less than four units (accuracy::forces_closed is what is promised).
    constexpr double share = 1.0 - 4.0 * std::numeric_limits<double>::epsilon();
    return {share * forces.force, share * forces.moment};
  }

  Law law_;
  double moment_ratio_;
};

static_assert(LimitCurve<ExactCurve>);

}  // namespace limitcurve
