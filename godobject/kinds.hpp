// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace limitcurve::godobject {

/// The limit boundaries that can be chosen at run time.
enum class BoundaryKind { exact, table, ellipse, superellipse, quartic, box };

/// The projections that can be chosen at run time.
enum class ProjectionKind { radial, c_curve, closest_point };

/// "exact", "table", "ellipse", "superellipse", "quartic", "box".
std::string_view to_string(BoundaryKind kind) noexcept;
/// "radial", "c-curve", "closest-point".
std::string_view to_string(ProjectionKind kind) noexcept;

/// The inverse of `to_string`; throws `std::invalid_argument` that names what was expected.
BoundaryKind parse_boundary_kind(std::string_view text);
ProjectionKind parse_projection_kind(std::string_view text);

}  // namespace limitcurve::godobject
