// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table_side.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
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

  /// A table from its sides, as read from a file. Throws std::invalid_argument if they do not meet at the rim, the moment ratio is not
  /// within 1e±30, or a fact is out of range.
  Table(Facts facts, TableSide inside, TableSide outside);

  [[nodiscard]] const std::string& law_name() const noexcept { return facts_.law_name; }
  [[nodiscard]] double tolerance() const noexcept { return facts_.tolerance; }
  /// Upper bound of the absolute error of f and of m, found by comparison with the exact curve between the nodes.
  [[nodiscard]] double certified_error() const noexcept { return facts_.certified_error; }
  [[nodiscard]] const TableSide& inside() const noexcept { return sides_[0]; }
  [[nodiscard]] const TableSide& outside() const noexcept { return sides_[1]; }
  [[nodiscard]] std::size_t node_count() const noexcept { return inside().nodes().size() + outside().nodes().size(); }
  /// Bytes of the nodes: what a file or a constant in a program must hold, and all that defines the table.
  [[nodiscard]] std::size_t bytes() const noexcept { return node_count() * sizeof(TableNode); }
  /// Bytes that a lookup by twist may touch: the nodes' cubics, a cache line each, and their index. Some 2 to 3 times `bytes`.
  [[nodiscard]] std::size_t working_bytes() const noexcept { return inside().working_bytes() + outside().working_bytes(); }

  [[nodiscard]] UnitWrench rim() const noexcept { return rim_; }  ///< at s = 1
  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }

  /// The wrench that the slip twist causes, within certified_error().
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const auto [outside, coordinate] = place(twist);
    return wrench_of(outside, sides_[outside].cell(coordinate).value(coordinate));
  }

  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept {
    const auto [outside, coordinate] = place(twist);
    const TableSide::Cell& cell = sides_[outside].cell(coordinate);
    const UnitWrench slope = wrench_of(outside, cell.slope(coordinate));
    // u = 1/(1+s) = q/(1+q): ds/du = −(1+s)², dq/du = (1+q)².
    const double rate = (outside ? 1.0 : -1.0) * (1.0 + coordinate) * (1.0 + coordinate);
    return {wrench_of(outside, cell.value(coordinate)), {rate * slope.force, rate * slope.moment}};
  }

  /// Where the ray through `direction` (not zero) meets the table's curve, and the twist there: a search within cells from
  /// place_of_ellipse, 1 to 2 steps as a rule, 64 at most.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    // Steeper than the rim's wrench: more twist than slide.
    const bool outside = rim().force * direction.moment < rim().moment * direction.force;
    const double start = place_of_ellipse(SlipTwist{direction.force * moment_ratio() * moment_ratio(), direction.moment}.place());
    const double from = std::clamp(outside ? 2.0 - start : start, 0.0, 1.0);
    // By index: compilers turn a choice between doubles into a branch, which no predictor knows here.
    const double components[2] = {direction.force, direction.moment};
    const auto [primary, secondary, x, cell] = sides_[outside].along(Pair{components[outside], components[!outside]}, from);
    // Where the intercepts are twenty decades apart, rounding may leave the smaller component below 0.
    return {wrench_of(outside, Pair{std::max(primary, 0.0), std::max(secondary, 0.0)}), outside ? SlipTwist{1.0, x} : SlipTwist{x, 1.0}};
  }

  /// About the place (SlipTwist::at_place) of this curve's normal on the ray from the origin where the ellipse with the same
  /// intercepts has its normal at `place` ∈ [0, 2]; good to some 1e-3, and in relative terms at both ends. A start for searches.
  [[nodiscard]] double place_of_ellipse(double place) const noexcept {
    const double scaled = place * (0.5 * place_cells);
    const auto index = static_cast<std::size_t>(static_cast<int>(std::min(scaled, place_cells - 1.0)));
    const double left = places_[index];
    return left + (scaled - static_cast<double>(index)) * (double{places_[index + 1]} - left);
  }

  /// The point of the curve from which the trial (both components > 0) lies along the outward normal in the metric
  /// f² + χm², χ > 0: the closest point, if the trial is outside. `start` is a place to search from (SlipTwist::at_place), or ≤ 0 for
  /// none; `piece` that of the last foot, or any number; `per_chi` is 1/χ. One step from a start nearby, two or three from none as a
  /// rule, each a few multiplications and a division; 64 at most.
  [[gnu::always_inline]] [[nodiscard]] Foot closest(UnitWrench trial, double chi, double per_chi, double start,
                                                    std::uint32_t piece = 0) const noexcept {
    const Foot near = closest_in_one_step(trial, chi, per_chi, start, piece);
    if (near.piece != TableSide::none) [[likely]]
      return near;
    // Number by number, because what is returned in memory would be there in either case.
    const Foot foot = search_closest(trial, chi, per_chi, start);
    return {{foot.wrench.force, foot.wrench.moment}, {foot.normal.slide, foot.normal.spin}, foot.place, foot.piece};
  }

  /// The same if it lies in the piece of this number, which holds `start`, and one step leads from there to it; else its piece is
  /// TableSide::none.
  [[gnu::always_inline]] [[nodiscard]] Foot closest_in_one_step(UnitWrench trial, double chi, double per_chi, double start,
                                                                std::uint32_t piece) const noexcept {
    // Branched for, unlike in a lookup: a finger's slip seldom changes sides. Outside the rim the places begin above 1.
    if (std::bit_cast<std::int64_t>(start) > std::bit_cast<std::int64_t>(1.0)) {
      const auto [primary, secondary, x, cell] =
          sides_[1].closest_in_one_step(Pair{trial.moment, trial.force}, per_chi, 2.0 - start, piece);
      return {{secondary, primary}, {1.0, x}, 2.0 - x, cell};
    }
    const auto [primary, secondary, x, cell] = sides_[0].closest_in_one_step(Pair{trial.force, trial.moment}, chi, start, piece);
    return {{primary, secondary}, {x, 1.0}, x, cell};
  }

  /// `closest` without a piece to begin with, and out of the way of its registers. The result is the same for every piece.
  [[nodiscard, gnu::noinline]] Foot search_closest(UnitWrench trial, double chi, double per_chi, double start) const noexcept {
    const double from = start > 0.0 ? start : guess(trial, per_chi);
    const auto foot = [](bool outside, const TableSide::Point& found) -> Foot {
      const auto [primary, secondary, x, cell] = found;
      if (outside) return {{secondary, primary}, {1.0, x}, 2.0 - x, cell};
      return {{primary, secondary}, {x, 1.0}, x, cell};
    };
    const Pair trials[2] = {{trial.force, trial.moment}, {trial.moment, trial.force}};
    const double kappas[2] = {chi, per_chi};
    const bool begins_outside = from > 1.0;
    const double begin = begins_outside ? 2.0 - from : from;
    // The trial's side of the normal at the rim. A search that begins on the other takes one step there, as with a piece, before it goes over.
    const bool outside = trial.force - rim_.force > chi * (trial.moment - rim_.moment);
    if (outside == begins_outside) return foot(outside, sides_[outside].closest(trials[outside], kappas[outside], std::max(begin, 0.0)));
    if (begin >= 0.0) {
      const TableSide& side = sides_[begins_outside];
      const TableSide::Point found =
          side.closest_in_one_step(trials[begins_outside], kappas[begins_outside], begin, side.number_of(side.cell(begin)));
      if (found.cell != TableSide::none) return foot(begins_outside, found);
    }
    return foot(outside, sides_[outside].closest(trials[outside], kappas[outside], 1.0));
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return wrench.force + wrench.moment > 0.0 ? gauge_from(wrench, along(wrench).wrench) : 0.0;
  }

 private:
  struct Place {
    bool outside;
    double coordinate;
  };
  /// Selected, not branched for: which side a twist lies on is the one thing that no predictor knows.
  static Place place(SlipTwist twist) noexcept {
    const bool outside = twist.slide > twist.spin;
    return {outside, std::min(twist.slide, twist.spin) / std::max(twist.slide, twist.spin)};
  }
  /// Inside the rim the force leads, outside the moment.
  static UnitWrench wrench_of(bool outside, Pair value) noexcept {
    const double components[2] = {value[0], value[1]};
    return {components[outside], components[!outside]};
  }

  /// A first guess at the place of `closest`. The closest point of the ellipse with the same intercepts, by one Newton step for the
  /// multiplier λ of f = x̂/(1+λ), m = ŷ/(1+λη) from λ = 0, taken on 1/√(f² + m²): that is straight in λ where η = 1, and nearly
  /// so elsewhere. Its normal is the curve's where the trial is far; near by, the curve's is that of the foot. In between the
  /// turning of foot and normal share. As fractions of one division: λ is n/d.
  [[nodiscard]] double guess(UnitWrench trial, double per_chi) const noexcept {
    const double x = trial.force;
    const double y = trial.moment * per_moment_ratio_;
    const double eta = per_chi * per_moment_ratio_ * per_moment_ratio_;
    const double square = x * x + y * y;
    const double n = square * std::max(std::sqrt(square) - 1.0, 0.0);
    const double d = x * x + eta * (y * y);
    const double slide = x * (d + eta * n) * moment_ratio_;
    const double spin = y * (d + n);
    const Pair quotients = Pair{std::min(slide, spin), d} / Pair{std::max(slide, spin), d + 0.5 * (1.0 + eta) * n};
    const double place = slide <= spin ? quotients[0] : 2.0 - quotients[0];
    // Where products under- or overflow anything will do.
    if (!(place > 0.0 && place < 2.0)) return 1.0;
    return place + (place_of_ellipse(place) - place) * quotients[1];
  }

  void learn_places();

  static constexpr std::size_t place_cells = 64;

  Facts facts_;
  std::array<TableSide, 2> sides_;  // inside, outside
  UnitWrench rim_;
  double moment_ratio_;
  double per_moment_ratio_;
  std::array<float, place_cells + 1> places_{};  // of this curve, evenly in the ellipse's
};

static_assert(LimitBoundary<Table>);

}  // namespace limitcurve
