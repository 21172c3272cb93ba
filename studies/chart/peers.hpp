// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

/// Methods to compute a friction wrench without this library, each as good as its tools allow: s ∈ [0, ∞), pressures on
/// 0 ≤ ρ ≤ 1.
namespace limitcurve::bench {

/// The whole g(ρ), with its singularity at the rim.
inline double pressure_at(const PressureLaw& law, double radius, double rim) {
  const double exponent = static_cast<double>(law.rim_exponent());
  const double regular = law.density(RadialPosition<double>{radius, rim});
  return exponent == 0.0 ? regular : regular * std::pow(rim, exponent);
}

/// Eq. (17) summed over the N × N cells of a square around the contact, as papers do. The pressure of each cell is taken
/// beforehand and scaled to load 1, which is to the grid's advantage.
class Grid {
 public:
  Grid(const PressureLaw& law, int cells) {
    double load = 0.0;
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const double x = -1.0 + (2.0 * i + 1.0) / cells;
        const double y = -1.0 + (2.0 * j + 1.0) / cells;
        const double radius = std::sqrt(x * x + y * y);
        if (!(radius < 1.0)) continue;
        cells_.push_back({x, y, pressure_at(law, radius, 1.0 - radius)});
        load += cells_.back().load;
      }
    }
    for (Cell& cell : cells_) cell.load /= load;
  }

  [[nodiscard]] std::size_t bytes() const { return cells_.size() * sizeof(Cell); }

  UnitWrench operator()(double s) const {
    UnitWrench sum;
    for (const auto& [x, y, load] : cells_) {
      const double share = load / std::sqrt((s - x) * (s - x) + y * y);
      sum.force += share * (s - x);
      sum.moment += share * (x * (x - s) + y * y);
    }
    return sum;
  }

 private:
  struct Cell {
    double x, y, load;
  };
  std::vector<Cell> cells_;
};

/// The integrand of eq. (17) as printed, at radius ρ and angle θ from the COR.
inline double printed_integrand(const PressureLaw& law, bool moment, double s, double radius, double angle) {
  const double x = radius * std::cos(angle);
  const double y = radius * std::sin(angle);
  const double distance = std::sqrt((s - x) * (s - x) + y * y);
  if (distance == 0.0) return 0.0;
  const double weight = 2.0 / 3.14159265358979323846 * radius * pressure_at(law, radius, 1.0 - radius);
  return weight * (moment ? radius * radius - s * x : s - x) / distance;
}

/// Eq. (17) as printed by two nested adaptive Gauss–Kronrod rules of Boost.
class BoostNested {
 public:
  BoostNested(const PressureLaw& law, double tolerance) : law_(&law), tolerance_(tolerance) {}

  UnitWrench operator()(double s) const {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
    constexpr unsigned depth = 10;
    const auto integral = [&](bool moment) {
      const auto over_angle = [&](double radius) {
        return Rule::integrate([&](double angle) { return printed_integrand(*law_, moment, s, radius, angle); }, 0.0,
                               3.14159265358979323846, depth, tolerance_);
      };
      return Rule::integrate(over_angle, 0.0, 1.0, depth, tolerance_);
    };
    return {integral(false), integral(true)};
  }

 private:
  const PressureLaw* law_;
  double tolerance_;
};

/// Hermite cubics over equal cells of the spin fraction with the exact curve's slopes, both components from one cell: the most obvious
/// table. It has no error bound, and equal cells give a large error at the rim.
class EqualHermite {
 public:
  template <class Exact>
  EqualHermite(const Exact& exact, std::size_t entries) : scale_(static_cast<double>(entries)) {
    for (std::size_t i = 0; i < entries; ++i) {
      const SlopedPoint left = exact.point(SlipTwist::of_spin_fraction(static_cast<double>(i) / scale_));
      const SlopedPoint right = exact.point(SlipTwist::of_spin_fraction(static_cast<double>(i + 1) / scale_));
      cells_.push_back({cubic(left.wrench.force, right.wrench.force, left.slope.force / scale_, right.slope.force / scale_),
                        cubic(left.wrench.moment, right.wrench.moment, left.slope.moment / scale_, right.slope.moment / scale_)});
    }
  }

  [[nodiscard]] std::size_t bytes() const { return cells_.size() * sizeof(Cell); }

  UnitWrench operator()(SlipTwist twist) const {
    const double place = twist.spin_fraction() * scale_;
    const std::size_t i = std::min(static_cast<std::size_t>(place), cells_.size() - 1);
    const double x = place - static_cast<double>(i);
    const auto& [f, m] = cells_[i];
    return {f.a + x * (f.b + x * (f.c + x * f.d)), m.a + x * (m.b + x * (m.c + x * m.d))};
  }

 private:
  struct Cubic {
    double a, b, c, d;
  };
  struct Cell {
    Cubic force, moment;
  };
  static Cubic cubic(double left, double right, double left_slope, double right_slope) {
    const double rise = right - left;
    return {left, left_slope, 3.0 * rise - 2.0 * left_slope - right_slope, left_slope + right_slope - 2.0 * rise};
  }
  double scale_;
  std::vector<Cell> cells_;
};

}  // namespace limitcurve::bench
