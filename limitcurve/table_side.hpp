// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace limitcurve {

/// A node of one side of a table: 32 bytes. Inside the rim the coordinate is s = c/a, the primary component the force and the
/// secondary the moment; outside the coordinate is 1/s and they change places. The slope is the primary's; the
/// secondary's is −coordinate·slope on either side (dm/df = −s).
struct TableNode {
  double coordinate;
  double primary;
  double secondary;
  double slope;

  friend bool operator==(const TableNode&, const TableNode&) = default;
};

/// Half of a table, from its end (coordinate 0: pure twist inside, pure slide outside) to the rim (coordinate 1): the
/// primary component rises from 0, the secondary falls. Piecewise cubic, with the slopes that the nodes tell.
class TableSide {
 public:
  static constexpr std::size_t most_nodes = 1U << 15U;

  struct Value {
    double primary;
    double secondary;
  };

  /// The two cubics between neighbouring nodes in powers of the distance from the left one: a cache line. The secondary
  /// component's linear coefficient is not held: dm/df = −s makes it −coordinate times the primary's.
  struct alignas(64) Cell {
    double left;  ///< coordinate of the left node
    std::array<double, 4> primary;
    double secondary;
    double secondary_square;
    double secondary_cube;

    Cell(const TableNode& from, const TableNode& to) noexcept;

    [[nodiscard]] Value value(double coordinate) const noexcept {
      const double x = coordinate - left;
      return {primary[0] + x * (primary[1] + x * (primary[2] + x * primary[3])),
              secondary + x * (-left * primary[1] + x * (secondary_square + x * secondary_cube))};
    }

    /// Derivatives by the coordinate.
    [[nodiscard]] Value slope(double coordinate) const noexcept {
      const double x = coordinate - left;
      return {primary[1] + x * (2.0 * primary[2] + x * 3.0 * primary[3]),
              -left * primary[1] + x * (2.0 * secondary_square + x * 3.0 * secondary_cube)};
    }
  };

  /// Takes at least two nodes, with coordinates increasing from 0 to 1. Throws std::invalid_argument naming the first
  /// node that breaks order, monotony, convexity, or the ends.
  explicit TableSide(std::vector<TableNode> nodes);

  [[nodiscard]] std::span<const TableNode> nodes() const noexcept { return nodes_; }
  /// Of the cells and their index, which are derived from the nodes: all that a lookup by twist may touch.
  [[nodiscard]] std::size_t working_bytes() const noexcept {
    return cells_.size() * sizeof(Cell) + first_cell_.size() * sizeof(std::uint16_t);
  }

  /// The cell that holds `coordinate` ∈ [0, 1], by a bucket uniform in √(1−x) (as the nodes nearly are, being graded
  /// to the rim) and a bisection of a length that is fixed for the table: mostly one or two steps, no branch on data.
  [[nodiscard]] const Cell& cell(double coordinate) const noexcept {
    const auto bucket = static_cast<std::size_t>(std::sqrt(1.0 - coordinate) * buckets_);
    std::size_t found = first_cell_[bucket];
    for (std::size_t step = first_step_; step > 0; step >>= 1U) {
      const std::size_t probe = std::min(found + step, cells_.size() - 1);
      found += (probe - found) * static_cast<std::size_t>(cells_[probe].left <= coordinate);
    }
    return cells_[found];
  }

  /// Gives both sides of a table bisections of one length, so that its loop has no branch that a twist decides.
  static void align(TableSide& one, TableSide& other) noexcept {
    one.first_step_ = other.first_step_ = std::max(one.first_step_, other.first_step_);
  }

  /// Where primary : secondary is that of `direction`, and the coordinate there. The direction must lie on this side.
  [[nodiscard]] std::pair<Value, double> along(Value direction) const noexcept;

 private:
  static constexpr int newton_steps = 24;

  void verify() const;
  void build_index();

  std::vector<TableNode> nodes_;
  std::vector<Cell> cells_;
  std::vector<std::uint16_t> first_cell_;  // of each bucket, counted from the rim; one more for coordinate 0 itself
  double buckets_ = 1.0;
  std::size_t first_step_ = 0;
};

/// Whether the curve between two nodes is convex throughout, by the sign of the cross product of its first and second
/// derivatives, which is a quadratic in the place; up to what the rounding of the nodes explains.
bool is_convex(const TableNode& left, const TableNode& right) noexcept;

}  // namespace limitcurve
