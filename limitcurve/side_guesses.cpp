// SPDX-License-Identifier: MIT
#include "limitcurve/side_guesses.hpp"

#include <algorithm>
#include <cmath>

namespace limitcurve {

SideGuesses::SideGuesses(const TableSide& side, double kappa, const Corners& corners, const std::function<double(double)>& quotient)
    : corners_(corners), trusts_(side.trusts(kappa)), kappa_(kappa) {
  for (std::size_t i = 0; i <= shares; ++i) {
    const double middle =
        quotient(std::clamp(static_cast<double>(i), 0.25, static_cast<double>(shares) - 0.25) / static_cast<double>(shares));
    for (std::size_t j = first_distance; j <= last_distance; ++j) {
      const std::size_t cell = i * stride + j;
      const double multiple = 0.25 * (corners[cell] + corners[cell + 1] + corners[cell + stride] + corners[cell + stride + 1]);
      // What is on the other side is not asked for.
      cells_[cell] = static_cast<std::uint16_t>(side.number_of(side.cell(std::min(middle * multiple, 1.0))));
    }
  }
}

}  // namespace limitcurve
