// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/c_curve_projection.hpp"
#include "godobject/closest_point_projection.hpp"
#include "godobject/kinds.hpp"
#include "godobject/radial_projection.hpp"
#include "limitcurve/boundary_error.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/quartic.hpp"
#include "limitcurve/superellipse.hpp"
#include "limitcurve/table.hpp"

#include <utility>

namespace limitcurve::godobject {

/// Calls `visitor` with the boundary of that kind for the law: the table of the tolerance; ellipse and box through the
/// exact intercepts; superellipse and quartic through them too, with the parameter that makes their largest error least.
/// Offline: building a boundary allocates and may throw what its factory throws.
template <class Visitor>
decltype(auto) visit_boundary(BoundaryKind kind, const Law& law, double tolerance, Visitor&& visitor) {
  switch (kind) {
    case BoundaryKind::exact:
      return std::forward<Visitor>(visitor)(ExactCurve(law));
    case BoundaryKind::table:
      return std::forward<Visitor>(visitor)(Table::build(law, tolerance));
    case BoundaryKind::superellipse:
      return std::forward<Visitor>(visitor)(minimax_superellipse(ExactCurve(law)));
    case BoundaryKind::quartic:
      return std::forward<Visitor>(visitor)(minimax_quartic(ExactCurve(law)));
    case BoundaryKind::box:
      return std::forward<Visitor>(visitor)(box(1.0, law->moment_ratio()));
    case BoundaryKind::ellipse:
      break;
  }
  return std::forward<Visitor>(visitor)(Ellipse::through_intercepts(law->moment_ratio()));
}

/// Calls `visitor` with the projection of that kind.
template <class Visitor>
decltype(auto) visit_projection(ProjectionKind kind, Visitor&& visitor) {
  switch (kind) {
    case ProjectionKind::radial:
      return std::forward<Visitor>(visitor)(Radial{});
    case ProjectionKind::c_curve:
      return std::forward<Visitor>(visitor)(CCurve{});
    case ProjectionKind::closest_point:
      break;
  }
  return std::forward<Visitor>(visitor)(ClosestPoint{});
}

}  // namespace limitcurve::godobject
