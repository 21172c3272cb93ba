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

/// The name of a table's law, its tolerance and its errors.
struct TableFacts {
  std::string law_name;        ///< or the name of the curve
  double tolerance = 0.0;      ///< the tolerance given to `build`
  double checked_error = 0.0;  ///< bound of the absolute error of f and of m: ≤ tolerance·max(force_max, m_max)
  double profile_error = 0.0;  ///< absolute error of the law itself, from samples of the pressure (PressureLaw::profile_error); add it
};

/// One cell: the support function along one side, D(t) = Σ cᵢ (t − x)ⁱ, from t = x to the next cell's x, or to 1.
struct TableCell {
  double x;
  std::array<double, 7> coefficients;
};

/// The cells of both sides and the size of their index: all that defines a table's curve.
struct TableCells {
  int index_bits = 0;              ///< p: 2^p buckets in each octave (TablePieces), 3 to 11
  int octaves = 0;                 ///< d: octaves of 1 − x + 2^−d
  std::vector<TableCell> inside;   ///< x = c/a, in order, from 0
  std::vector<TableCell> outside;  ///< x = a/c, in order, from 0

  /// The degree of D: the largest i with a cᵢ ≠ 0, and at least 3.
  [[nodiscard]] int degree() const noexcept;
};

/// How to build a table.
struct TableOptions {
  std::string name = {};  ///< becomes law_name(); if empty, that of the law
  /// The fastest table with at most so many bytes(): D has the lowest degree, 3 to 5, that needs no search of a cell. If none fits, a larger
  /// table of degree 6; or of 3 where 6 meets rounding. A look-up takes about 0.5 ns more for each degree, and 4 ns for each step of a
  /// search, if no table can do without.
  std::size_t preferred_bytes = 4096;
};

