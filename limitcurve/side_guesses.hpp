// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pair.hpp"
#include "limitcurve/table_side.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <tuple>
#include <vector>

namespace limitcurve {

/// First guesses at the closest points on one side of a table (FootGuesses): by what multiple their coordinate exceeds the quotient of the
/// trial's components, bilinear between the corners of a grid, and for each of the grid's cells the table's, where the guess is or next to it,
/// so that nobody waits for the guess to look for that.
class SideGuesses {
 public:
  /// Cells of the grid are as wide as one over so many: of the share from 0 to 1, …
  static constexpr std::size_t shares = 64;
  /// … and of the distance, from the first to the last.
  static constexpr std::size_t distances = 32;
  static constexpr std::size_t first_distance = distances / 4;
  static constexpr std::size_t last_distance = 2 * distances;
  /// Corners of one share, in a row; a power of two is found without a product.
  static constexpr std::size_t stride = 64;
  static_assert(last_distance - first_distance + 2 <= stride);
  /// By share, then by distance; half a cell before the place of the same numbers.
  using Corners = std::array<double, (shares + 3) * stride>;

  /// Of a side in the metric (1, 1/κ). `quotient(share)` is that of the components, primary : secondary, of a trial of that share.
  SideGuesses(const TableSide& side, double kappa, const Corners& corners, const std::function<double(double)>& quotient);

  /// As TableSide::closest_in_one_long_step from the guess at a place of the grid, (share, distance) in cells.
  [[gnu::always_inline]] [[nodiscard]] TableSide::Point closest_in_one_step(const TableSide& side, Pair trial, Pair place) const noexcept {
    // The nearest whole numbers are the last bits of what adding a number so large leaves.
    const Pair shifted = place + paired.whole;
    const auto whole = [](double number) { return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(number) & 0xFFFF); };
    const std::size_t cell = whole(shifted[0]) * stride + whole(shifted[1]);
    Pair left;
    Pair right;
    std::memcpy(&left, &corners_[cell], sizeof left);
    std::memcpy(&right, &corners_[cell + stride], sizeof right);
    // What weighs the corners need not wait for them.
    const Pair from = place - (shifted - paired.whole);
    const Pair before = paired.half - from;
    const Pair after = paired.half + from;
    const Pair by_distance{before[1], after[1]};
    const Pair weighed = left * (by_distance * before[0]) + right * (by_distance * after[0]);
    return side.closest_in_one_long_step(trial, kappa_, trial[0] / trial[1] * (weighed[0] + weighed[1]), cells_[cell], trusts_);
  }

 private:
  Corners corners_;
  std::array<std::uint16_t, std::tuple_size_v<Corners>> cells_{};  // of the table, by the first of the corners around
  std::vector<TableSide::Trust> trusts_;
  double kappa_;
};

}  // namespace limitcurve
