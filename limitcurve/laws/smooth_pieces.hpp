// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/law.hpp"

#include <functional>
#include <vector>

namespace limitcurve {

/// A range divided into pieces on which tanh–sinh quadrature of a function converges fast.
struct SmoothPieces {
  std::vector<Extended> breaks;  ///< increasing: the given ones and those that the search found
  Extended integral = 0;         ///< over the whole range
  Extended error = 0;            ///< error of the sum of the pieces' integrals, as a fraction of `integral`
};

/// Finds the kinks and jumps of a function ≥ 0 that `breaks` leaves out, and every feature at least `narrowest_feature` wide (a fraction of
/// the last break). The function is sampled in every interval of that width. A piece is halved until its integral and that of its halves
/// agree to 1e-16 of the whole, or until it is as narrow as a rounding; neighbours that are smooth together are then joined again. So two
/// breaks enclose each kink, and the integral between them is no more than a rounding. A function that is smooth between the given `breaks`
/// gets no other.
///
/// If more than 64 points are not smooth (noise, hundreds of jumps), the required agreement is relaxed, down to 1e-7. If even that fails,
/// the result has at most 128 even pieces between the given breaks. `error` states what was reached. Cost: 25 to 150 evaluations for each
/// narrowest feature, 1e5 for a kink, at most 1e8.
[[nodiscard]] SmoothPieces smooth_pieces(const std::function<Extended(Extended)>& function, const std::vector<Extended>& breaks,
                                         Extended narrowest_feature = 1e-4L);

}  // namespace limitcurve
