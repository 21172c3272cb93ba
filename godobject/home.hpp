// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_law.hpp"
#include "godobject/stretch.hpp"

#include <Eigen/Core>

#include <bit>
#include <cstdint>

namespace limitcurve::godobject {

/// How near a contact must stay to where all was last asked of it (FingerState::home) for a step to ask nothing else. Of two contacts at one home
/// neither is a leap from the other, nor turned by half a turn; both touch and have torsional friction; and the springs between them are drawn
/// by so much, in units of the limits, that no square vanishes or overflows.
class Home {
 public:
  /// None is farther from home in any coordinate, or deeper [m], …
  static constexpr double farthest = 1.0;
  /// … or turned farther [rad]: two of them are less than π apart.
  static constexpr double farthest_twist = 1.5;

  /// Of fingers that leap beyond `jump_limit` [m] > 0, by the lengths in which an ellipse with the boundary's intercepts measures: `reach_per_unit`
  /// [m/N] (Friction::reach_per_unit) and `arm_times_radius` [m²]. With dampers, or a radius that depends on the load, there is more to ask,
  /// and without torsional friction less: nothing is at home.
  Home(const ContactLaw& law, double jump_limit, double reach_per_unit, double arm_times_radius) noexcept;

  /// Whether a contact so deep [m] may have a home.
  [[gnu::always_inline]] [[nodiscard]] bool takes(double depth) const noexcept {
    // By the bits, whose order is that of the numbers as far as those are ≥ 0; what is negative or not a number is above all.
    return std::bit_cast<std::uint64_t>(depth) - first_depth_ < depths_;
  }
  /// Whether a contact is at home that has moved so far from there, and is so deep [m].
  [[gnu::always_inline]] [[nodiscard]] bool holds(const Stretch& from_home, double depth) const noexcept {
    return from_home.is_within(reach_) && takes(depth);
  }

 private:
  Stretch reach_;
  std::uint64_t first_depth_ = 0;  // its bits
  std::uint64_t depths_ = 0;       // how many there are from there on
};

}  // namespace limitcurve::godobject
