// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace limitcurve {

/// The unit limit curve of a pressure law, exact: a limit boundary. Relative error of the wrench: that of
/// the law's `forces`, ≤ 1e-14 to 1e-13.
/// Cost: that of the law's `forces`: some nanoseconds where it is closed, some microseconds by quadrature, which `expanded`
/// (expanded_law.hpp) makes nanoseconds again.
class ExactCurve {
 public:
  explicit ExactCurve(Law law) : law_(std::move(law)), moment_ratio_(law_->moment_ratio()) {}

  [[nodiscard]] const PressureLaw& law() const noexcept { return *law_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }

  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const UnitForces<double> forces = law_->forces(twist.cor());
    return {forces.force, forces.moment};
  }

  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept {
    // du = −u² ds. Towards pure sliding df/ds vanishes like u³; the floor keeps u⁻² finite and the limit right.
    const double u = std::max(twist.spin_fraction(), 1e-80);
    const double s = std::min(twist.cor(), 1e80);
    const UnitForces<double> forces = law_->forces(s);
    const double slope = forces.force_slope / (u * u);
    return {{forces.force, forces.moment}, {-slope, s * slope}};
  }

  /// One unit in the last place inwards: the law's own rounding would put a wrench that is brought back onto the curve as often outside.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    // The ellipse's normal is within a factor two of the curve's.
    const double spin = direction.moment / moment_ratio_;
    RadialPoint found = search_along(*this, direction, spin / (direction.force * moment_ratio_ + spin));
    found.wrench.force *= inwards;
    found.wrench.moment *= inwards;
    return found;
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return wrench.force + wrench.moment > 0.0 ? gauge_from(wrench, along(wrench).wrench) : 0.0;
  }

 private:
  static constexpr double inwards = 1.0 - std::numeric_limits<double>::epsilon();

  Law law_;
  double moment_ratio_;
};

static_assert(LimitBoundary<ExactCurve>);

}  // namespace limitcurve
