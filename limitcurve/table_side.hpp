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

/// Whether a number is not below `low` ≥ 0, and below `high`. By the bits, which have the order of the numbers as far as those are ≥ 0: the
/// units that compare numbers have enough to do in a step.
[[gnu::always_inline]] inline bool is_between(double number, double low, double high) noexcept {
  const auto bits = [](double of) { return std::bit_cast<std::uint64_t>(of); };
  return bits(number) - bits(low) < bits(high) - bits(low);
}

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
  /// What falls less or more steeply is searched for within a bracket: squares vanish or overflow, …
  static constexpr double least_steep = 1e-150;
  static constexpr double steepest = 1e150;
  /// … and for a long step cubes.
  static constexpr double long_least_steep = 1e-70;
  static constexpr double long_steepest = 1e70;

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
      return is_between(coordinate, left, (this + 1)->left);
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

    /// Taylor's coefficients at a coordinate: the cubics in powers of the distance from there.
    struct Jet {
      Pair value;
      Pair slope;
      Pair square;
      Pair cube;

      [[gnu::always_inline]] [[nodiscard]] Pair after(double shift) const noexcept {
        const Pair x{shift, shift};
        return (value + x * slope) + (x * x) * (square + x * cube);
      }
    };

    [[gnu::always_inline]] [[nodiscard]] Jet jet(double coordinate) const noexcept {
      const double from_left = coordinate - left;
      const Pair x{from_left, from_left};
      const Pair rises = linear();
      const Pair cubed = x * cube;
      const Pair bent = square + cubed;
      const Pair rest = bent + (cubed + cubed);
      return {(constant + x * rises) + (x * x) * bent, rises + x * (square + rest), rest, cube};
    }

    /// The same but for rounding, sooner, and by more operations: twice and three times a coefficient need not wait for the coordinate.
    [[gnu::always_inline]] [[nodiscard]] Jet quick_jet(double coordinate) const noexcept {
      const double from_left = coordinate - left;
      const Pair x{from_left, from_left};
      const Pair rises = linear();
      const Pair bent = x * (paired.three * cube);
      return {(constant + x * rises) + (x * x) * (square + x * cube), rises + x * ((square + square) + bent), square + bent, cube};
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
    double primary;
    double secondary;
    double coordinate;
    std::uint32_t cell;  ///< number of the cell that holds it
  };

  /// Where primary : secondary is that of `direction`; a search from `start`. The direction must lie on this side.
  [[nodiscard]] Point along(Pair direction, double start) const noexcept { return search(Crossing{direction}, start); }

  /// The point whose normal (x : 1) leads, in the metric (1, 1/κ) of compliances, to the trial; a search from `start`. The trial must
  /// lie beyond the normal at the rim, on this side of it.
  [[nodiscard]] Point closest(Pair trial, double kappa, double start) const noexcept { return search(Normal{trial, kappa}, start); }

  /// The cell of a point that was not found.
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  /// The same point if it lies in the cell of this number, that cell holds `start`, and one step leads from there to it; otherwise none.
  /// For trials on either side: only one point of a curve has a normal that leads to a trial outside.
  [[gnu::always_inline]] [[nodiscard]] Point closest_in_one_step(Pair trial, double kappa, double start,
                                                                 std::uint32_t number) const noexcept {
    const std::uint32_t at = near(number < cell_count_ ? number : 0, start);
    if (at == none) [[unlikely]]
      return {start, start, start, none};
    const Cell& here = cells_[at];
    const Cell::Jet jet = here.jet(start);
    const auto [shift, last] = step_from(start, Normal{trial, kappa}(jet, start), Normal::share);
    const double next = start + shift;
    const Pair value = jet.after(shift);
    return {value[0], value[1], next, last && here.holds(next) ? at : none};
  }

  /// What a long step within a cell leaves at most, in one metric, where the residual falls by f: (square + f²·rest)/f³ times the fourth power of
  /// the step, in units of closest_share.
  struct alignas(32) Trust {
    double least_fall;  ///< where it falls less nothing is known
    double square;
    double rest;

    /// Whether a step from a coordinate leaves less than its share of that.
    [[gnu::always_inline]] [[nodiscard]] bool covers(double shift, double from, double fall, double fall_square) const noexcept {
      if (std::bit_cast<std::int64_t>(fall) < std::bit_cast<std::int64_t>(least_fall)) return false;
      const double shift_square = shift * shift;
      return (shift_square * shift_square) * (square + fall_square * rest) <= from * (fall * fall_square);
    }
  };

  /// Of every cell. Cost: some 50 operations a cell.
  [[nodiscard]] std::vector<Trust> trusts(double kappa) const;

  /// The same with a step of the fourth order, from whatever cell holds `start`, which is found sooner if it is that of the number `foreseen`, one
  /// of this side's, or a neighbour; none either where `start` is not in [0, 1). For starts that are not so near. `trusts` are of the same metric.
  [[gnu::always_inline]] [[nodiscard]] Point closest_in_one_long_step(Pair trial, double kappa, double start, std::uint32_t foreseen,
                                                                      std::span<const Trust> trusts) const noexcept {
    std::uint32_t number = near(foreseen, start);
    if (number == none) [[unlikely]] {
      if (!is_between(start, 0.0, 1.0)) return {start, start, start, none};
      number = number_of(cell(start));
    }
    const Cell& here = cells_[number];
    const Cell::Jet jet = anew(here).quick_jet(start);
    const auto [value_and_fall, square, cube] = Normal{trial, kappa}(jet, start);
    const double value = value_and_fall[0];
    const double fall = value_and_fall[1];
    // δ = h(f² + hs)/(f³ + 2fhs + h²c) leaves δ⁴(2fsc − s³ − f²q)/f³, where q, the fourth coefficient, is κ times a cube's.
    const double fall_square = fall * fall;
    const double bent = value * square;
    const double shift = value * (fall_square + bent) / (fall * (fall_square + (bent + bent)) + (value * value) * cube);
    const double next = start + shift;
    const Pair found = jet.after(shift);
    if (!trusts[number].covers(shift, start, fall, fall_square) || !anew(here).holds(next)) [[unlikely]]
      return {start, start, start, none};
    if (number >= most_nodes) __builtin_unreachable();
    return {found[0], found[1], next, number};
  }

  [[nodiscard]] std::uint32_t number_of(const Cell& cell) const noexcept { return static_cast<std::uint32_t>(&cell - cells_.data()); }

 private:
  /// Of a function that is searched for its root, at a distance δ from where it is: h − fδ − sδ² − cδ³ and so on.
  struct Residual {
    Pair value_and_fall;  ///< h, f
    double square;
    double cube;
  };

  /// secondary·d_primary − primary·d_secondary, which falls with the coordinate.
  struct Crossing {
    static constexpr double share = crossing_share;
    /// A step on from the jet would be a rounding more, and a gauge is told by the smaller component too.
    static constexpr bool is_told_by_jet = false;
    Pair direction;

    [[nodiscard]] Residual operator()(const Cell::Jet& jet, double) const noexcept {
      const auto cross = [&](Pair of) { return of[1] * direction[0] - of[0] * direction[1]; };
      return {Pair{cross(jet.value), -cross(jet.slope)}, -cross(jet.square), -cross(jet.cube)};
    }
  };

  /// What is over of the trial along the normal's tangent: o_p − xκ o_s.
  struct Normal {
    static constexpr double share = closest_share;
    static constexpr bool is_told_by_jet = true;
    Pair trial;
    double kappa;

    [[gnu::always_inline]] [[nodiscard]] Residual operator()(const Cell::Jet& jet, double x) const noexcept {
      const Pair over = trial - jet.value;
      const double lever = x * kappa;
      return {Pair{over[0], jet.slope[0] - lever * jet.slope[1]} + Pair{-lever, kappa} * over[1],
              (jet.square[0] - lever * jet.square[1]) - kappa * jet.slope[1], (jet.cube[0] - lever * jet.cube[1]) - kappa * jet.square[1]};
    }
  };

  static constexpr int search_limit = 64;

  /// The leading bits of 1 − x, counted from the rim. Not increasing in x, whatever is rounded.
  [[gnu::always_inline]] [[nodiscard]] std::size_t bucket(double coordinate) const noexcept {
    const std::uint64_t key = std::bit_cast<std::uint64_t>(1.0 - coordinate) >> shift_;
    return static_cast<std::size_t>(std::max(key, least_key_) - least_key_);
  }

  /// The number of the cell that holds `coordinate` if it is the one of this number, or a neighbour; otherwise none.
  [[gnu::always_inline]] [[nodiscard]] std::uint32_t near(std::uint32_t number, double coordinate) const noexcept {
    if (cells_[number].holds(coordinate)) [[likely]]
      return number;
    const std::uint32_t next = coordinate < cells_[number].left ? number - 1 : number + 1;
    return next < cell_count_ && cells_[next].holds(coordinate) ? next : none;
  }

  /// A step towards the root.
  struct Step {
    double shift;
    bool last;  ///< what it leaves is below the share, if it stays in the cell
  };

  /// Halley's, of the third order: δ = hf/(f² + hs). What it leaves is δ³(s² − fc)/f². Where h rises it is no step to its root,
  /// however small, nor where squares vanish or overflow.
  [[gnu::always_inline]] static Step step_from(double x, const Residual& at, double least_share) noexcept {
    const double fall = at.value_and_fall[1];
    const Pair products = at.value_and_fall * fall;
    const double shift = products[0] / (products[1] + at.value_and_fall[0] * at.square);
    const double curved = at.square * at.square + fall * std::fabs(at.cube);
    const double left = (shift * shift) * std::fabs(shift) * curved;
    return {shift, is_between(fall, least_steep, steepest) && left <= (least_share * x) * products[1]};
  }

  [[gnu::always_inline]] [[nodiscard]] Point point(Pair value, double coordinate, const Cell& cell) const noexcept {
    return {value[0], value[1], coordinate, number_of(cell)};
  }

  /// The root of a function that is ≥ 0 at coordinate 0 and ≤ 0 at 1: steps without a bracket, which look up a cell only where one leaves
  /// it; should a few not do, from the start again within a bracket.
  template <class Function>
  [[gnu::always_inline]] [[nodiscard]] Point search(const Function& function, double start) const noexcept {
    const Cell* here = &cell(start);
    double x = start;
    for (int i = 0; i < quick_limit; ++i) {
      if (!here->holds(x)) {
        if (!(x >= 0.0 && x <= 1.0)) break;
        here = &cell(x);
      }
      const Cell::Jet jet = here->jet(x);
      const auto [shift, last] = step_from(x, function(jet, x), Function::share);
      x += shift;
      if (last && here->holds(x)) return point(Function::is_told_by_jet ? jet.after(shift) : here->value(x), x, *here);
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
      const Residual at = function(here->jet(x), x);
      (at.value_and_fall[0] > 0.0 ? low : high) = x;
      auto [shift, last] = step_from(x, at, Function::share);
      double next = x + shift;
      last = last && (here->holds(next) || next == (here + 1)->left);
      // Now and then halve the bracket, so that it closes whatever the curve does.
      if (!last && (!(next > low && next < high) || i % 8 == 7)) next = 0.5 * (low + high);
      // A last step counts even where rounding leads it out of the bracket.
      x = std::clamp(next, 0.0, 1.0);
      here = &cell(x);
      if (last || high - low <= std::numeric_limits<double>::epsilon() * x) break;
    }
    return point(here->value(x), x, *here);
  }

  void verify() const;
  void build_index();
  [[nodiscard]] std::size_t fullest_bucket() const;

  std::vector<TableNode> nodes_;
  std::vector<Cell> cells_;                // and the end, once more for every probe beyond it
  std::uint32_t cell_count_ = 0;           // without the end
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
