// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pair.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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
  /// A search takes so many steps without a bracket, where it can …
  static constexpr int quick_limit = 4;
  /// … and a step is the last if what it leaves is smaller than this share of the coordinate: for a point on a ray, whose gauge
  /// it decides, …
  static constexpr double crossing_share = 1e-15;
  /// … and for a closest point, which it moves along the curve.
  static constexpr double closest_share = 1e-12;

  /// The two cubics, (primary, secondary), between neighbouring nodes in powers of the distance from the left one: a cache line. The secondary
  /// component's linear coefficient is not held: dm/df = −s makes it −coordinate times the primary's.
  struct alignas(64) Cell {
    double left;  ///< coordinate of the left node
    double rise;  ///< linear coefficient of the primary
    Pair constant;
    Pair square;
    Pair cube;

    Cell(const TableNode& from, const TableNode& to) noexcept;
    /// What follows the last cell: no coordinate reaches it.
    static Cell end() noexcept { return Cell(); }

    [[gnu::always_inline]] [[nodiscard]] Pair linear() const noexcept { return Pair{rise, -left * rise}; }

    [[gnu::always_inline]] [[nodiscard]] bool holds(double coordinate) const noexcept {
      return coordinate >= left && coordinate < (this + 1)->left;
    }

    [[gnu::always_inline]] [[nodiscard]] Pair value(double coordinate) const noexcept {
      const double from_left = coordinate - left;
      const Pair x{from_left, from_left};
      return (constant + x * linear()) + (x * x) * (square + x * cube);
    }

    /// Derivatives by the coordinate.
    [[nodiscard]] Pair slope(double coordinate) const noexcept {
      const double from_left = coordinate - left;
      const Pair x{from_left, from_left};
      return linear() + x * ((square + square) + (x * 3.0) * cube);
    }

    /// Value and derivatives up to the third.
    struct Jet {
      Pair value;
      Pair slope;
      Pair bend;
      Pair third;
    };

    [[gnu::always_inline]] [[nodiscard]] Jet jet(double coordinate) const noexcept {
      const double from_left = coordinate - left;
      const Pair x{from_left, from_left};
      const Pair rises = linear();
      const Pair cubed = x * cube;
      const Pair bent = square + cubed;
      const Pair rest = bent + cubed + cubed;  // ½ of the second derivative
      return {(constant + x * rises) + (x * x) * bent, rises + x * (square + rest), rest + rest, 6.0 * cube};
    }

   private:
    Cell() noexcept : left(1.0 + std::numeric_limits<double>::epsilon()), rise(0.0), constant{}, square{}, cube{} {}
  };

  /// Takes at least two nodes, with coordinates increasing from 0 to 1. Throws std::invalid_argument naming the first
  /// node that breaks order, monotony, convexity, or the ends.
  explicit TableSide(std::vector<TableNode> nodes);

  [[nodiscard]] std::span<const TableNode> nodes() const noexcept { return nodes_; }
  /// Of the cells and their index, which are derived from the nodes: all that a lookup by twist may touch.
  [[nodiscard]] std::size_t working_bytes() const noexcept {
    return cells_.size() * sizeof(Cell) + first_cell_.size() * sizeof(std::uint16_t);
  }

  /// The cell that holds `coordinate` ∈ [0, 1]: by a bucket of the leading bits of 1 − x, which grades the buckets to the rim
  /// as the nodes are, and a few comparisons that do not wait for each other, as many for every coordinate of a table.
  [[gnu::always_inline]] [[nodiscard]] const Cell& cell(double coordinate) const noexcept {
    const std::uint16_t first = first_cell_[bucket(coordinate)];
    std::size_t found = first + static_cast<std::size_t>(cells_[first + 1].left <= coordinate);
    for (std::size_t i = 2; i <= probes_; ++i) found += static_cast<std::size_t>(cells_[first + i].left <= coordinate);
    return cells_[found];
  }

  /// Gives both sides of a table one number of probes, so that the loop over them has no branch that a twist decides.
  static void align(TableSide& one, TableSide& other);

  /// A point of this side.
  struct Point {
    Pair value;  ///< primary, secondary
    double coordinate;
  };

  /// Where primary : secondary is that of `direction`; a search from `start`. The direction must lie on this side.
  [[nodiscard]] Point along(Pair direction, double start) const noexcept { return search(Crossing{direction}, start, &cell(start), start); }

  /// The point whose normal (x : 1) leads, in the metric (1, 1/κ) of compliances, to the trial; a search from `start`. The trial
  /// must lie beyond the normal at the rim, on this side of it.
  [[gnu::always_inline]] [[nodiscard]] Point closest(Pair trial, double kappa, double start) const noexcept {
    return root(Normal{trial, kappa}, start);
  }

 private:
  /// Of a function h of the coordinate that is searched for its root: h, −h′, −h″, −h‴.
  struct Residual {
    double value;
    double fall;
    double bend;
    double third;
  };

  /// secondary·d_primary − primary·d_secondary, which falls with the coordinate.
  struct Crossing {
    static constexpr double share = crossing_share;
    Pair direction;

    [[nodiscard]] Residual operator()(const Cell& cell, double x) const noexcept {
      const auto cross = [&](Pair of) { return of[1] * direction[0] - of[0] * direction[1]; };
      const auto [value, slope, bend, third] = cell.jet(x);
      return {cross(value), -cross(slope), -cross(bend), -cross(third)};
    }
  };

  /// What is over of the trial along the normal's tangent: o_p − xκ o_s.
  struct Normal {
    static constexpr double share = closest_share;
    Pair trial;
    double kappa;

    [[gnu::always_inline]] [[nodiscard]] Residual operator()(const Cell& cell, double x) const noexcept {
      const auto [value, slope, bend, third] = cell.jet(x);
      const Pair over = trial - value;
      const double lever = x * kappa;
      return {over[0] - lever * over[1], slope[0] - lever * slope[1] + kappa * over[1], bend[0] - lever * bend[1] - 2.0 * kappa * slope[1],
              third[0] - lever * third[1] - 3.0 * kappa * bend[1]};
    }
  };

  static constexpr int search_limit = 64;

  /// The leading bits of 1 − x, counted from the rim. Not increasing in x, whatever is rounded.
  [[gnu::always_inline]] [[nodiscard]] std::size_t bucket(double coordinate) const noexcept {
    const std::uint64_t key = std::bit_cast<std::uint64_t>(1.0 - coordinate) >> shift_;
    return static_cast<std::size_t>(std::max(key, least_key_) - least_key_);
  }

  /// A step towards the root.
  struct Step {
    double next;
    bool last;  ///< what it leaves is below the share, if it stays in the cell
  };

  /// h + h′δ + ½h″δ² = 0 to third order in δ: Newton's step n and its correction, where that is small. What it leaves is about
  /// the square of the correction by the step, and at most n³h‴/h′ from the third derivative. Where h rises it is no step to its
  /// root, however small.
  [[gnu::always_inline]] static Step step_from(double x, const Residual& at, double least_share) noexcept {
    const double per_fall = 1.0 / at.fall;
    const double newton = at.value * per_fall;
    const double square = newton * newton;
    const double correction = 0.5 * at.bend * per_fall * square;
    const double size = std::fabs(newton);
    const double bound = least_share * x * size;
    return {x + (std::fabs(correction) < 0.5 * size ? newton - correction : newton),
            correction * correction <= bound && std::fabs(at.third * per_fall) * (square * square) <= bound && at.fall > 0.0};
  }

  /// The root of a function that is ≥ 0 at coordinate 0 and ≤ 0 at 1. One step from a start nearby is enough as a rule; the next
  /// ones are out of the way of the registers.
  template <class Function>
  [[gnu::always_inline]] [[nodiscard]] Point root(const Function& function, double start) const noexcept {
    const Cell& here = cell(start);
    const auto [next, last] = step_from(start, function(here, start), Function::share);
    if (last && here.holds(next)) return {here.value(next), next};
    return search_on(function, start, &here, next);
  }

  template <class Function>
  [[nodiscard, gnu::noinline]] Point search_on(Function function, double start, const Cell* here, double x) const noexcept {
    return search(function, start, here, x);
  }

  /// Steps from x without a bracket, which look up a cell only where one leaves it; should a few not do, from the start again within
  /// a bracket.
  template <class Function>
  [[gnu::always_inline]] [[nodiscard]] Point search(const Function& function, double start, const Cell* here, double x) const noexcept {
    for (int i = 0; i < quick_limit; ++i) {
      if (!here->holds(x)) {
        if (!(x >= 0.0 && x <= 1.0)) break;
        here = &cell(x);
      }
      const auto [next, last] = step_from(x, function(*here, x), Function::share);
      if (last && here->holds(next)) return {here->value(next), next};
      x = next;
    }
    return bracketed_search(function, start);
  }

  /// At most search_limit steps.
  template <class Function>
  [[nodiscard, gnu::noinline]] Point bracketed_search(Function function, double x) const noexcept {
    double low = 0.0;
    double high = 1.0;
    const Cell* here = &cell(x);
    for (int i = 0; i < search_limit; ++i) {
      const Residual at = function(*here, x);
      (at.value > 0.0 ? low : high) = x;
      auto [next, last] = step_from(x, at, Function::share);
      last = last && (here->holds(next) || next == (here + 1)->left);
      // Now and then halve the bracket, so that it closes whatever the curve does.
      if (!last && (!(next > low && next < high) || i % 8 == 7)) next = 0.5 * (low + high);
      // A last step counts even where rounding leads it out of the bracket.
      x = std::clamp(next, 0.0, 1.0);
      here = &cell(x);
      if (last || high - low <= std::numeric_limits<double>::epsilon() * x) break;
    }
    return {here->value(x), x};
  }

  void verify() const;
  void build_index();
  [[nodiscard]] std::size_t fullest_bucket() const;

  std::vector<TableNode> nodes_;
  std::vector<Cell> cells_;                // and the end, once more for every probe beyond it
  std::vector<std::uint16_t> first_cell_;  // of each bucket, counted from the rim
  unsigned shift_ = 0;
  std::uint64_t least_key_ = 0;  // of the last cell: nearer to the rim there is no other
  std::size_t probes_ = 1;
};

/// Whether the curve between two nodes is convex throughout, by the sign of the cross product of its first and second
/// derivatives, which is a quadratic in the place, and its primary rises and its secondary falls; up to what the rounding of the nodes
/// explains.
bool is_convex(const TableNode& left, const TableNode& right) noexcept;

}  // namespace limitcurve
