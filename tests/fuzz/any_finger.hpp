// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/limitcurve.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/superellipse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// Fingers of any parameters, on the curves and projections that the targets of the step go through.
namespace limitcurve::fuzz {

/// A double from the input's bits, or a plausible value for a finger: |value| ≤ `usual`.
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
  if (raw(2)) result.mu_r = std::fabs(any_double(bytes, raw(0), 0.01));
  if (raw(3)) result.radius_law = RadiusLaw::power(0.002, std::fabs(any_double(bytes, false, 1.0)));
  result.stiffness = std::fabs(any_double(bytes, raw(4), 3000.0));
  result.twist_stiffness = std::fabs(any_double(bytes, raw(5), 0.1));
  if (raw(6)) {
    result.damping = std::fabs(any_double(bytes, raw(5), 5.0));
    result.twist_damping = std::fabs(any_double(bytes, raw(4), 1e-3));
  }
  // Accept every jump: jumps are the hard cases.
  result.max_displacement = std::numeric_limits<double>::infinity();
  if (raw(7)) {
    result.max_displacement = std::fabs(any_double(bytes, raw(0), 0.1));
    result.fault_decay = std::fabs(any_double(bytes, raw(4), 1.0));
  }
  return result;
}

/// A curve and a projection that goes with it.
template <class Real>
struct CurveAndProjection {
  godobject::BasicFingerCurve<Real> curve;
  godobject::Projection projection;
};

/// The pair that the next byte chooses; curves are built once.
template <class Real>
const CurveAndProjection<Real>& any_curve(Bytes& bytes) {
  using godobject::Projection;
  static const std::vector<CurveAndProjection<Real>> choices = [] {
    const Law law = hertz();
    const double finest = std::max(BasicTable<Real>::finest_tolerance, 1e-12);
    const BasicTable<Real> coarse = BasicTable<Real>::build(law, 1e-3);
    const BasicTable<Real> table = BasicTable<Real>::build(law, 1e-6);
    const BasicTable<Real> fine = BasicTable<Real>::build(law, finest);
    const double m0 = law->moment_ratio();
    const BasicTable<Real> pointed = BasicTable<Real>::build(test::Superellipse{1.0, m0, 1.725}, 1e-6, {.name = "pointed"});
    const BasicTable<Real> blunt = BasicTable<Real>::build(test::Superellipse{1.0, m0, 3.0}, 1e-4, {.name = "blunt"});
    const Ellipse ellipse = Ellipse::through_intercepts(m0);
    return std::vector<CurveAndProjection<Real>>{{table, Projection::closest_point},
                                                 {table, Projection::c_curve},
                                                 {table, Projection::radial},
                                                 {ellipse, Projection::radial},
                                                 {box(1.0, m0), Projection::closest_point},
                                                 {fine, Projection::closest_point},
                                                 {ellipse, Projection::closest_point},
                                                 {pointed, Projection::closest_point},
                                                 {blunt, Projection::closest_point},
                                                 {pointed, Projection::c_curve},
                                                 {coarse, Projection::c_curve},
                                                 {blunt, Projection::radial}};
  }();
  return choices[bytes.take<std::uint8_t>() % choices.size()];
}

}  // namespace limitcurve::fuzz
