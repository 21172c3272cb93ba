// SPDX-License-Identifier: MIT
#pragma once

#include "curve_view.hpp"
#include "law.hpp"
#include "limit_curve.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve {

/// Metadata of a table: its law, tolerance and error bounds.
struct TableFacts {
  std::string law_name;        ///< or the name of the curve
  double tolerance = 0.0;      ///< the tolerance given to `build`
  double checked_error = 0.0;  ///< bound on the absolute error of f and of m: ≤ tolerance·max(force_max, m_max)
  double profile_error = 0.0;  ///< absolute error because the pressure is known only at samples
                               ///< (PressureLaw::profile_error); add it to checked_error
};

/// One cell of a table: the polynomial D(t) = Σ cᵢ (t − x)ⁱ for the support function on one side of the rim, valid from
/// t = x to the x of the next cell, or to 1 in the last cell.
struct TableCell {
  double x;
  std::array<double, 7> coefficients;
};

/// Everything that defines a table's curve: the cells on both sides of the rim, and their index size.
struct TableCells {
  int index_bits = 0;              ///< p: 2^p buckets in each octave (TableView), 3 to 11
  int octaves = 0;                 ///< d: octaves of 1 − x + 2^−d
  std::vector<TableCell> inside;   ///< x = c/a, in order, from 0
  std::vector<TableCell> outside;  ///< x = a/c, in order, from 0

  /// The degree of D: the largest i with a cᵢ ≠ 0, and at least 3.
  [[nodiscard]] int degree() const noexcept;
};

/// How to build a table.
struct TableOptions {
  std::string name = {};  ///< becomes law_name(); if empty, that of the law
  /// The size to aim for; it is not a limit. A lower degree makes a table faster but larger. The builder takes the
  /// lowest degree from 3 to 5 whose table fits into this many bytes() and finds its cell without a search. If no such
  /// table exists, it takes degree 6 at whatever size, or degree 3 if rounding rules out 6. A look-up costs about 0.5
  /// ns more per degree, plus 4 ns per search step if it has to search.
  std::size_t preferred_bytes = 4096;
};

/// Internal: of whatever a view describes; the box has no `along`.
template <class Real>
[[nodiscard]] RadialPoint along(const CurveView<Real>& curve, UnitWrench direction) noexcept;
template <class Real>
[[nodiscard]] double gauge(const CurveView<Real>& curve, UnitWrench wrench) noexcept;

/// A lookup table for real-time loops: a limit curve to a chosen tolerance, at a few nanoseconds per wrench and at most
/// 96 KiB. `build` it before the loop; `wrench`, `along` and `gauge` do not allocate, throw or lock. Immutable; copies
/// share the cells. Models LimitCurve.
///
/// A table that interpolated f and m separately would let a finger settle at several wrenches in one steady twist
/// (docs/stability.md). This table therefore stores one convex function in cells of degree 3 to 6: inside the rim D(x)
/// = H(x, 1) with x = c/a, outside it D(x) = H(1, x) with x = a/c. The slope is continuous from cell to cell, and the
/// builder proves that each cell is convex. As a result, the slip twist is exactly the normal of the tabulated curve at
/// the wrench (D′, D − xD′). Pure sliding and pure spin are exact.
template <class Real>
class BasicTable {
 public:
  /// The range of the tolerance.
  static constexpr double finest_tolerance = sizeof(Real) == sizeof(float) ? 5e-7 : 1e-14;
  static constexpr double coarsest_tolerance = 1e-1;
  /// The default: in double a look-up of a finer table costs almost no more; in float rounding is nearly as large.
  static constexpr double default_tolerance = sizeof(Real) == sizeof(float) ? 1e-6 : 1e-8;
  /// The largest bytes() of a table.
  static constexpr std::size_t max_bytes = 98304;

  /// Builds the table of `law`. At every twist the error in f and in m is at most tolerance·max(1, m₀). Takes
  /// milliseconds if the law has a closed form, and up to seconds if it needs quadrature. Throws std::invalid_argument
  /// if `checked` rejects the law or the tolerance is out of range. Throws std::runtime_error, naming the law, if the
  /// table would exceed max_bytes or the tolerance is finer than the law's own error.
  static BasicTable build(const Law& law, double tolerance = default_tolerance, TableOptions options = {});

  /// Builds the table of any smooth curve, such as an ellipse or your own, whose `wrench(SlipTwist)` is accurate to
  /// 1e-15. Boxes and diamonds have corners and faces, and are rejected. |error| ≤ tolerance·max(force_max, m_max).
  /// Throws like the other `build`, and std::invalid_argument with the violated requirement and its location.
  template <class Curve>
  requires requires(const Curve& curve, SlipTwist twist) {
    { curve.wrench(twist) } -> std::convertible_to<UnitWrench>;
  }
  static BasicTable build(const Curve& curve, double tolerance, TableOptions options) {
    if constexpr (requires { curve.vertices(); }) refuse_corners(options.name);
    return build_from([&curve](SlipTwist twist) -> UnitWrench { return curve.wrench(twist); }, tolerance,
                      std::move(options));
  }

  /// Rebuilds a table from its cells, such as those in a file. Throws std::invalid_argument, naming the cell or fact,
  /// if a fact or a cell's x is out of range, a number is not finite, cells do not join or are not convex, an end is
  /// not exact, or max_bytes is exceeded.
  BasicTable(TableFacts facts, const TableCells& cells);

