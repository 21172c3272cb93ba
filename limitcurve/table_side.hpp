// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace limitcurve {

/// A node of one side of a table. Inside the rim the coordinate is s = c/a, the primary component the force and the
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

  /// The cubics between two nodes, at a place in between.
  struct Cell {
    const TableNode& left;
    const TableNode& right;
    double coordinate;

    [[nodiscard]] Value value() const noexcept {
      const auto [width, t] = place();
      return {cubic(left.primary, right.primary, width * left.slope, width * right.slope, t),
              cubic(left.secondary, right.secondary, -width * left.coordinate * left.slope, -width * right.coordinate * right.slope, t)};
    }

    /// Derivatives by the coordinate.
    [[nodiscard]] Value slope() const noexcept {
      const auto [width, t] = place();
      return {
          cubic_slope(left.primary, right.primary, width * left.slope, width * right.slope, t) / width,
          cubic_slope(left.secondary, right.secondary, -width * left.coordinate * left.slope, -width * right.coordinate * right.slope, t) /
              width};
    }

   private:
    [[nodiscard]] std::pair<double, double> place() const noexcept {
      const double width = right.coordinate - left.coordinate;
      return {width, (coordinate - left.coordinate) / width};
    }
    static double cubic(double from, double to, double slope_from, double slope_to, double t) noexcept {
      const double rise = to - from;
      return from + t * (slope_from + t * (3.0 * rise - 2.0 * slope_from - slope_to + t * (slope_from + slope_to - 2.0 * rise)));
    }
    static double cubic_slope(double from, double to, double slope_from, double slope_to, double t) noexcept {
      const double rise = to - from;
      return slope_from + t * (2.0 * (3.0 * rise - 2.0 * slope_from - slope_to) + t * 3.0 * (slope_from + slope_to - 2.0 * rise));
    }
  };

  /// Takes at least two nodes, with coordinates increasing from 0 to 1. Throws std::invalid_argument naming the first
  /// node that breaks order, monotony, convexity, or the ends.
  explicit TableSide(std::vector<TableNode> nodes);

  [[nodiscard]] std::span<const TableNode> nodes() const noexcept { return nodes_; }
  [[nodiscard]] std::size_t bytes() const noexcept {
    return nodes_.size() * sizeof(TableNode) + first_cell_.size() * sizeof(std::uint16_t);
  }

  /// The cell that holds `coordinate` ∈ [0, 1], by a bucket uniform in √(1−x) (as the nodes nearly are, being graded
  /// to the rim) and a bisection of a length that is fixed for the table: mostly one or two steps, no branch on data.
  [[nodiscard]] Cell cell(double coordinate) const noexcept {
    const auto bucket = static_cast<std::size_t>(std::sqrt(1.0 - coordinate) * buckets_);
    std::size_t found = first_cell_[bucket];
    for (std::size_t step = first_step_; step > 0; step >>= 1U) {
      const std::size_t probe = std::min(found + step, nodes_.size() - 2);
      found = nodes_[probe].coordinate <= coordinate ? probe : found;
    }
    return {nodes_[found], nodes_[found + 1], coordinate};
  }

  /// Where primary : secondary is that of `direction`, and the coordinate there. The direction must lie on this side.
  [[nodiscard]] std::pair<Value, double> along(Value direction) const noexcept;

 private:
  static constexpr int newton_steps = 24;

  void verify() const;
  void build_index();

  std::vector<TableNode> nodes_;
  std::vector<std::uint16_t> first_cell_;  // of each bucket, counted from the rim; one more for coordinate 0 itself
  double buckets_ = 1.0;
  std::size_t first_step_ = 0;
};

/// Whether the curve of a cell is convex throughout, by the sign of the cross product of its first and second
/// derivatives, which is a quadratic in the place; up to what the rounding of the nodes explains.
bool is_convex(const TableSide::Cell& cell) noexcept;

}  // namespace limitcurve
