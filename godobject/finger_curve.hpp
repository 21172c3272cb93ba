// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/projection.hpp"
#include "limitcurve/curve_view.hpp"
#include "limitcurve/law.hpp"

#include <concepts>
#include <cstddef>
#include <memory>
#include <string_view>

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

/// The limit curve of a finger or a batch: an ellipse, a box (uncoupled limits) or a table of any other curve. Immutable; copies share the
/// table's cells and are cheap, so it may be made from a temporary.
template <class Real>
class BasicFingerCurve {
 public:
  // Meant to convert: a finger takes the curve itself.
  BasicFingerCurve(const Ellipse& ellipse);         // NOLINT
  BasicFingerCurve(const Polygon<3>& box);          // NOLINT
  BasicFingerCurve(const BasicTable<Real>& table);  // NOLINT
  /// A pressure law is no limit curve yet: does not compile, and says what to write.
  template <std::same_as<Law> Other>
  BasicFingerCurve(const Other&) {  // NOLINT
    static_assert(!std::same_as<Other, Law>, "a finger takes a limit curve, not a pressure law: write Table::build(law, 1e-6)");
  }

  [[nodiscard]] const CurveView<Real>& view() const& noexcept { return view_; }
  void view() const&& = delete;  // it would point into a curve that is gone
  [[nodiscard]] bool is_box() const noexcept { return view_.is_box; }
  [[nodiscard]] double force_max() const noexcept { return static_cast<double>(view_.force_max); }
  /// m₀: moment intercept over force intercept.
  [[nodiscard]] double moment_ratio() const noexcept { return static_cast<double>(view_.moment_max) / force_max(); }

  /// The wrench that a slip twist causes.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept;
  /// Where the ray through a wrench ≠ 0 meets the curve, and the normal there.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept;
  /// 0 at the origin, 1 on the curve, more outside.
  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept;

 private:
  CurveView<Real> view_;
  std::shared_ptr<const void> owner_;  // of the cells that the view points to
};

extern template class BasicFingerCurve<double>;
extern template class BasicFingerCurve<float>;

using FingerCurve = BasicFingerCurve<double>;

/// The limit curves of a law that can be chosen by name.
enum class CurveKind {
  exact,         ///< the finest table that the law allows
  table,         ///< a table of a given tolerance
  ellipse,       ///< through the exact intercepts
  superellipse,  ///< likewise, its exponent fitted; as a table
  quartic,       ///< likewise, its parameter fitted; as a table
  box            ///< uncoupled limits; for the closest point only
};

/// "exact", "table", "ellipse", "superellipse", "quartic", "box".
std::string_view to_string(CurveKind kind) noexcept;
/// "radial", "c-curve", "closest-point".
std::string_view to_string(Projection projection) noexcept;

/// The inverse of `to_string`; throws `std::invalid_argument` that names what was expected.
CurveKind parse_curve_kind(std::string_view text);
Projection parse_projection(std::string_view text);

/// A finger's curve, and how far it is from the curve that its kind names: 0 in closed form, else the table's certified error and what samples of
/// the pressure leave open.
struct KindOfCurve {
  FingerCurve curve;
  double error;
};

/// The curve of that kind for a law; `tolerance` counts for `table` only. Allocates, and throws what the builder of the table throws. Cost: that
/// of a table; `exact` takes milliseconds where the law has a closed form, seconds by quadrature.
KindOfCurve make_finger_curve(CurveKind kind, const Law& law, double tolerance);

/// The table of a law to a tolerance or, where the law allows none so fine, to the first of ten, a hundred, … times it that it allows. Throws
/// what the builder throws where it allows none at all.
BasicTable<double> finest_table(const Law& law, double tolerance);

}  // namespace limitcurve::godobject
