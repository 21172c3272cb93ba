// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pair.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace limitcurve {

/// A limit curve as chords between points at even spin fractions: where a coarse wrench by its twist is all that is asked, the cheapest
/// way to it, a third of a `Table`'s cost. Made from a `Table`, whose error and own it certifies together.
///
/// The cell is a product's whole part, and a line in the spin fraction u gives both components at once: no comparison, no index. A chord of
/// width h errs by h²/8 times the second derivative, so cells are ∝ tolerance^(−1/2); the rim, where a limit curve has not got one, is a node.
/// Every wrench lies on a chord of a convex curve: none is beyond the friction that the contact bears, but for the table's error.
/// No limit boundary: where normals jump no projection settles; it takes a `Table`.
class ChordTable {
 public:
  /// The tolerances that a table may have. Below the finest a `Table` has fewer bytes by far.
  static constexpr double finest_tolerance = 1e-7;
  static constexpr double coarsest_tolerance = 1e-1;
  static constexpr std::size_t most_cells = 1U << 16U;

  /// The wrench (f, m) as a line in the spin fraction: at 0, and what a whole one adds. 32 bytes.
  struct Cell {
    Pair start;
    Pair rise;
  };
  static_assert(sizeof(Cell) == 32);

  /// The table of `law` with |error| ≤ tolerance in f and in m at every twist.
  /// Throws std::invalid_argument if the tolerance is out of range, std::runtime_error naming the law if `most_cells` do not
  /// suffice. Cost: that of `Table::build` for an eighth of the tolerance, and some 30 lookups a cell.
  static ChordTable build(const Law& law, double tolerance);

  /// The same from a table. Throws std::invalid_argument if the table's own error is more than half of the tolerance.
  ChordTable(const Table& table, double tolerance);

  [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
  /// Upper bound of the absolute error of f and of m: the table's, what was found between the ends of each cell (raised by 2 % for what
  /// lies between the places), and what rounding adds.
  [[nodiscard]] double certified_error() const noexcept { return certified_error_; }
  [[nodiscard]] double moment_ratio() const noexcept { return cells_.back().start[1]; }
  /// A power of two.
  [[nodiscard]] std::size_t cell_count() const noexcept { return cells_.size() - 1; }
  [[nodiscard]] std::size_t bytes() const noexcept { return cells_.size() * sizeof(Cell); }  ///< all that a lookup may touch
  /// From pure sliding (u = 0) on; and one more, which is pure spin.
  [[nodiscard]] std::span<const Cell> cells() const noexcept { return cells_; }

  /// The wrench that the slip twist causes, within certified_error(); exact at both ends. NaN for numbers that are none.
  /// Cost: a division, four other operations and a read.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const double u = twist.spin_fraction();
    const double place = u * count_;
    // What is no number reads the last cell.
    const Cell& here = cells_[static_cast<std::size_t>(static_cast<std::int64_t>(place < count_ ? place : count_))];
    const Pair value = here.start + Pair{u, u} * here.rise;
    return {value[0], value[1]};
  }

 private:
  double tolerance_;
  double certified_error_ = 0.0;
  double count_ = 0.0;
  std::vector<Cell> cells_;
};

}  // namespace limitcurve
