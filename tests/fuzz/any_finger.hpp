// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/godobject.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/limitcurve.hpp"
#include "limitcurve/table_file.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/superellipse.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
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
  result.max_speed = std::numeric_limits<double>::infinity();
  if (raw(7)) {
    result.max_speed = std::fabs(any_double(bytes, raw(0), 0.1));
    result.fault_decay = std::fabs(any_double(bytes, raw(4), 1.0));
  }
  return result;
}

/// The folder, if any, that tables are kept in: what a table is built from, functions in extended precision, differs
/// between machines.
inline std::filesystem::path kept_tables;

/// The table of that name, as it is kept, or built.
template <class Real, class Curve>
BasicTable<Real> table_of(const std::string& name, const Curve& curve, double tolerance) {
  const BasicTable<Real> built = BasicTable<Real>::build(curve, tolerance, {.name = name});
  if constexpr (std::is_same_v<Real, double>) {
    if (kept_tables.empty()) return built;
    const std::filesystem::path path = kept_tables / (name + ".csv");
    if (!std::filesystem::exists(path)) std::ofstream(path) << to_csv(built);
    std::ifstream file(path);
    return read_table_csv(std::string(std::istreambuf_iterator<char>(file), {}), path.string());
  }
  return built;
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
    const double m0 = law->moment_ratio();
    const auto coarse = table_of<Real>("coarse", law, 1e-3);
    const auto table = table_of<Real>("table", law, 1e-6);
    constexpr double finest = std::max(BasicTable<Real>::finest_tolerance, 1e-12);
    const auto fine = table_of<Real>("fine", law, finest);
    const auto pointed = table_of<Real>("pointed", test::Superellipse{1.0, m0, 1.725}, 1e-6);
    const auto edge = table_of<Real>("edge", flat_punch(), std::max(finest, 1e-8));
    const auto blunt = table_of<Real>("blunt", test::Superellipse{1.0, m0, 3.0}, 1e-4);
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
                                                 {blunt, Projection::radial},
                                                 {edge, Projection::closest_point},
                                                 {edge, Projection::c_curve}};
  }();
  return choices[bytes.take<std::uint8_t>() % choices.size()];
}

}  // namespace limitcurve::fuzz
