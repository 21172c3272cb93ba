// SPDX-License-Identifier: MIT
#pragma once

#include "version.hpp"

#include <limits>

namespace limitcurve {

/// A friction wrench in dimensionless units: force f = F/(μP), moment m = M/(μPa).
/// The components are magnitudes, ≥ 0, so the caller must keep the senses of sliding and twisting.
struct UnitWrench {
  double force = 0.0;
  double moment = 0.0;

  /// The wrench without signs.
  [[nodiscard]] constexpr UnitWrench magnitudes() const noexcept {
    return {force < 0.0 ? -force : force, moment < 0.0 ? -moment : moment};
  }

  friend bool operator==(const UnitWrench&, const UnitWrench&) = default;
};

/// The direction of slip, (|v| : a|ω|), compares the sliding speed with the rim speed of the rotation. Only the ratio
/// matters. This direction is the outward normal of the limit curve at the wrench that the slip causes (maximum
/// dissipation). Unlike the distance c of the centre of rotation, the direction is finite for pure sliding and for pure
/// spin.
struct SlipTwist {
  double slide = 0.0;  ///< |v| [m/s, or any unit]
  double spin = 1.0;   ///< a|ω| [same unit]

  /// The twist whose centre of rotation (COR) lies at s = c/a from the contact centre; |s| ∈ [0, ∞].
  static constexpr SlipTwist about_cor(double s) noexcept {
    // (1, 1/s), not (s/(1+s), 1/(1+s)): both ends keep full relative precision.
    return s <= 1.0 ? SlipTwist{s, 1.0} : SlipTwist{1.0, 1.0 / s};
  }

  /// The twist of spin fraction u ∈ [0, 1]: 0 is pure sliding, ½ has its COR on the rim, 1 is pure spin.
  static constexpr SlipTwist of_spin_fraction(double u) noexcept { return {1.0 - u, u}; }

  /// The twist without signs, because wrenches are magnitudes, whatever the senses of sliding and turning.
  [[nodiscard]] constexpr SlipTwist magnitudes() const noexcept {
    return {slide < 0.0 ? -slide : slide, spin < 0.0 ? -spin : spin};
  }
  /// Whether there is no slip. The wrench of such a twist is 0, although many other wrenches hold.
  [[nodiscard]] constexpr bool is_zero() const noexcept { return slide == 0.0 && spin == 0.0; }
  /// The direction of a slip as magnitudes of which the larger is 1. An infinite component gives the direction of that
  /// axis. `slide` is NaN if a component is NaN, or if they are both ∞ or both 0.
  [[nodiscard]] constexpr SlipTwist direction() const noexcept {
    const auto [v, w] = magnitudes();
    return v > w ? SlipTwist{1.0, w / v} : SlipTwist{v / w, 1.0};
  }

  /// For slide, spin ≥ 0, not both zero. s = c/a ∈ [0, ∞]: distance of the COR in contact radii.
  [[nodiscard]] constexpr double cor() const noexcept {
    return spin > 0.0 ? slide / spin : std::numeric_limits<double>::infinity();
  }

  /// Spin fraction u = aω/(|v| + aω) ∈ [0, 1].
  [[nodiscard]] constexpr double spin_fraction() const noexcept { return spin / (slide + spin); }
};

/// A point of a limit curve and its derivative in the spin fraction u. The slopes satisfy dm/du = −s·df/du
/// (docs/theory.md).
struct SlopedPoint {
  UnitWrench wrench;
  UnitWrench slope;  ///< (df/du, dm/du): df/du ≤ 0 ≤ dm/du
};

/// The point where a ray from the origin meets a limit curve, and the outward normal there, which is a slip twist.
struct RadialPoint {
  UnitWrench wrench;
  SlipTwist normal;
};

/// A unit wrench, a bound on the absolute error of each component, and the slope of the force.
struct WrenchEstimate {
  UnitWrench wrench;
  UnitWrench error;          ///< absolute, ≥ 0
  double force_slope = 0.0;  ///< df/ds; the moment has dm/ds = −s·df/ds
};

/// A unit wrench and the slope of its force, df/ds, in double or extended precision.
template <class Real>
struct UnitForces {
  Real force;
  Real moment;
  Real force_slope;

  constexpr UnitForces& operator+=(const UnitForces& other) noexcept {
    force += other.force;
    moment += other.moment;
    force_slope += other.force_slope;
    return *this;
  }
  friend constexpr UnitForces operator*(Real factor, const UnitForces& forces) noexcept {
    return {factor * forces.force, factor * forces.moment, factor * forces.force_slope};
  }
};

/// A value and the truncation error of its quadrature, without rounding.
template <class Real>
struct Quadrature {
  UnitForces<Real> forces;
  UnitForces<Real> error;
};

}  // namespace limitcurve
