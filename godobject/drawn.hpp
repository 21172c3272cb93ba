// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/projection.hpp"
#include "limitcurve/pair.hpp"

#include <bit>
#include <cstdint>

namespace limitcurve::godobject {

/// What the springs are drawn by, as a trial.
struct Drawn {
  Pair stretch;  ///< (r, ρ)
  Trial trial;
  Pair of_intercepts;  ///< (x̂/f_max, ŷ/m_max)
  Pair squares;        ///< of `of_intercepts` in the dynamic limit, but for rounding; sooner, for they wait for no root

  /// Where the trial lies between the origin and the chord of the intercepts: 1 on it.
  [[gnu::always_inline]] [[nodiscard]] double chord() const noexcept { return of_intercepts[0] + of_intercepts[1]; }
  /// Within the chord it holds, whatever the curve.
  [[gnu::always_inline]] [[nodiscard]] bool holds() const noexcept {
    return std::bit_cast<std::int64_t>(chord()) <= std::bit_cast<std::int64_t>(1.0);
  }
  /// Whether it is beyond the chord for sure, which is sooner told.
  [[gnu::always_inline]] [[nodiscard]] bool exceeds_chord() const noexcept {
    return std::bit_cast<std::int64_t>(squares[0] + squares[1]) > std::bit_cast<std::int64_t>(1.0 + 1e-12);
  }
};

}  // namespace limitcurve::godobject
