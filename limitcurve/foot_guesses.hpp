// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/table.hpp"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace limitcurve {

/// First guesses at the closest points of one table in one metric f² + χm², for searches that have no last one to begin from: where a
/// contact begins to slip.
///
/// Tabulated is by what multiple the coordinate of the foot on its side exceeds what the trial alone tells, the quotient of its components;
/// m_max/f_max or the inverse throughout where the curve is an ellipse and the metric its own. It is bilinear between the corners of a grid
/// over the share that the moment's square has in (x̂/f_max)² + (ŷ/m_max)², and over one over that sum, which is 1 on the ellipse of the
/// intercepts: squares, because a step knows them before it has drawn a root. Near a curve the guess is good to 3e-4 as a rule, and to some
/// 1e-3 about the rim, where the curve's derivatives are singular.
class FootGuesses {
 public:
  /// Cells of the grid are as wide as one over so many: of the share from 0 to 1, …
  static constexpr std::size_t shares = 64;
  /// … and of one over the sum, from 1/4 to 2, which it is on the chord where the shares are even.
  static constexpr std::size_t distances = 32;
  /// Sums from here on are left to Table::closest: pulls that far beyond the curve are rare.
  static constexpr double farthest = 4.0;

  /// Expects χ within 1e±100. Cost: some 2000 searches; 69 KB, and 32 bytes for every cell of the table.
  FootGuesses(const Table& table, double chi);

  /// As Table::closest, for the table that the guesses are for and a finite trial that is on or beyond the chord of the intercepts. `squares`
  /// are those of x̂/f_max and ŷ/m_max, and may be rounded otherwise.
  [[gnu::always_inline]] [[nodiscard]] Foot closest(const Table& table, Pair trial, Pair squares) const noexcept {
    const Foot found = closest_in_one_step(table, trial, squares);
    if (found.piece != TableSide::none) [[likely]]
      return found;
    return table.search_closest({trial[0], trial[1]}, chi_, per_chi_, found.place);
  }

  /// The same if one step of the fourth order leads there from the guess, as it does as a rule; else its piece is TableSide::none, and its place
  /// one to search from.
  [[gnu::always_inline]] [[nodiscard]] Foot closest_in_one_step(const Table& table, Pair trial, Pair squares) const noexcept {
    const double sum = squares[0] + squares[1];
    if (!is_between(sum, least, farthest)) [[unlikely]]
      return {{}, {}, -1.0, TableSide::none};
    const Pair at = Pair{squares[1] * shares, distances} / Pair{sum, sum};
    // The trial's side of the normal at the rim.
    const Pair beyond_rim = trial - Pair{table.rim().force, table.rim().moment};
    if (beyond_rim[0] > chi_ * beyond_rim[1]) {
      const double start = trial[1] / trial[0] * multiple(corners_[1], at);
      const auto [moment, force, x, cell] = table.outside().closest_in_one_long_step(Pair{trial[1], trial[0]}, per_chi_, start, trusts_[1]);
      return {{force, moment}, {1.0, x}, 2.0 - x, cell};
    }
    const double start = trial[0] / trial[1] * multiple(corners_[0], at);
    const auto [force, moment, x, cell] = table.inside().closest_in_one_long_step(trial, chi_, start, trusts_[0]);
    return {{force, moment}, {x, 1.0}, x, cell};
  }

 private:
  static constexpr std::size_t first_distance = distances / 4;
  static constexpr std::size_t last_distance = 2 * distances;
  /// On the chord, less some rounding; squares that vanish may tell less.
  static constexpr double least = 0.5 - 1e-9;
  /// Corners of one share, in a row; a power of two is found without a product.
  static constexpr std::size_t stride = 64;
  static_assert(last_distance - first_distance + 2 <= stride);
  using Corners = std::array<double, (shares + 3) * stride>;

  /// At a share and a distance in cells. The nearest whole numbers are the last bits of what adding a number so large leaves; corners
  /// lie half a cell before them.
  [[gnu::always_inline]] [[nodiscard]] static double multiple(const Corners& corners, Pair at) noexcept {
    const Pair shifted = at + paired.whole;
    const auto whole = [](double number) { return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(number) & 0xFFFF); };
    const double* const corner = &corners[whole(shifted[0]) * stride + whole(shifted[1])];
    Pair left;
    Pair right;
    std::memcpy(&left, corner, sizeof left);
    std::memcpy(&right, corner + stride, sizeof right);
    // What weighs the corners need not wait for them.
    const Pair from = at - (shifted - paired.whole);
    const Pair before = paired.half - from;
    const Pair after = paired.half + from;
    const Pair by_distance{before[1], after[1]};
    const Pair weighed = left * (by_distance * before[0]) + right * (by_distance * after[0]);
    return weighed[0] + weighed[1];
  }

  std::array<Corners, 2> corners_;  // inside, outside; by share, then by distance
  std::array<std::vector<TableSide::Trust>, 2> trusts_;
  double chi_;
  double per_chi_;
};

}  // namespace limitcurve