/// A table: a limit curve that interpolates the support function of another, with a checked error, in at most max_bytes. Models LimitCurve.
///
/// Inside the rim D(x) = H(x, 1), x = c/a; outside D(x) = H(1, x), x = a/c. D is a polynomial of degree 3 to 6 in each cell. Cells join with
/// their first derivatives, and the builder proves that every cell is convex. Hence the slip twist is exactly the normal of the table's own
/// curve at the wrench (D′, D − xD′). Both ends, pure sliding and pure spin, are exact.
///
/// Immutable; copies share the cells. No allocation, exception or lock after construction.
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

  /// The table of `law` with |error| ≤ tolerance·max(1, m₀) in f and in m at every twist. Cost: milliseconds for a closed form, up to
  /// seconds by quadrature.
  /// Throws std::invalid_argument for a law that `checked` refuses and a tolerance out of range. Throws std::runtime_error if the tolerance needs more than max_bytes
  /// or is finer than the law's own error; the message names the law and the finest possible tolerance.
  static BasicTable build(const Law& law, double tolerance = default_tolerance, TableOptions options = {});

  /// The table of any curve that has `wrench(SlipTwist)` to 1e-15 and no corners or faces: an ellipse, your own curve; not a box or a
  /// diamond. |error| ≤ tolerance·max(force_max, m_max). Throws like the other `build`; std::invalid_argument, with the requirement and the
  /// place, for a function that is no such curve.
  template <class Curve>
  requires requires(const Curve& curve, SlipTwist twist) {
    { curve.wrench(twist) } -> std::convertible_to<UnitWrench>;
  }
  static BasicTable build(const Curve& curve, double tolerance, TableOptions options) {
    if constexpr (requires { curve.vertices(); }) refuse_corners(options.name);
    return build_from([&curve](SlipTwist twist) -> UnitWrench { return curve.wrench(twist); }, tolerance, std::move(options));
  }

  /// A table from its cells, for example from a file. Throws std::invalid_argument, with the cell or fact, if a fact or the x of a cell is
  /// out of range, a number is not finite, cells do not join or are not convex, an end is not exact, or the table has more than max_bytes.
  BasicTable(TableFacts facts, const TableCells& cells);

  // Moving copies, which is cheap: what was moved from stays what it was.
  BasicTable(const BasicTable&) = default;
  BasicTable& operator=(const BasicTable&) = default;

  [[nodiscard]] const std::string& law_name() const noexcept { return data_->facts.law_name; }
  [[nodiscard]] double tolerance() const noexcept { return data_->facts.tolerance; }
  /// Bound of the absolute error of f and of m, from a comparison with the exact curve in every cell.
  [[nodiscard]] double checked_error() const noexcept { return data_->facts.checked_error; }
  /// Absolute error of the law itself if its pressure is known at samples only. Add it to checked_error(). 0 for laws given by a formula.
  [[nodiscard]] double profile_error() const noexcept { return data_->facts.profile_error; }
  [[nodiscard]] std::size_t cell_count() const noexcept { return data_->cells.inside.size() + data_->cells.outside.size(); }
  /// The degree of D.
  [[nodiscard]] int degree() const noexcept { return view_.table.degree; }
  /// Memory that look-ups read [bytes]: the cells and their index.
  [[nodiscard]] std::size_t bytes() const noexcept;
  /// The cells as numbers, exactly: BasicTable(facts, cells()) makes an equal table.
  [[nodiscard]] const TableCells& cells() const noexcept { return data_->cells; }

  [[nodiscard]] double force_max() const noexcept { return static_cast<double>(view_.force_max); }  ///< at pure sliding: 1 for a law
  [[nodiscard]] double moment_ratio() const noexcept { return static_cast<double>(view_.moment_max) / force_max(); }  ///< m₀
  [[nodiscard]] UnitWrench rim() const noexcept { return wrench({1.0, 1.0}); }                                        ///< at s = 1

  /// The table as a control loop reads it: plain data. Valid as long as any copy of the table exists.
  [[nodiscard]] const CurveView<Real>& view() const noexcept { return view_; }
  [[nodiscard]] const TablePieces<Real>& pieces() const noexcept { return view_.table; }

  /// The wrench of a slip twist, to checked_error(). Signs of the twist do not count; a zero twist gives wrench 0. About 4 ns.
  /// Inlined, as `point` and `gauge`: your compiler's flags may change its last bits (docs/interfaces.md).
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    twist = {arithmetic::abs(twist.slide), arithmetic::abs(twist.spin)};
    const double sum = twist.slide + twist.spin;
    if (!(sum > 0.0)) [[unlikely]]
      return {sum, sum};
    const auto [outside, x] = place(twist);
    const auto wrench = view_.table.wrench(outside, x);
    return {wrench[0], wrench[1]};
  }

  /// The wrenches of many slip twists, as far as both arrays go: the library's bits, whatever your flags.
  void wrench(std::span<const SlipTwist> twists, std::span<UnitWrench> wrenches) const noexcept;

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept {
    const auto [outside, x] = place(twist.magnitudes());
    const Jet<Real> jet = view_.table.jet(outside, x);
    // u = 1/(1+s) = q/(1+q): ds/du = −(1+s)², dq/du = (1+q)².
    const double rate = (outside ? 1 : -1) * (1 + x) * (1 + x) * jet.second;
    return {wrench_of(outside, jet.leading, jet.trailing), wrench_of(outside, rate, -double{x} * rate)};
  }

  /// The point where the ray through `direction` ≠ 0 meets the table's curve, and its normal. Usually 2 to 4 evaluations, at most 64.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept { return gauge_along(*this, wrench); }
  /// Likewise the gauges of many wrenches, in less time where the processor has wide packs.
  void gauge(std::span<const UnitWrench> wrenches, std::span<double> gauges) const noexcept;

 private:
  struct alignas(2 * sizeof(Real)) Numbers {
    std::array<Real, 2> pair;
  };
  struct Data {
    TableFacts facts;
    TableCells cells;
    std::vector<Numbers> numbers;  // of the cells, as TablePieces reads them
    std::vector<std::uint16_t> cell_of_bucket;
  };
  struct Place {
    bool outside;
    Real x;
  };

  [[noreturn]] static void refuse_corners(const std::string& name);
  static BasicTable build_from(const std::function<UnitWrench(SlipTwist)>& curve, double tolerance, TableOptions options);

  static Place place(SlipTwist twist) noexcept {
    return {twist.slide > twist.spin, static_cast<Real>((std::min)(twist.slide, twist.spin) / (std::max)(twist.slide, twist.spin))};
  }
  /// Inside the rim the leading component is the force, outside the moment. An index, because a branch would often be mispredicted.
  static UnitWrench wrench_of(bool outside, double leading, double trailing) noexcept {
    const double components[2] = {leading, trailing};
    return {components[outside], components[!outside]};
  }

  std::shared_ptr<const Data> data_;
  CurveView<Real> view_;
};

using Table = BasicTable<double>;
/// A table in single precision, for FloatBatch.
using FloatTable = BasicTable<float>;

extern template class BasicTable<double>;
extern template class BasicTable<float>;

static_assert(LimitCurve<Table>);

}  // namespace limitcurve
