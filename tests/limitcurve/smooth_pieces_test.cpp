// SPDX-License-Identifier: MIT
// Pressures with kinks and jumps of which nobody told.
#include "limitcurve/smooth_pieces.hpp"
#include "limitcurve/accuracy.hpp"
#include "limitcurve/laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace limitcurve {
namespace {

constexpr std::array<double, 2> whole{0.0, 1.0};
constexpr std::array<double, 14> cors{0.0, 1e-6, 0.1, 0.31, 0.37, 0.5, 0.62, 0.75, 0.9, 1.0, 1.1, 2.0, 30.0, 1e6};

/// Σ shares·parabolic of these radii: a kink at each, and a wrench in closed form.
struct Paraboloids {
  std::vector<double> radii;

  [[nodiscard]] double operator()(double rho) const {
    double sum = 0.0;
    for (const double b : radii) sum += 2.0 / (b * b) * std::max((1.0 - rho / b) * (1.0 + rho / b), 0.0);
    return sum / static_cast<double>(radii.size());
  }
  [[nodiscard]] UnitWrench wrench(double s) const {
    UnitWrench sum{};
    for (const double b : radii) {
      const UnitWrench one = parabolic()->evaluate(s / b).wrench;
      sum.force += one.force / static_cast<double>(radii.size());
      sum.moment += b * one.moment / static_cast<double>(radii.size());
    }
    return sum;
  }
};

/// Uniform discs of these radii, the smallest first, on each other: a jump at each.
struct Stairs {
  std::vector<double> radii;

  [[nodiscard]] double operator()(double rho) const {
    return static_cast<double>(radii.end() - std::lower_bound(radii.begin(), radii.end(), rho));
  }
  [[nodiscard]] UnitWrench wrench(double s) const {
    UnitWrench sum{};
    double area = 0.0;
    for (const double b : radii) {
      const UnitWrench one = uniform()->evaluate(s / b).wrench;
      sum.force += b * b * one.force;
      sum.moment += b * b * b * one.moment;
      area += b * b;
    }
    return {sum.force / area, sum.moment / area};
  }
};

template <class Pressure>
void expect_found(const char* name, const Pressure& pressure, double most) {
  const Law law = from_pressure(name, pressure, whole);
  for (const double s : cors) {
    const UnitWrench truth = pressure.wrench(s);
    const WrenchEstimate estimate = law->evaluate(s);
    // Beside its own error that of the closed forms, summed.
    EXPECT_NEAR(estimate.wrench.force, truth.force, estimate.error.force + 1e-15 * truth.force) << name << ", s = " << s;
    EXPECT_NEAR(estimate.wrench.moment, truth.moment, estimate.error.moment + 1e-15 * truth.moment) << name << ", s = " << s;
    EXPECT_LE(estimate.error.force, most) << name;
    EXPECT_LE(estimate.error.moment, most) << name;
    const UnitForces<double> quick = law->forces(s);
    EXPECT_NEAR(quick.force, truth.force, accuracy::forces_by_quadrature * truth.force) << name << ", s = " << s;
    EXPECT_NEAR(quick.moment, truth.moment, accuracy::forces_by_quadrature * truth.moment) << name << ", s = " << s;
  }
}

TEST(SmoothPieces, FindsWhatNobodyToldOf) {
  expect_found("a kink", Paraboloids{{0.371, 1.0}}, 4e-15);
  expect_found("kinks", Paraboloids{{0.31, 0.47, 0.62, 0.83, 1.0}}, 4e-15);
  expect_found("a kink at the middle", Paraboloids{{0.5, 1.0}}, 4e-15);
  expect_found("a kink near the rim", Paraboloids{{0.9999, 1.0}}, 4e-15);
  expect_found("kinks beside each other", Paraboloids{{0.5, 0.50001, 1.0}}, 4e-15);
  expect_found("a jump", Stairs{{1.0 / 3.0, 1.0}}, 4e-15);
  expect_found("jumps", Stairs{{0.1, 0.27, 0.28, 0.5, 0.77, 1.0}}, 1e-14);
}

TEST(SmoothPieces, AreNoMoreThanToldWhereTheFunctionIsSmooth) {
  const std::vector<Extended> told{0, 1};
  for (const auto& [name, function] : std::initializer_list<std::pair<const char*, std::function<Extended(Extended)>>>{
           {"constant", [](Extended) { return Extended(3); }},
           {"Hertz", [](Extended rho) { return rho * std::sqrt((1 - rho) * (1 + rho)); }},
           {"in double", [](Extended rho) { return static_cast<double>(rho) * std::sqrt(1.0 - static_cast<double>(rho * rho)); }},
           {"root", [](Extended rho) { return std::sqrt(rho); }},
           {"bell", [](Extended rho) { return rho * std::exp(-50 * rho * rho); }},
       }) {
    const SmoothPieces pieces = smooth_pieces(function, told);
    EXPECT_EQ(pieces.breaks, told) << name;
    EXPECT_LE(pieces.error, 1e-16L) << name;
  }
  // Those that are told stay.
  const std::vector<Extended> kinked{0, 0.25L, 1};
  EXPECT_EQ(smooth_pieces([](Extended rho) { return std::fabs(rho - 0.25L); }, kinked).breaks, kinked);
  EXPECT_EQ(smooth_pieces([](Extended) { return Extended(0); }, told).breaks, told);
}

// What cannot be cut owns up to it: three hundred jumps, and a pressure that flickers from place to place.
TEST(SmoothPieces, StateTheErrorOfWhatIsTooRough) {
  Stairs stairs;
  for (int i = 1; i <= 300; ++i) stairs.radii.push_back(i / 300.0);
  const Law law = from_pressure("steps by the hundred", stairs, whole);
  for (const double s : cors) {
    const UnitWrench truth = stairs.wrench(s);
    const WrenchEstimate estimate = law->evaluate(s);
    EXPECT_NEAR(estimate.wrench.force, truth.force, estimate.error.force) << s;
    EXPECT_NEAR(estimate.wrench.moment, truth.moment, estimate.error.moment) << s;
    EXPECT_LE(estimate.error.force, 1e-3);
  }
  const auto flicker = [](Extended rho) { return rho * (1 + std::sin(1e9L * rho) / 2); };
  const SmoothPieces pieces = smooth_pieces(flicker, {0, 1});
  EXPECT_GE(pieces.error, 1e-3L);
  EXPECT_EQ(pieces.breaks.size(), 2U);
}

}  // namespace
}  // namespace limitcurve
