// SPDX-License-Identifier: MIT
#include "godobject/curve_kind.hpp"

#include "limitcurve/boundary_error.hpp"
#include "limitcurve/ellipse.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/polygon.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve::godobject {

namespace {

template <class Kind, std::size_t count>
using Names = std::array<std::pair<Kind, std::string_view>, count>;

constexpr Names<CurveKind, 6> curves{{{CurveKind::exact, "exact"},
                                      {CurveKind::table, "table"},
                                      {CurveKind::ellipse, "ellipse"},
                                      {CurveKind::superellipse, "superellipse"},
                                      {CurveKind::quartic, "quartic"},
                                      {CurveKind::box, "box"}}};

constexpr Names<Projection, 3> projections{
    {{Projection::radial, "radial"}, {Projection::c_curve, "c-curve"}, {Projection::closest_point, "closest-point"}}};

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

/// The finest table that can be had: `build` makes one of a tolerance, or throws.
template <class Build>
Table finest(const Build& build) {
  double tolerance = Table::finest_tolerance;
  for (;; tolerance *= 10.0) {
    try {
      return build(tolerance);
    } catch (const std::runtime_error&) {
      if (!(tolerance < Table::coarsest_tolerance)) throw;
    }
  }
}

KindOfCurve of_table(const Table& table) {
  return {table, table.certified_error()};
}

template <class Curve>
KindOfCurve finest_of(const Curve& curve, std::string_view name) {
  return of_table(finest([&](double tolerance) { return Table::build(curve, tolerance, std::string(name)); }));
}

}  // namespace

std::string_view to_string(CurveKind kind) noexcept {
  return name_of(curves, kind);
}
std::string_view to_string(Projection projection) noexcept {
  return name_of(projections, projection);
}
CurveKind parse_curve_kind(std::string_view text) {
  return parse(curves, "boundary", text);
}
Projection parse_projection(std::string_view text) {
  return parse(projections, "projection", text);
}

KindOfCurve make_finger_curve(CurveKind kind, const Law& law, double tolerance) {
  switch (kind) {
    case CurveKind::exact:
      return of_table(finest([&](double finer) { return Table::build(law, finer); }));
    case CurveKind::table:
      return of_table(Table::build(law, tolerance));
    case CurveKind::superellipse:
      return finest_of(minimax_superellipse(ExactCurve(law)), "superellipse");
    case CurveKind::quartic:
      return finest_of(minimax_quartic(ExactCurve(law)), "quartic");
    case CurveKind::box:
      return {box(1.0, law->moment_ratio()), 0.0};
    case CurveKind::ellipse:
      break;
  }
  return {Ellipse::through_intercepts(law->moment_ratio()), 0.0};
}

}  // namespace limitcurve::godobject
