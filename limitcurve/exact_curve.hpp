// SPDX-License-Identifier: MIT
#pragma once

#include "limit_curve.hpp"
#include "pressure_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limitcurve {

/// The exact unit limit curve of a pressure law (eq. 17), against which you can judge models; in a control loop use a
/// Table. Models LimitCurve. `wrench` has the error and the cost of the law's `forces`. The ends are exact. All
/// wrenches in between are scaled by 1 − 9e-16, so that rounding seldom puts them outside the curve.
class ExactCurve {
 public:
  /// Throws std::invalid_argument for a law that `checked` rejects.
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
    // du = −u² ds. Towards pure sliding df/ds vanishes like u³; the lower bound on u keeps u⁻² finite and the limit
    // correct.
    const double u = (std::max)(twist.spin_fraction(), 1e-80);
    const double s = (std::min)(twist.cor(), 1e80);
    const UnitForces<double> forces = law_->forces(s);
    const double slope = forces.force_slope / (u * u);
    return {twist.spin > 0.0 ? inwards(forces) : UnitWrench{1.0, 0.0}, {-slope, s * slope}};
  }

  /// Newton's method for ln(f M/(m F)) in ln s inside a bracket: towards both ends ln f and ln m are straight lines in
  /// it, and however near a slip is to an end, s keeps its digits. The wrench is where the ray meets the tangent at the
  /// last point: its error is the square of the search's. Cost: usually 3 to 5 calls of `forces`, at most 64.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    constexpr int search_limit = 64;
    constexpr double enough = 1e-10;
    constexpr double most = 1e80;  // from here on m falls like 1/s, and df/ds, which falls like s^-3, would underflow
    direction = direction.magnitudes();
    const double size = (std::max)(direction.force, direction.moment);
    const auto [force, moment] = UnitWrench{direction.force / size, direction.moment / size};
    if (force == 0.0 || moment == 0.0)
      return {force == 0.0 ? UnitWrench{0.0, moment_ratio_} : UnitWrench{1.0, 0.0}, {force, moment}};
    double low = 1e-300;
    double high = 1e300;
    // First guess: the ellipse's normal.
    double s = std::clamp(moment_ratio_ * moment_ratio_ * (force / moment), low, high);
    UnitForces<double> here{};
    for (int i = 0; i < search_limit; ++i) {
      const double at = (std::min)(s, most);
      here = law_->forces(at);
      const double miss = std::log((here.force / here.moment) * (s / at) / (force / moment));
      (miss < 0.0 ? low : high) = s;
      double next = s * std::exp(-miss / (at * here.force_slope * (1.0 / here.force + at / here.moment)));
      const bool is_inside = next > low && next < high;
      const bool is_last = std::fabs(miss) <= enough;
      if (!is_inside) next = is_last ? s : std::sqrt(low) * std::sqrt(high);
      if (next == s || std::isnan(miss)) break;
      s = next;
      if (is_last) break;
    }
    const SlipTwist normal = SlipTwist::about_cor(s);
    const UnitWrench wrench = inwards(here);
    const double scale =
        (normal.slide * wrench.force + normal.spin * wrench.moment) / (normal.slide * force + normal.spin * moment);
    return {{scale * force, scale * moment}, normal};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    wrench = wrench.magnitudes();
    const double sum = wrench.force + wrench.moment;
    return sum > 0.0 && sum <= (std::numeric_limits<double>::max)() ? gauge_from(wrench, along(wrench).wrench) : sum;
  }

 private:
  static UnitWrench inwards(const UnitForces<double>& forces) noexcept {
    // Both ends, pure spin and pure sliding, are exact.
    if (forces.force == 0.0 || forces.moment == 0.0) return {forces.force, forces.moment};
    // Most errors of the closed forms are below four units in the last place; the documented bound is
    // accuracy::forces_closed.
    constexpr double fraction = 1.0 - 4.0 * std::numeric_limits<double>::epsilon();
    return {fraction * forces.force, fraction * forces.moment};
  }

  Law law_;
  double moment_ratio_;
};

static_assert(LimitCurve<ExactCurve>);

}  // namespace limitcurve
