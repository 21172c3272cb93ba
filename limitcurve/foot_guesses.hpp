// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/side_guesses.hpp"
#include "limitcurve/table.hpp"

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
  /// Sums from here on are left to Table::closest: pulls that far beyond the curve are rare.
  static constexpr double farthest = 4.0;

  /// Expects χ within 1e±100. Cost: some 2000 searches; 86 KB, and 32 bytes for every cell of the table.
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
    const Pair at = Pair{squares[1] * SideGuesses::shares, SideGuesses::distances} / Pair{sum, sum};
    // The trial's side of the normal at the rim.
    const Pair beyond_rim = trial - Pair{table.rim().force, table.rim().moment};
    if (beyond_rim[0] > chi_ * beyond_rim[1]) {
      const auto [moment, force, x, cell] = outside_.closest_in_one_step(table.outside(), Pair{trial[1], trial[0]}, at);
      return {{force, moment}, {1.0, x}, 2.0 - x, cell};
    }
    const auto [force, moment, x, cell] = inside_.closest_in_one_step(table.inside(), trial, at);
    return {{force, moment}, {x, 1.0}, x, cell};
  }

 private:
  /// On the chord, less some rounding; squares that vanish may tell less.
  static constexpr double least = 0.5 - 1e-9;

  /// By what multiple the foot's c/a exceeds x̂/ŷ.
  static SideGuesses::Corners multiples(const Table& table, double chi);
  FootGuesses(const Table& table, double chi, const SideGuesses::Corners& multiples);

  SideGuesses inside_;
  SideGuesses outside_;
  double chi_;
  double per_chi_;
};

}  // namespace limitcurve
