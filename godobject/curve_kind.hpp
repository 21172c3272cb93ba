// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger_curve.hpp"
#include "godobject/projection.hpp"
#include "limitcurve/law.hpp"

#include <string_view>

namespace limitcurve::godobject {

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

/// A finger's curve, and how far it is from the curve that its kind names: 0 in closed form, else the table's certified error.
struct KindOfCurve {
  FingerCurve curve;
  double error;
};

/// The curve of that kind for a law; `tolerance` counts for `table` only. Allocates, and throws what the builder of the table throws. Cost: that
/// of a table; `exact` takes milliseconds where the law has a closed form, seconds by quadrature.
KindOfCurve make_finger_curve(CurveKind kind, const Law& law, double tolerance);

}  // namespace limitcurve::godobject
