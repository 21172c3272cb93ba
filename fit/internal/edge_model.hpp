// SPDX-License-Identifier: MIT
#pragma once

#include "fit/internal/contact_preparation.hpp"
#include "limitcurve/internal/interruption.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

/// The likelihood of a log's rows under `Loss::edge`: edge.hpp.
namespace limitcurve::fit::internal {

inline constexpr double smallest_sigma = 0.003;  ///< of e: rows at the limit creep
inline constexpr double far_outside = 4.0;

/// The gradient of a unit curve's gauge s(x, y), tabulated over y/(x + y). Because s is homogeneous, it is also
/// s = s_x x + s_y y. Interpolated linearly in 1024 cells, to about 1e-6.
class GaugeTable {
 public:
  explicit GaugeTable(const UnitCurve& curve) {
    for (std::size_t i = 0; i <= cells; ++i) {
      const double share = static_cast<double>(i) / cells;
      double low = 0.0;
      double high = 1.0;
      for (int step = 0; step < 50; ++step) {
        const double middle = 0.5 * (low + high);
        const PlanePoint point = curve.at(middle).point;
        (point.y < share * (point.x + point.y) ? low : high) = middle;
      }
      const auto [point, tangent] = curve.at(0.5 * (low + high));
      const double along = tangent.y * point.x - tangent.x * point.y;
      nodes_.at(i) = {tangent.y / along, -tangent.x / along};
    }
  }
  [[nodiscard]] PlanePoint gradient(double x, double y) const noexcept {
    const double place = x + y > 0.0 ? y / (x + y) * cells : 0.0;
    const std::size_t cell = std::min(static_cast<std::size_t>(place), cells - 1);
    const double share = place - static_cast<double>(cell);
    const PlanePoint& low = nodes_[cell];
    const PlanePoint& high = nodes_[cell + 1];
    return {low.x + share * (high.x - low.x), low.y + share * (high.y - low.y)};
  }

 private:
  static constexpr std::size_t cells = 1024;
  std::array<PlanePoint, cells + 1> nodes_{};
};

/// Per newton of load.
struct EdgeRow {
  double force;
  double moment;
  double sigma_force;
  double sigma_moment;
  double log_load;  ///< relative to the reference load
  std::size_t grip;
};

/// Where a row is: its gauge, the standard deviation of that, and the polar angle of its wrench.
struct EdgePlace {
  double size;
  double sigma;
  double angle;
};

/// log μ, log μ_r, γ if free, logit p, log k.
class EdgeModel {
 public:
  EdgeModel(const GaugeTable& gauge, bool fit_gamma, double gamma)
      : gauge_(gauge), fit_gamma_(fit_gamma), gamma_(gamma) {}

  [[nodiscard]] Eigen::Index limits() const noexcept { return fit_gamma_ ? 3 : 2; }
  [[nodiscard]] Eigen::Index size() const noexcept { return limits() + 2; }
  [[nodiscard]] EdgePlace place(const EdgeRow& row, const Eigen::VectorXd& v) const noexcept {
    const double force = std::exp(v[0]);
    const double moment = std::exp(v[1] + (fit_gamma_ ? v[2] : gamma_) * row.log_load);
    const double x = row.force / force;
    const double y = row.moment / moment;
    const PlanePoint slope = gauge_.gradient(x, y);
    return {slope.x * x + slope.y * y,
            std::hypot(slope.x * row.sigma_force / force, slope.y * row.sigma_moment / moment), std::atan2(y, x)};
  }
  /// The probability that a row is at the limit, and the negative logarithm of its likelihood.
  struct Chance {
    double at_limit;
    double cost;
  };
  [[nodiscard]] Chance chance(const EdgePlace& place, const Eigen::VectorXd& v) const noexcept {
    const double e = place.size - 1.0;
    const double p = 1.0 / (1.0 + std::exp(-v[limits()]));
    const double sigma = std::hypot(place.sigma * std::exp(v[limits() + 1]), smallest_sigma);
    const double at_limit =
        p * std::exp(-0.5 * (e / sigma) * (e / sigma)) / (std::sqrt(2.0 * std::numbers::pi) * sigma);
    const double unit = 1.0 / (std::numbers::sqrt2 * sigma);
    const double below = (1.0 - p) * 0.5 * (std::erf((e + 1.0) * unit) - std::erf(e * unit));
    const double all = at_limit + below + 1e-3 / (1.0 + e * e);
    return {at_limit / all, -std::log(all * std::max(place.size, 1e-6))};
  }
  [[nodiscard]] double cost(std::span<const EdgeRow> rows, const Eigen::VectorXd& v) const {
    let_interrupt();
    double sum = 0.0;
    for (const EdgeRow& row : rows) sum += chance(place(row, v), v).cost;
    return sum;
  }
  /// The share of rows farther outside than their noise explains.
  [[nodiscard]] double outside(std::span<const EdgeRow> rows, const Eigen::VectorXd& v) const {
    const auto count = std::ranges::count_if(rows, [&](const EdgeRow& row) {
      const EdgePlace at = place(row, v);
      return at.size - 1.0 > far_outside * std::hypot(at.sigma, smallest_sigma);
    });
    return static_cast<double>(count) / static_cast<double>(rows.size());
  }

  /// Bounds of all but the first two. Without those of p and k the edge of rows without noise is a second maximum.
  [[nodiscard]] std::array<double, 2> bounds(Eigen::Index i) const {
    if (i == limits()) return {-3.9, 6.0};
    if (i == limits() + 1) return {std::log(0.6), std::log(3.0)};
    return gamma_range;
  }

 private:
  const GaugeTable& gauge_;
  bool fit_gamma_;
  double gamma_;
};

}  // namespace limitcurve::fit::internal