  // Moves are cheap copies; a moved-from table stays valid.
  BasicTable(const BasicTable&) = default;
  BasicTable& operator=(const BasicTable&) = default;

  [[nodiscard]] const std::string& law_name() const noexcept { return data_->facts.law_name; }
  [[nodiscard]] double tolerance() const noexcept { return data_->facts.tolerance; }
  /// Bound on the absolute error of f and of m, measured against the exact curve in every cell, plus a margin.
  [[nodiscard]] double checked_error() const noexcept { return data_->facts.checked_error; }
  /// Absolute error of the law itself if its pressure is sampled: add it to checked_error(). 0 for laws given by a
  /// formula.
  [[nodiscard]] double profile_error() const noexcept { return data_->facts.profile_error; }
  [[nodiscard]] std::size_t cell_count() const noexcept {
    return data_->cells.inside.size() + data_->cells.outside.size();
  }
  /// The degree of D.
  [[nodiscard]] int degree() const noexcept { return view_.table.degree; }
  /// Memory that look-ups read [bytes]: cells and index.
  [[nodiscard]] std::size_t bytes() const noexcept;
  /// The cells, exactly: BasicTable(facts, cells()) is an equal table.
  [[nodiscard]] const TableCells& cells() const noexcept { return data_->cells; }

  [[nodiscard]] double force_max() const noexcept {
    return static_cast<double>(view_.force_max);
  }  ///< at pure sliding: 1 for a law
  [[nodiscard]] double moment_ratio() const noexcept {
    return static_cast<double>(view_.moment_max) / force_max();
  }                                                                             ///< m₀
  [[nodiscard]] UnitWrench rim() const noexcept { return wrench({1.0, 1.0}); }  ///< at s = 1

  /// Plain data for control loops. Valid while any copy of the table exists.
  [[nodiscard]] const CurveView<Real>& view() const noexcept { return view_; }

  /// The wrench of a slip twist, accurate to checked_error(). Ignores signs; returns 0 for a zero twist. Like `point`,
  /// this is inline, so your compiler flags may change its last bits (docs/interfaces.md).
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    twist = {arithmetic::abs(twist.slide), arithmetic::abs(twist.spin)};
    const double sum = twist.slide + twist.spin;
    if (!(sum > 0.0)) [[unlikely]]
      return {sum, sum};
    const auto [outside, x] = place(twist);
    const auto wrench = view_.table.wrench(outside, x);
    return {wrench[0], wrench[1]};
  }

  /// The wrenches of many slip twists, as many as the shorter span holds. Compiled into the library, so your compiler
  /// flags do not change the bits.
  void wrench(std::span<const SlipTwist> twists, std::span<UnitWrench> wrenches) const noexcept;

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept {
    const auto [outside, x] = place(twist.magnitudes());
    const Jet<Real> jet = view_.table.jet(outside, x);
    // u = 1/(1+s) = q/(1+q): ds/du = −(1+s)², dq/du = (1+q)².
    const double rate = (outside ? 1 : -1) * (1 + x) * (1 + x) * jet.second;
    const auto [force, moment] = jet.wrench(outside);
    const auto [force_rate, moment_rate] = Jet<double>{rate, -double{x} * rate, 0.0, 0.0}.wrench(outside);
    return {{force, moment}, {force_rate, moment_rate}};
  }

  /// Where the ray through `direction` ≠ 0 meets the table's curve, and the normal there, to rounding. Costs about 12
  /// look-ups, as `gauge`; next to a singularity more, at most 64 evaluations.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept { return limitcurve::along(view_, direction); }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept { return limitcurve::gauge(view_, wrench); }
  /// The gauges of many wrenches, faster where the processor has SIMD.
  void gauge(std::span<const UnitWrench> wrenches, std::span<double> gauges) const noexcept;

 private:
  struct alignas(2 * sizeof(Real)) Numbers {
    std::array<Real, 2> pair;
  };
  struct Data {
    TableFacts facts;
    TableCells cells;
    std::vector<Numbers> numbers;  // of the cells, as TableView reads them
    std::vector<std::uint16_t> cell_of_bucket;
    std::vector<Real> ray_starts;
  };
  struct Place {
    bool outside;
    Real x;
  };

  [[noreturn]] static void refuse_corners(const std::string& name);
  static BasicTable build_from(const std::function<UnitWrench(SlipTwist)>& curve, double tolerance,
                               TableOptions options);

  static Place place(SlipTwist twist) noexcept {
    return {twist.slide > twist.spin,
            static_cast<Real>((std::min)(twist.slide, twist.spin) / (std::max)(twist.slide, twist.spin))};
  }

  std::shared_ptr<const Data> data_;
  CurveView<Real> view_;
};

using Table = BasicTable<double>;
/// A table in single precision, for FloatBatch.
using FloatTable = BasicTable<float>;

/// The table of a law at a tolerance; if the law does not allow it, at 10, 100, … times that. Throws like Table::build
/// if there is none.
[[nodiscard]] Table finest_table(const Law& law, double tolerance);

extern template class BasicTable<double>;
extern template class BasicTable<float>;

static_assert(LimitCurve<Table>);

}  // namespace limitcurve
