// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/curve_view.hpp"
#include "../limitcurve/law.hpp"
#include "projection.hpp"

#include <concepts>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

namespace limitcurve {

class Ellipse;
template <std::size_t count>
class Polygon;
template <class Real>
class BasicTable;
struct UnitWrench;
struct SlipTwist;
struct RadialPoint;

}  // namespace limitcurve

namespace limitcurve::godobject {

/// The limit curve of a finger or a batch: an ellipse, a box (uncoupled limits), or a table of any other curve.
/// Immutable. Copies share the table's cells, so that copies are cheap and a temporary table is safe. Does not throw.
template <class Real>
class BasicFingerCurve {
 public:
  // Implicit conversions, so that a finger's constructor takes the curve itself.
  BasicFingerCurve(const Ellipse& ellipse);         // NOLINT
  BasicFingerCurve(const Polygon<3>& box);          // NOLINT
  BasicFingerCurve(const BasicTable<Real>& table);  // NOLINT
  /// A curve that other code made, for example from cells in memory of that code. The view must stay valid as long as
  /// `owner` lives; copies of the curve share `owner`. `owner` may be null if the memory outlives all copies.
  BasicFingerCurve(const CurveView<Real>& view, std::shared_ptr<const void> owner)
      : view_(view), owner_(std::move(owner)) {}
  // Moves are cheap copies; a moved-from curve stays valid.
  BasicFingerCurve(const BasicFingerCurve&) = default;
  BasicFingerCurve& operator=(const BasicFingerCurve&) = default;
  /// A pressure law is not a limit curve: a compile-time error says what to write.
  template <std::same_as<Law> Other>
  BasicFingerCurve(const Other&) {  // NOLINT
    static_assert(!std::same_as<Other, Law>,
                  "a finger takes a limit curve, not a pressure law: write Table::build(law)");
  }

  [[nodiscard]] const CurveView<Real>& view() const& noexcept { return view_; }
  void view() const&& = delete;  // would dangle
  [[nodiscard]] bool is_box() const noexcept { return view_.is_box; }
  /// Intercepts [1] of the curve: the force of a pure slide, F/(μP), and the moment of a pure twist, M/(μPa).
  [[nodiscard]] double force_max() const noexcept { return static_cast<double>(view_.force_max); }
  [[nodiscard]] double moment_max() const noexcept { return static_cast<double>(view_.moment_max); }
  /// m₀: moment intercept over force intercept.
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max() / force_max(); }

  /// Error of a table against its law [unit wrenches], checked_error + profile_error; 0 for a closed form.
  [[nodiscard]] double error() const noexcept { return error_; }

  /// The wrench of a slip twist. Signs are ignored; a zero twist gives wrench 0.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept;
  /// The point where the ray through a wrench ≠ 0 meets the curve, and the normal there.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;
  /// The gauge of a wrench: 0 at the origin, 1 on the curve, more outside.
  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept;

 private:
  CurveView<Real> view_;
  std::shared_ptr<const void> owner_;  // of the cells that the view points to
  double error_ = 0.0;
};

extern template class BasicFingerCurve<double>;
extern template class BasicFingerCurve<float>;

using FingerCurve = BasicFingerCurve<double>;

/// Kinds of limit curve of a law, by name.
enum class CurveKind {
  exact,    ///< the finest table of the law; 1e-10 for a measured one
  table,    ///< a table of a given tolerance
  ellipse,  ///< the ellipse through the exact intercepts
  box       ///< uncoupled limits; for the closest point only
};

/// "exact", "table", "ellipse", "box": in the order of CurveKind.
std::span<const std::string_view> curve_kind_names() noexcept;
std::string_view to_string(CurveKind kind) noexcept;
std::string_view to_string(Projection projection) noexcept;

/// The inverse of `to_string`, which takes "_" for "-", too; throws `std::invalid_argument` with the names that were
/// expected.
CurveKind parse_curve_kind(std::string_view text);
Projection parse_projection(std::string_view text);

/// The limit curve of a kind for a law; only `table` uses `tolerance`. Allocates; throws like Table::build. Cost: one
/// table. `exact` takes milliseconds if the law has a closed form, seconds by quadrature.
FingerCurve make_finger_curve(CurveKind kind, const Law& law, double tolerance);

}  // namespace limitcurve::godobject
