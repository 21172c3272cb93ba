// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/curve_view.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/table.hpp"

#include <memory>

namespace limitcurve::godobject {

/// The limit curve of a finger or a batch: an ellipse, a box (uncoupled limits) or a table of any other curve. Immutable; copies share the
/// table's cells and are cheap, so it may be made from a temporary.
template <class Real>
class BasicFingerCurve {
 public:
  BasicFingerCurve(const Ellipse& ellipse) : BasicFingerCurve(CurveView<Real>::Kind::ellipse, ellipse) {  // NOLINT: meant to convert
    set_rim(ellipse.wrench({1.0, 1.0}));
  }
  BasicFingerCurve(const Box& box) : BasicFingerCurve(CurveView<Real>::Kind::box, box) {  // NOLINT
    set_rim({box.force_max(), box.moment_max()});
  }
  BasicFingerCurve(const BasicTable<Real>& table) : BasicFingerCurve(CurveView<Real>::Kind::table, table) {  // NOLINT
    view_.table = table.pieces();
    set_rim(table.rim());
    owner_ = std::make_shared<const BasicTable<Real>>(table);
  }

  [[nodiscard]] bool is_box() const noexcept { return view_.kind == CurveView<Real>::Kind::box; }
  [[nodiscard]] const CurveView<Real>& view() const noexcept { return view_; }
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
  template <class Curve>
  BasicFingerCurve(typename CurveView<Real>::Kind kind, const Curve& curve) {
    view_.kind = kind;
    view_.force_max = static_cast<Real>(curve.force_max());
    view_.moment_max = static_cast<Real>(curve.moment_ratio() * curve.force_max());
    view_.inverse_force_max = Real(1) / view_.force_max;
    view_.inverse_moment_max = Real(1) / view_.moment_max;
  }
  void set_rim(UnitWrench rim) noexcept {
    view_.rim_force = static_cast<Real>(rim.force);
    view_.rim_moment = static_cast<Real>(rim.moment);
  }

  CurveView<Real> view_;
  std::shared_ptr<const void> owner_;  // of the cells that the view points to
};

extern template class BasicFingerCurve<double>;
extern template class BasicFingerCurve<float>;

using FingerCurve = BasicFingerCurve<double>;

}  // namespace limitcurve::godobject
