// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table_side.hpp"

#include <cstddef>
#include <string>

namespace limitcurve {

/// A limit curve as a lookup table: a limit boundary in a few hundred bytes to a few KiB, with a certified error.
///
/// Cubic Hermite interpolation of f and m with exact slopes, in s = c/a inside the rim and in 1/s outside:
/// continuously differentiable, exact at both ends, monotone and convex (proved for every cubic, not sampled).
/// The nodes are spaced so that every cell has about the same error, which grades them towards the rim, where the
/// derivatives of the curve are singular; a bucket index makes the lookup O(1).
class Table {
 public:
  /// The tolerances that `build` accepts.
  static constexpr double finest_tolerance = 1e-12;
  static constexpr double coarsest_tolerance = 1e-1;

  /// The table of `law` with |error| ≤ tolerance in f and in m at every twist.
  /// Throws std::invalid_argument if the tolerance is out of range, std::runtime_error naming the law if it cannot
  /// be reached in `TableSide::most_nodes`. Cost: some 30 evaluations of the law a node; nodes ∝ tolerance^(−1/4).
  static Table build(const Law& law, double tolerance);

  /// What a table says of itself.
  struct Facts {
    std::string law_name;
    double tolerance = 0.0;
    double certified_error = 0.0;
  };

  /// A table from its sides, as read from a file. Throws std::invalid_argument if they do not meet at the rim or a
  /// fact is out of range.
  Table(Facts facts, TableSide inside, TableSide outside);

  [[nodiscard]] const std::string& law_name() const noexcept { return facts_.law_name; }
  [[nodiscard]] double tolerance() const noexcept { return facts_.tolerance; }
  /// Upper bound of the absolute error of f and of m, found by comparison with the exact curve between the nodes.
  [[nodiscard]] double certified_error() const noexcept { return facts_.certified_error; }
  [[nodiscard]] const TableSide& inside() const noexcept { return inside_; }
  [[nodiscard]] const TableSide& outside() const noexcept { return outside_; }
  [[nodiscard]] std::size_t node_count() const noexcept { return inside_.nodes().size() + outside_.nodes().size(); }
  /// Bytes that lookups may touch: nodes and index.
  [[nodiscard]] std::size_t bytes() const noexcept { return inside_.bytes() + outside_.bytes(); }

  [[nodiscard]] double moment_ratio() const noexcept { return inside_.nodes().front().secondary; }

  /// The wrench that the slip twist causes, within certified_error().
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    // The COR inside the rim: the force leads. Outside: the moment does, in 1/s.
    if (twist.slide <= twist.spin) {
      const TableSide::Value value = inside_.cell(twist.slide / twist.spin).value();
      return {value.primary, value.secondary};
    }
    const TableSide::Value value = outside_.cell(twist.spin / twist.slide).value();
    return {value.secondary, value.primary};
  }

  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept {
    // u = 1/(1+s) = q/(1+q): ds/du = −(1+s)², dq/du = (1+q)².
    if (twist.slide <= twist.spin) {
      const TableSide::Cell cell = inside_.cell(twist.slide / twist.spin);
      const TableSide::Value value = cell.value();
      const TableSide::Value slope = cell.slope();
      const double rate = -(1.0 + cell.coordinate) * (1.0 + cell.coordinate);
      return {{value.primary, value.secondary}, {rate * slope.primary, rate * slope.secondary}};
    }
    const TableSide::Cell cell = outside_.cell(twist.spin / twist.slide);
    const TableSide::Value value = cell.value();
    const TableSide::Value slope = cell.slope();
    const double rate = (1.0 + cell.coordinate) * (1.0 + cell.coordinate);
    return {{value.secondary, value.primary}, {rate * slope.secondary, rate * slope.primary}};
  }

  /// Where the ray through `direction` (not zero) meets the table's curve, and the twist there. Bisection over the
  /// nodes, then bracketed Newton within a cell: at most 15 + 24 steps, 6 + 3 as a rule.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    const TableNode& rim = inside_.nodes().back();
    if (rim.primary * direction.moment >= rim.secondary * direction.force) {
      // Steeper than the rim's wrench: more twist than slide.
      const auto [value, x] = inside_.along({direction.force, direction.moment});
      return {{value.primary, value.secondary}, {x, 1.0}};
    }
    const auto [value, x] = outside_.along({direction.moment, direction.force});
    return {{value.secondary, value.primary}, {1.0, x}};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return wrench.force + wrench.moment > 0.0 ? gauge_from(wrench, along(wrench).wrench) : 0.0;
  }

 private:
  Facts facts_;
  TableSide inside_;
  TableSide outside_;
};

static_assert(LimitBoundary<Table>);

}  // namespace limitcurve
