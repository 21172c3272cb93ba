// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/double_exponential.hpp"

#include <functional>
#include <vector>

namespace limitcurve {

/// A function's range cut into pieces on which tanh–sinh quadrature of it is good.
struct SmoothPieces {
  std::vector<Extended> breaks;  ///< increasing: those that were told, and those that were found
  Extended integral = 0;         ///< of the whole
  Extended error = 0;            ///< what the pieces' integrals may be off by, as a share of the whole
};

/// Finds the kinks and jumps of a function ≥ 0 that nobody told of. A piece whose integral is not the sum of its halves' is halved
/// until they agree, or it is as narrow as a rounding; what is smooth together is then joined again. So a kink is pinned to where no
/// more than 1e-15 of the integral depends on its place, and a function that is smooth between the `breaks` told gets no other.
///
/// A function that this cannot cut into 64 pieces (noise of more than some 1e-13, a hundred jumps) is left with the breaks told, and
/// with the error that it then has. A feature so narrow that all points miss it stays unseen: three times 100 points lie in a piece, denser
/// towards its ends. Costs some 5000 evaluations for a smooth piece, and some 1e5 for a kink; at most 1e7.
[[nodiscard]] SmoothPieces smooth_pieces(const std::function<Extended(Extended)>& function, const std::vector<Extended>& breaks);

}  // namespace limitcurve
