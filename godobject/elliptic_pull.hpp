// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_law.hpp"
#include "godobject/grip.hpp"
#include "godobject/projection.hpp"
#include "limitcurve/pair.hpp"

namespace limitcurve::godobject {

/// A pull on an elliptical limit under radial projection, in lengths: the springs of the ellipse's two axes weigh ρ against r. It takes
/// squares, one root and one quotient, and shrinks r and ρ by one factor.
struct EllipticPull {
  double square;  ///< (gauge · reach)² [m²]
  double reach;   ///< r on the boundary without twist [m]

  /// Squares between these neither overflow nor lose digits when divided by; others are left to the general way.
  static constexpr double farthest_square = 1e100;
  static constexpr double least_reach = 1e-140;

  [[gnu::always_inline]] [[nodiscard]] bool holds() const noexcept { return square <= reach * reach; }
  [[gnu::always_inline]] [[nodiscard]] bool is_usual() const noexcept { return square <= farthest_square && reach >= least_reach; }

  /// What is felt of the springs of a pull that does not hold. One packed root and one packed division that do not wait for each other.
  [[gnu::always_inline]] [[nodiscard]] Grip shrink(const Pull& pull, const Springs& springs) const noexcept {
    const Pair roots = square_roots(Pair{square, pull.r_square});
    const Pair inverses = Pair{reach, 1.0} / Pair{square, pull.rho};
    const double share = roots[0] * inverses[0];
    Grip grip;
    grip.share = Pair{share, share};
    const double limit = reach * (1.0 + slip_guard);
    if (square <= limit * limit) return grip;
    grip.slips = true;
    grip.clamps_both = true;
    grip.cor = roots[1] * inverses[1];
    grip.start = 0.0;
    const Pair force_lengths = springs.stiffness * Pair{pull.r_square, pull.rho * pull.rho};
    grip.slip_work = (share * (1.0 - share)) * (force_lengths[0] + force_lengths[1]);
    return grip;
  }
};

}  // namespace limitcurve::godobject
