// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

#include <functional>
#include <vector>

namespace limitcurve {

/// A function's range cut into pieces on which tanh–sinh quadrature of it is good.
struct SmoothPieces {
  std::vector<Extended> breaks;  ///< increasing: those that were told, and those that were found
  Extended integral = 0;         ///< of the whole
  Extended error = 0;            ///< what the pieces' integrals may be off by, as a share of the whole
};

/// Finds the kinks and jumps of a function ≥ 0 that nobody told of, and whatever else is at least `narrowest_feature` wide, as a share of the last
/// break. The function is looked at in any such width. A piece whose integral is not the sum of its halves' is halved
/// until they agree to 1e-16 of the whole, or it is as narrow as a rounding; what is smooth together is then joined again. So a kink is pinned
/// between two breaks that no more than a rounding of the integral depends on, and a function that is smooth between the `breaks` told gets
/// no other.
///
/// Where more than 64 places are not smooth (noise, jumps by the hundred) less agreement is asked for, down to 1e-7; what cannot be had even
/// then is left in at most 128 even pieces between the breaks told. `error` says what it came to. Costs 25 to 150 evaluations per
/// narrowest feature, 1e5 for a kink, 1e8 at most.
[[nodiscard]] SmoothPieces smooth_pieces(const std::function<Extended(Extended)>& function, const std::vector<Extended>& breaks,
                                         Extended narrowest_feature = 1e-4L);

}  // namespace limitcurve
