// SPDX-License-Identifier: MIT
#include "godobject/kinds.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve::godobject {

namespace {

template <class Kind, std::size_t count>
using Names = std::array<std::pair<Kind, std::string_view>, count>;

constexpr Names<BoundaryKind, 6> boundaries{{{BoundaryKind::exact, "exact"},
                                             {BoundaryKind::table, "table"},
                                             {BoundaryKind::ellipse, "ellipse"},
                                             {BoundaryKind::superellipse, "superellipse"},
                                             {BoundaryKind::quartic, "quartic"},
                                             {BoundaryKind::box, "box"}}};

constexpr Names<ProjectionKind, 3> projections{
    {{ProjectionKind::radial, "radial"}, {ProjectionKind::c_curve, "c-curve"}, {ProjectionKind::closest_point, "closest-point"}}};

template <class Kind, std::size_t count>
std::string_view name_of(const Names<Kind, count>& names, Kind kind) noexcept {
  for (const auto& [known, name] : names) {
    if (known == kind) return name;
  }
  return "unknown";
}

template <class Kind, std::size_t count>
Kind parse(const Names<Kind, count>& names, std::string_view noun, std::string_view text) {
  std::string expected;
  for (const auto& [kind, name] : names) {
    if (name == text) return kind;
    if (!expected.empty()) expected += '|';
    expected += name;
  }
  throw std::invalid_argument(std::string(noun) + " '" + std::string(text) + "': expected " + expected);
}

}  // namespace

std::string_view to_string(BoundaryKind kind) noexcept {
  return name_of(boundaries, kind);
}
std::string_view to_string(ProjectionKind kind) noexcept {
  return name_of(projections, kind);
}
BoundaryKind parse_boundary_kind(std::string_view text) {
  return parse(boundaries, "boundary", text);
}
ProjectionKind parse_projection_kind(std::string_view text) {
  return parse(projections, "projection", text);
}

}  // namespace limitcurve::godobject
