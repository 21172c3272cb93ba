// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/godobject.hpp"

#include <Eigen/Core>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

/// What the tests of this folder share: a finger on the plane z = 0, and seeded random numbers.
namespace limitcurve::godobject::test {

/// A finger at (x, y), `depth` beneath the plane z = 0.
inline Contact on_plane(double x, double y, double depth) {
  return {{x, y, 0.0}, Eigen::Vector3d::UnitZ(), depth};
}

inline FingerParameters parameters(double mu = 0.6, double radius = 0.005, double stiffness = 1000.0, double twist_stiffness = 0.04) {
  FingerParameters result;
  result.mu = mu;
  result.radius_law = RadiusLaw::constant(radius);
  result.stiffness = stiffness;
  result.twist_stiffness = twist_stiffness;
  return result;
}

/// Random numbers with a fixed seed: the same on every run.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * unit_(engine_); }
  /// Evenly in the logarithm.
  double logarithmic(double low, double high) { return low * std::pow(high / low, unit_(engine_)); }
  std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

/// Every kind of boundary for a law, handed to `body(boundary, name)`.
template <class Body>
void for_each_boundary(const Law& law, Body&& body) {
  for (const BoundaryKind kind : {BoundaryKind::exact, BoundaryKind::table, BoundaryKind::ellipse, BoundaryKind::superellipse,
                                  BoundaryKind::quartic, BoundaryKind::box}) {
    visit_boundary(kind, law, 1e-8, [&](const auto& boundary) { body(boundary, to_string(kind)); });
  }
  body(diamond(1.0, law->moment_ratio()), std::string_view("diamond"));
}

inline bool same_bits(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::bit_cast<std::array<double, 3>>(std::array{a.x(), a.y(), a.z()}) == std::array{b.x(), b.y(), b.z()};
}

/// A finger of the Hertz law, on the ellipse or the exact curve.
template <class Boundary = Ellipse, class Projection = ClosestPoint>
SoftFinger<Boundary, Projection> hertz_finger(FingerParameters with = parameters()) {
  if constexpr (std::is_same_v<Boundary, Ellipse>) {
    return {Ellipse::through_intercepts(hertz()->moment_ratio()), with};
  } else {
    return {ExactCurve(hertz()), with};
  }
}

}  // namespace limitcurve::godobject::test
