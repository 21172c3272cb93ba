// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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

/// Eq. (17) summed over the N × N cells of a square around the contact, as papers do. The pressure of each cell is
/// taken beforehand and scaled to load 1, which is to the grid's advantage.
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

/// The angular integral in closed form by Carlson's integrals, the radius by Boost's tanh–sinh rule, split at ρ = s and
/// where the pressure has kinks, with the rim's infinite pressure taken into the variable.
class BoostSplit {
 public:
  BoostSplit(const PressureLaw& law, double tolerance)
      : law_(&law), tolerance_(tolerance), exponent_(static_cast<double>(law.rim_exponent())) {}

  UnitWrench operator()(double s) const {
    UnitWrench sum{};
    const std::vector<Extended>& breaks = law_->breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const auto left = static_cast<double>(breaks[i]);
      const auto right = static_cast<double>(breaks[i + 1]);
      const double split = std::clamp(s, left, right);
      for (double UnitWrench::*const part : {&UnitWrench::force, &UnitWrench::moment}) {
        if (left < split) sum.*part += piece(s, left, split, part);
        if (split < right) sum.*part += piece(s, split, right, part);
      }
    }
    return sum;
  }

 private:
  using Quiet =
      boost::math::policies::policy<boost::math::policies::promote_double<false>,
                                    boost::math::policies::domain_error<boost::math::policies::ignore_error>,
                                    boost::math::policies::overflow_error<boost::math::policies::ignore_error>,
                                    boost::math::policies::evaluation_error<boost::math::policies::ignore_error>>;

  static UnitWrench kernel(double rho, double s, double from_cor) {
    constexpr double scale = 0.6366197723675814;  // 2/π
    const double larger = std::max(rho, s);
    const double q = std::min(rho, s) / larger;
    const double complement = std::max(from_cor / larger * ((rho + s) / larger), std::numeric_limits<double>::min());
    const double d = boost::math::ellint_rd(0.0, complement, 1.0, Quiet()) / 3.0;
    const double b = boost::math::ellint_rf(0.0, complement, 1.0, Quiet()) - d;
    const double e = b + complement * d;
    return rho <= s ? UnitWrench{scale * e, scale * rho * q * b} : UnitWrench{scale * q * b, scale * rho * e};
  }

  double piece(double s, double left, double right, double UnitWrench::*part) const {
    static boost::math::quadrature::tanh_sinh<double, Quiet> rule;
    const auto outer = static_cast<double>(law_->breaks().back());
    const double length = right - left;
    // The pressure grows like rim^exponent: on the last piece rim = length·y^power takes that factor into dy.
    const bool is_last = right == outer && exponent_ != 0.0;
    const double power = is_last ? 1.0 / (1.0 + exponent_) : 1.0;
    const double scale = is_last ? std::pow(length, exponent_) * power : 1.0;
    const auto integrand = [&](double from_left, double from_right) {
      if (is_last) {
        const double log_y = from_left < from_right ? std::log1p(-from_left / length) : std::log(from_right / length);
        from_left = length * -std::expm1(power * log_y);
        from_right = length * std::exp(power * log_y);
      }
      const double rho = from_left < from_right ? left + from_left : right - from_right;
      if (rho < std::numeric_limits<double>::min()) return 0.0;
      const double rim = (outer - right) + from_right;
      const double from_cor = s <= left ? (left - s) + from_left : (s - right) + from_right;
      const double weight = exponent_ != 0.0 && !is_last ? std::pow(rim, exponent_) : scale;
      return 2.0 * rho * law_->density(RadialPosition<double>{rho, rim}) * weight * kernel(rho, s, from_cor).*part;
    };
    // Boost passes the distance from the nearer end of [−1, 1], negative at the left end.
    const double half = 0.5 * length;
    return half * rule.integrate(
                      [&](double, double end) {
                        const double near = half * std::fabs(end);
                        return end < 0.0 ? integrand(near, length - near) : integrand(length - near, near);
                      },
                      tolerance_);
  }

  const PressureLaw* law_;
  double tolerance_;
  double exponent_;
};

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

/// Hermite cubics over equal cells of the spin fraction with the exact curve's slopes: the most obvious table. A cell's
/// coefficients of force and moment alternate, so that one vector instruction serves both. It has no error bound, and
/// equal cells give a large error at the rim.
class EqualHermite {
 public:
  template <class Exact>
  EqualHermite(const Exact& exact, std::size_t entries) : scale_(static_cast<double>(entries)) {
    for (std::size_t i = 0; i < entries; ++i) {
      const SlopedPoint left = exact.point(SlipTwist::of_spin_fraction(static_cast<double>(i) / scale_));
      const SlopedPoint right = exact.point(SlipTwist::of_spin_fraction(static_cast<double>(i + 1) / scale_));
      Cell& cell = cells_.emplace_back();
      for (double UnitWrench::*const part : {&UnitWrench::force, &UnitWrench::moment}) {
        const double rise = right.wrench.*part - left.wrench.*part;
        const double slope = left.slope.*part / scale_;
        const double next = right.slope.*part / scale_;
        cell[0].*part = left.wrench.*part;
        cell[1].*part = slope;
        cell[2].*part = 3.0 * rise - 2.0 * slope - next;
        cell[3].*part = slope + next - 2.0 * rise;
      }
    }
  }

  [[nodiscard]] std::size_t bytes() const { return cells_.size() * sizeof(Cell); }

  UnitWrench operator()(SlipTwist twist) const {
    const double place = twist.spin_fraction() * scale_;
    const std::size_t i = std::min(static_cast<std::size_t>(place), cells_.size() - 1);
    const double x = place - static_cast<double>(i);
    const auto& [a, b, c, d] = cells_[i];
    return {a.force + x * (b.force + x * (c.force + x * d.force)),
            a.moment + x * (b.moment + x * (c.moment + x * d.moment))};
  }

 private:
  using Cell = std::array<UnitWrench, 4>;

  double scale_;
  std::vector<Cell> cells_;
};

}  // namespace limitcurve::bench
