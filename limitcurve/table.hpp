// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/curve_view.hpp"
#include "limitcurve/law.hpp"
#include "limitcurve/limit_curve.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve {

/// What a table says of itself.
struct TableFacts {
  std::string law_name;          ///< or the name of the curve
  double tolerance = 0.0;        ///< that it was built to
  double certified_error = 0.0;  ///< absolute, of f and of m: ≤ tolerance·max(force_max, m_max)
  double profile_error = 0.0;    ///< absolute, beside it: what samples of the pressure leave open (PressureLaw::profile_error)
};

/// A piece of the support function along one side: D(t) = Σ cᵢ (t − x)ⁱ from t = x to the next cell's x, or to 1.
struct TableCell {
  double x;
  std::array<double, 7> coefficients;
};

/// All that defines a table's curve: what a file holds.
struct TableCells {
  int index_bits = 0;              ///< p: there are 2^p buckets an octave (TablePieces), 3 to 11
  int octaves = 0;                 ///< d: the octaves are counted in min(x, 1 − x) + 2^−d
  std::vector<TableCell> inside;   ///< x = c/a, in order, from 0
  std::vector<TableCell> outside;  ///< x = a/c, in order, from 0
};

/// A limit curve as a table of its support function: a limit curve in 1 to 64 KiB, with a certified error.
///
/// Inside the rim D(x) = H(x, 1), x = c/a, outside D(x) = H(1, x), x = a/c, each in pieces of degree 6 that join with their first
/// derivatives and are convex (proved for every piece). Hence a wrench (D′, D − xD′) has its slip twist as the normal of the table's
/// own curve, exactly. Both ends are exact: pure sliding and pure spin.
///
/// Immutable. Copies share the cells.
template <class Real>
class BasicTable {
 public:
  /// The tolerances that `build` accepts.
  static constexpr double finest_tolerance = sizeof(Real) == sizeof(float) ? 5e-7 : 1e-14;
  static constexpr double coarsest_tolerance = 1e-1;
  /// No table has more bytes().
  static constexpr std::size_t most_bytes = 65536;

  /// The table of `law` with |error| ≤ tolerance·max(1, m₀) in f and in m at every twist.
  /// Throws std::invalid_argument if the tolerance is out of range, std::runtime_error naming the law and the finest tolerance that is
  /// possible if this one is not within most_bytes or within the law's own error.
  static BasicTable build(const Law& law, double tolerance);

  /// The table of any curve with `wrench(SlipTwist)` that is right to 1e-15 and whose normal turns without jumps (an ellipse, a
  /// superellipse, a curve of one's own; not a box or a diamond), with |error| ≤ tolerance·max(force_max, m_max). Throws likewise.
  template <class Curve>
  static BasicTable build(const Curve& curve, double tolerance, std::string name) {
    if constexpr (requires { curve.vertices(); }) refuse_corners(name);
    return build_from([&curve](SlipTwist twist) -> UnitWrench { return curve.wrench(twist); }, tolerance, std::move(name));
  }

  /// A table from its cells, as read from a file. Throws std::invalid_argument, which names what is wrong, if a fact or an
  /// edge is out of range, a number is not finite, the pieces do not join or are not convex, an end is not exact, or the table
  /// has more than most_bytes.
  BasicTable(TableFacts facts, const TableCells& cells);

  [[nodiscard]] const std::string& law_name() const noexcept { return data_->facts.law_name; }
  [[nodiscard]] double tolerance() const noexcept { return data_->facts.tolerance; }
  /// Upper bound of the absolute error of f and of m, found by comparison with the exact curve within every cell.
  [[nodiscard]] double certified_error() const noexcept { return data_->facts.certified_error; }
  /// What the law itself may be off by, because its pressure is known at samples only: to be added to the above. 0 for laws given by a formula.
  [[nodiscard]] double profile_error() const noexcept { return data_->facts.profile_error; }
  [[nodiscard]] std::size_t cell_count() const noexcept { return data_->cells.size(); }
  /// Bytes that a look-up may touch: the cells, a cache line each in double, and their index.
  [[nodiscard]] std::size_t bytes() const noexcept;
  /// The cells as numbers, exactly: BasicTable(facts, cells()) makes an equal table.
  [[nodiscard]] TableCells cells() const;

  [[nodiscard]] double force_max() const noexcept { return static_cast<double>(view_.force_max); }  ///< at pure sliding: 1 for a law
  [[nodiscard]] double moment_ratio() const noexcept { return static_cast<double>(view_.moment_max) / force_max(); }  ///< m₀
  [[nodiscard]] UnitWrench rim() const noexcept { return wrench({1.0, 1.0}); }                                        ///< at s = 1

  /// What a loop reads. Valid as long as a copy of the table is.
  [[nodiscard]] const CurveView<Real>& view() const noexcept { return view_; }
  [[nodiscard]] const TablePieces<Real>& pieces() const noexcept { return view_.table; }

  /// The wrench that the slip twist causes, within certified_error().
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const auto [outside, x] = place(twist);
    const Jet<Real> jet = view_.table.jet(outside, x);
    return wrench_of(outside, jet.leading(), jet.trailing(x));
  }

  [[nodiscard]] SlopedPoint point(SlipTwist twist) const noexcept {
    const auto [outside, x] = place(twist);
    const Jet<Real> jet = view_.table.jet(outside, x);
    // u = 1/(1+s) = q/(1+q): ds/du = −(1+s)², dq/du = (1+q)².
    const double rate = (outside ? 1 : -1) * (1 + x) * (1 + x) * jet.second;
    return {wrench_of(outside, jet.leading(), jet.trailing(x)), wrench_of(outside, rate, -double{x} * rate)};
  }

  /// Where the ray through `direction` (not zero) meets the table's curve, and the twist there: 2 to 4 evaluations as a rule, 64 at most.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return wrench.force + wrench.moment > 0.0 ? gauge_from(wrench, along(wrench).wrench) : 0.0;
  }

 private:
  /// A cell as it lies in memory: a cache line in double.
  struct alignas(8 * sizeof(Real)) Cell {
    std::array<Real, TablePieces<Real>::numbers_per_cell> numbers;
  };
  struct Data {
    TableFacts facts;
    std::array<int, 2> buckets;  // p and d
    std::vector<Cell> cells;     // inside, then outside, each in order
    std::vector<std::uint16_t> cell_of_bucket;
    std::size_t cells_inside;
  };
  struct Place {
    bool outside;
    Real x;
  };

  [[noreturn]] static void refuse_corners(const std::string& name);
  static BasicTable build_from(const std::function<UnitWrench(SlipTwist)>& curve, double tolerance, std::string name);

  static Place place(SlipTwist twist) noexcept {
    return {twist.slide > twist.spin, static_cast<Real>((std::min)(twist.slide, twist.spin) / (std::max)(twist.slide, twist.spin))};
  }
  /// Inside the rim the force leads, outside the moment. By index: which side a twist lies on no predictor knows.
  static UnitWrench wrench_of(bool outside, double leading, double trailing) noexcept {
    const double components[2] = {leading, trailing};
    return {components[outside], components[!outside]};
  }

  std::shared_ptr<const Data> data_;
  CurveView<Real> view_;
};

using Table = BasicTable<double>;
/// In single precision, for many contacts at once.
using FloatTable = BasicTable<float>;

extern template class BasicTable<double>;
extern template class BasicTable<float>;

static_assert(LimitCurve<Table>);

}  // namespace limitcurve
