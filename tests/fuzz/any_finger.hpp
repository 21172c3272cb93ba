// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/choice.hpp"
#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cmath>
#include <limits>

/// Fingers of any parameters, on the boundaries and projections that the targets of the step go through.
namespace limitcurve::fuzz {

/// A double of the input's own bits, or one that a finger might have: |value| ≤ `usual`.
inline double any_double(Bytes& bytes, bool raw, double usual) {
  if (raw) return bytes.take<double>();
  return usual * static_cast<double>(bytes.take<std::int16_t>()) / 32768.0;
}

inline godobject::FingerParameters any_parameters(Bytes& bytes) {
  const auto choice = bytes.take<std::uint8_t>();
  const auto raw = [&](unsigned bit) { return ((choice >> bit) & 1U) != 0; };
  godobject::FingerParameters result;
  result.mu = std::fabs(any_double(bytes, raw(0), 2.0));
  if (raw(1)) result.mu_dynamic = result.mu * std::fabs(any_double(bytes, false, 1.0));
  if (raw(2)) result.moment_coefficient = std::fabs(any_double(bytes, raw(0), 0.01));
  if (raw(3)) result.radius_law = RadiusLaw::power(0.002, std::fabs(any_double(bytes, false, 1.0)));
  result.stiffness = std::fabs(any_double(bytes, raw(4), 3000.0));
  result.twist_stiffness = std::fabs(any_double(bytes, raw(5), 0.1));
  if (raw(6)) {
    result.damping = std::fabs(any_double(bytes, raw(5), 5.0));
    result.twist_damping = std::fabs(any_double(bytes, raw(4), 1e-3));
  }
  // Believed wherever it is: what leaps is what is hard.
  result.jump_limit = std::numeric_limits<double>::infinity();
  if (raw(7)) {
    result.jump_limit = std::fabs(any_double(bytes, raw(0), 0.1));
    result.hold_share = std::fabs(any_double(bytes, raw(4), 1.0));
  }
  return result;
}

/// Calls `body(boundary, projection)` with the pair that the next byte chooses; boundaries are built once.
template <class Body>
void with_any_boundary(Bytes& bytes, Body&& body) {
  static const Law law = hertz();
  static const Table table = Table::build(law, 1e-6);
  static const ExactCurve exact(law);
  static const Ellipse ellipse = Ellipse::through_intercepts(law->moment_ratio());
  static const auto square = box(1.0, law->moment_ratio());
  static const Superellipse super = minimax_superellipse(exact);
  static const Quartic quartic = minimax_quartic(exact);
  using godobject::CCurve;
  using godobject::ClosestPoint;
  using godobject::Radial;
  switch (bytes.take<std::uint8_t>() % 12U) {
    case 0:
      return body(table, ClosestPoint{});
    case 1:
      return body(table, CCurve{});
    case 2:
      return body(table, Radial{});
    case 3:
      return body(ellipse, Radial{});
    case 4:
      return body(square, ClosestPoint{});
    case 5:
      return body(exact, ClosestPoint{});
    case 6:
      return body(ellipse, ClosestPoint{});
    case 7:
      return body(super, ClosestPoint{});
    case 8:
      return body(quartic, ClosestPoint{});
    case 9:
      return body(super, CCurve{});
    case 10:
      return body(square, CCurve{});
    default:
      return body(quartic, Radial{});
  }
}

}  // namespace limitcurve::fuzz
