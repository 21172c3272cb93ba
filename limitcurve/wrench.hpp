// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace limitcurve {

/// A friction wrench in units of what the contact could bear: force f = F/(μP), moment m = M/(μPa).
/// Both are magnitudes, ≥ 0; the sense of sliding and of twisting is the caller's.
struct UnitWrench {
  double force = 0.0;
  double moment = 0.0;

  friend bool operator==(const UnitWrench&, const UnitWrench&) = default;
};

/// The direction in which a contact slips: (|v| : a|ω|), sliding speed against rim speed of the twist.
/// Only the ratio matters. It is also the outward normal of the limit curve at the wrench it causes
/// (maximum dissipation), and, unlike the distance c of the centre of rotation, regular at both ends.
struct SlipTwist {
  double slide = 0.0;  ///< |v|, ≥ 0
  double spin = 1.0;   ///< a|ω|, ≥ 0; not both zero

  /// The twist whose centre of rotation (COR) lies at s = c/a from the contact centre, s ∈ [0, ∞].
  static constexpr SlipTwist about_cor(double s) noexcept {
    // 1/s, not s/(1+s): both ends keep full relative precision.
    return s <= 1.0 ? SlipTwist{s, 1.0} : SlipTwist{1.0, 1.0 / s};
  }

  /// The twist of spin fraction u ∈ [0, 1]: 0 is pure sliding, ½ has its COR on the rim, 1 is pure spin.
  static constexpr SlipTwist of_spin_fraction(double u) noexcept { return {1.0 - u, u}; }

  /// The twist at the place t ∈ [0, 2]: s = c/a up to the rim (t = 1), 2 − 1/s beyond. Runs from pure spin to pure sliding,
  /// and neither way needs a division where the twist is about_cor or from a table.
  static constexpr SlipTwist at_place(double t) noexcept { return t <= 1.0 ? SlipTwist{t, 1.0} : SlipTwist{1.0, 2.0 - t}; }

  /// s = c/a ∈ [0, ∞]: distance of the COR in contact radii.
  [[nodiscard]] constexpr double cor() const noexcept { return spin > 0.0 ? slide / spin : std::numeric_limits<double>::infinity(); }

  /// u = aω/(|v| + aω) ∈ [0, 1].
  [[nodiscard]] constexpr double spin_fraction() const noexcept { return spin / (slide + spin); }

  /// t ∈ [0, 2], see at_place.
  [[nodiscard]] constexpr double place() const noexcept { return slide <= spin ? slide / spin : 2.0 - spin / slide; }
};

/// A point of a limit curve with its derivative along the spin fraction u. On an exact curve the
/// two slopes obey dm/du = −s·df/du (dm/df = −s, theory of the support function); an interpolant has its own.
struct SlopedPoint {
  UnitWrench wrench;
  UnitWrench slope;  ///< (df/du, dm/du): df/du ≤ 0 ≤ dm/du
};

/// Where a ray from the origin meets a limit curve, and the slip twist that is the normal there.
struct RadialPoint {
  UnitWrench wrench;
  SlipTwist normal;
};

/// A unit wrench with a bound on the absolute error of each component, and the slope of the force.
struct WrenchEstimate {
  UnitWrench wrench;
  UnitWrench error;          ///< absolute, ≥ 0
  double force_slope = 0.0;  ///< df/ds; the moment's is dm/ds = −s·df/ds
};

/// A unit wrench and the slope of its force, df/ds, in the precision of a reference.
template <class Real>
struct UnitForces {
  Real force;
  Real moment;
  Real force_slope;
};

}  // namespace limitcurve
