// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/float_table.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace limitcurve::godobject::detail {

/// One step of a search in a cell.
struct FloatSearchStep {
  float next;
  float primary;  ///< the curve there, by the cell's cubics
  float secondary;
  float last;  ///< 1 if what it leaves is below a rounding, else 0
};

/// Number of the cell, from the rim, that holds x ∈ [0, 1].
[[gnu::always_inline]] inline std::int32_t cell_number(float x, float cells) noexcept {
  const float from_rim = std::sqrt(1.0F - x) * cells;
  const float last = cells - 1.0F;
  return static_cast<std::int32_t>(from_rim < last ? from_rim : last);
}

/// Newton's step with the second derivative's correction for the point whose normal (x : 1) leads, in the metric of the
/// compliances, to the trial: h(x) = p̂ − p − κx(ŝ − s) = 0.
[[gnu::always_inline]] inline FloatSearchStep step_from(float x, float kappa, float trial_primary, float trial_secondary, float cells,
                                                        float left, float rise, float constant_0, float constant_1, float square_0,
                                                        float square_1, float cube_0, float cube_1) noexcept {
  const float fall_1 = -left * rise;
  const float d = x - left;
  const float cubed_0 = d * cube_0;
  const float cubed_1 = d * cube_1;
  const float bent_0 = square_0 + cubed_0;
  const float bent_1 = square_1 + cubed_1;
  const float rest_0 = bent_0 + (cubed_0 + cubed_0);
  const float rest_1 = bent_1 + (cubed_1 + cubed_1);
  const float over_0 = trial_primary - ((constant_0 + d * rise) + (d * d) * bent_0);
  const float over_1 = trial_secondary - ((constant_1 + d * fall_1) + (d * d) * bent_1);
  const float slope_0 = rise + d * (square_0 + rest_0);
  const float slope_1 = fall_1 + d * (square_1 + rest_1);
  const float lever = x * kappa;
  const float per_fall = 1.0F / ((slope_0 - lever * slope_1) + kappa * over_1);
  const float half_bend = (rest_0 - lever * rest_1) - kappa * slope_1;
  const float third = 6.0F * cube_0 - lever * (6.0F * cube_1) - 6.0F * (kappa * rest_1);
  const float newton = (over_0 - lever * over_1) * per_fall;
  const float square = newton * newton;
  const float correction = half_bend * per_fall * square;
  const float size = std::fabs(newton);
  const float wanted = x + (std::fabs(correction) < 0.5F * size ? newton - correction : newton);
  // Onto the side, NaN onto its end.
  const float not_beyond = wanted < 1.0F ? wanted : 1.0F;
  const float next = not_beyond > 0.0F ? not_beyond : 0.0F;
  // Relative to x, for the component that vanishes with it.
  const float share = 0x1p-22F * x;
  const bool small = (correction * correction <= share * size) & (std::fabs(third * per_fall) * square * size <= share);
  // In the cell, or so little out of it that its cubics still hold.
  const bool here = (cell_number(next, cells) == cell_number(x, cells)) | (size <= 0x1p-20F * x);
  const float there = next - left;
  return {next, (constant_0 + there * rise) + (there * there) * (square_0 + there * cube_0),
          (constant_1 + there * fall_1) + (there * there) * (square_1 + there * cube_1), (small & here & (size <= 1.0F) & (per_fall > 0.0F)) ? 1.0F : 0.0F};
}

/// A search by itself, on a side of a table.
class FloatSearch {
 public:
  FloatSearch(std::span<const FloatTable::Cell> side, float kappa, float primary, float secondary) noexcept
      : cells_(side), kappa_(kappa), primary_(primary), secondary_(secondary) {}

  [[nodiscard]] FloatSearchStep step(float x) const noexcept {
    const auto count = static_cast<float>(cells_.size());
    const FloatTable::Cell& cell = cells_[static_cast<std::size_t>(cell_number(x, count))];
    return step_from(x, kappa_, primary_, secondary_, count, cell.left, cell.rise, cell.constant[0], cell.constant[1], cell.square[0],
                     cell.square[1], cell.cube[0], cell.cube[1]);
  }

  /// The curve at x; `next` is x.
  [[nodiscard]] FloatSearchStep at(float x) const noexcept {
    const FloatTable::Cell& cell = cells_[static_cast<std::size_t>(cell_number(x, static_cast<float>(cells_.size())))];
    const float d = x - cell.left;
    return {x, (cell.constant[0] + d * cell.rise) + (d * d) * (cell.square[0] + d * cell.cube[0]),
            (cell.constant[1] + d * (-cell.left * cell.rise)) + (d * d) * (cell.square[1] + d * cell.cube[1]), 1.0F};
  }

  /// By halves, where nothing else helps: at most 64.
  [[nodiscard]] FloatSearchStep bisect() const noexcept {
    float low = 0.0F;
    float high = 1.0F;
    FloatSearchStep here = at(1.0F);
    for (int i = 0; i < 64; ++i) {
      const float middle = 0.5F * (low + high);
      if (!(middle > low && middle < high)) break;
      here = at(middle);
      const bool nearer_rim = primary_ - here.primary > middle * kappa_ * (secondary_ - here.secondary);
      (nearer_rim ? low : high) = middle;
    }
    return here;
  }

 private:
  std::span<const FloatTable::Cell> cells_;
  float kappa_, primary_, secondary_;
};

}  // namespace limitcurve::godobject::detail
