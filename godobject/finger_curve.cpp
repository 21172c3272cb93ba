// SPDX-License-Identifier: MIT
#include "godobject/finger_curve.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/internal/names.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace limitcurve::godobject {

template <class Real>
BasicFingerCurve<Real>::BasicFingerCurve(const Ellipse& ellipse) {
  const auto [force, moment] = ellipse.wrench({1.0, 1.0});
  view_.set_scale(Real(ellipse.force_max()), Real(ellipse.moment_max()), Real(force), Real(moment));
}

template <class Real>
BasicFingerCurve<Real>::BasicFingerCurve(const Polygon<3>& box) {
  view_.is_box = true;
  view_.set_scale(Real(box.force_max()), Real(box.moment_max()), Real(box.force_max()), Real(box.moment_max()));
}

template <class Real>
BasicFingerCurve<Real>::BasicFingerCurve(const BasicTable<Real>& table)
    : view_(table.view()),
      owner_(std::make_shared<const BasicTable<Real>>(table)),
      error_(table.checked_error() + table.profile_error()) {}

template <class Real>
UnitWrench BasicFingerCurve<Real>::wrench(SlipTwist twist) const noexcept {
  if (twist.is_zero()) return {};
  const auto [slide, spin] = twist.direction();
  if (is_box()) {
    if (std::isnan(slide)) return {slide, slide};
    return {slide > 0.0 ? static_cast<double>(view_.force_max) : 0.0,
            spin > 0.0 ? static_cast<double>(view_.moment_max) : 0.0};
  }
  const bool outside = slide > spin;
  const auto x = static_cast<Real>(outside ? spin : slide);
  const auto [force, moment] = view_.jet(outside, x).wrench(outside);
  return {static_cast<double>(force), static_cast<double>(moment)};
}

template <class Real>
RadialPoint BasicFingerCurve<Real>::along(UnitWrench direction) const noexcept {
  if (!is_box()) return limitcurve::along(view_, direction);
  const auto [force, moment] = direction.magnitudes();
  const double factor = gauge(direction);
  const bool is_force = force * moment_max() >= moment * force_max();
  return {{force / factor, moment / factor}, {is_force ? 1.0 : 0.0, is_force ? 0.0 : 1.0}};
}

template <class Real>
double BasicFingerCurve<Real>::gauge(UnitWrench wrench) const noexcept {
  return limitcurve::gauge(view_, wrench);
}

template class BasicFingerCurve<double>;
template class BasicFingerCurve<float>;

std::span<const std::string_view> curve_kind_names() noexcept {
  static constexpr std::array<std::string_view, 4> names{"exact", "table", "ellipse", "box"};
  return names;
}
std::string_view to_string(CurveKind kind) noexcept {
  return curve_kind_names()[static_cast<std::size_t>(kind)];
}
std::string_view to_string(Projection projection) noexcept {
  return projection_names[static_cast<std::size_t>(projection)];
}
CurveKind parse_curve_kind(std::string_view text) {
  return parse_name<CurveKind>(curve_kind_names(), "curve", text);
}
Projection parse_projection(std::string_view text) {
  return parse_name<Projection>(projection_names, "projection", text);
}

FingerCurve make_finger_curve(CurveKind kind, const Law& law, double tolerance) {
  switch (kind) {
    case CurveKind::exact:
      // A measured profile is known to a millionth at best: its finest table would take minutes.
      return finest_table(law, law->profile_error() > 0.0 ? 1e-10 : Table::finest_tolerance);
    case CurveKind::table:
      return Table::build(law, tolerance);
    case CurveKind::ellipse:
      return Ellipse::through_intercepts(law->moment_ratio());
    case CurveKind::box:
      return box(1.0, law->moment_ratio());
  }
  throw std::invalid_argument("curve: no CurveKind");
}

}  // namespace limitcurve::godobject
