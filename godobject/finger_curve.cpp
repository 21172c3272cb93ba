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
  direction = direction.magnitudes();
  const double size = std::max(direction.force, direction.moment);
  const auto force = static_cast<Real>(direction.force / size);
  const auto moment = static_cast<Real>(direction.moment / size);
  if (is_box()) {
    const double factor = gauge(direction);
    const bool is_force = force * view_.moment_max >= moment * view_.force_max;
    return {{direction.force / factor, direction.moment / factor}, {is_force ? 1.0 : 0.0, is_force ? 0.0 : 1.0}};
  }
  Real factor{};
  const CurvePoint<Real> point = point_on_ray(view_, force, moment, Real(0), factor);
  return {{static_cast<double>(point.force), static_cast<double>(point.moment)},
          {static_cast<double>(point.slide), static_cast<double>(point.spin)}};
}

template <class Real>
double BasicFingerCurve<Real>::gauge(UnitWrench wrench) const noexcept {
  const auto [force, moment] = wrench.magnitudes();
  // In units of the larger component, for float has fewer decades than double.
  const double size = std::max(force, moment);
  if (!(force + moment > 0.0 && size <= std::numeric_limits<double>::max())) return force + moment;
  return size * static_cast<double>(limitcurve::gauge(view_, static_cast<Real>(force / size),
                                                      static_cast<Real>(moment / size), Real(0)));
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
