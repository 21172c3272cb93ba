// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/point_sums.hpp"
#include "limitcurve/patch/shape.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace limitcurve::patch {

namespace {

/// Makes the loads sum to 1; returns their centre of pressure: from the first point, so that of points at one place it
/// is that place.
PatchPoint normalise(std::vector<PatchLoad>& loads) {
  const PatchLoad first = loads.front();
  Extended total = 0;
  Extended x = 0;
  Extended y = 0;
  double heaviest = 0.0;
  for (const PatchLoad& point : loads) heaviest = std::max(heaviest, point.load);
  for (const PatchLoad& point : loads) {
    const Extended load = Extended(point.load) / heaviest;
    total += load;
    x += load * (Extended(point.x) - first.x);
    y += load * (Extended(point.y) - first.y);
  }
  for (PatchLoad& point : loads) point.load = static_cast<double>(Extended(point.load) / heaviest / total);
  return {static_cast<double>(first.x + x / total), static_cast<double>(first.y + y / total)};
}

std::vector<PatchLoad> stretch_loads(std::vector<PatchLoad> loads, double sx, double sy) {
  for (PatchLoad& point : loads) point = {sx * point.x, sy * point.y, point.load};
  return loads;
}

/// Bound on the rounding error of a sum over `count` points: of power and force, and of the moment in units of m₀.
double rounding(std::size_t count, double radius, double moment_ratio) {
  const double terms = 4.0 + static_cast<double>(count) / 8.0;
  return terms * epsilon * (1.0 + (moment_ratio > 0.0 ? radius / moment_ratio : 0.0));
}

/// H = Σ w |v + ω ẑ × x|. The points keep the user's coordinates, so that a COR on a point is recognised exactly.
struct Points final : Shape {
  std::vector<PatchLoad> loads;  ///< not stretched
  PatchPoint stretch;            ///< of x and y, by orthotropic friction
  PatchPoint middle;  ///< the centre of pressure, not stretched: divided back, it would lie beside a single point

  explicit Points(std::vector<PatchLoad> points, PatchPoint scale = {1.0, 1.0})
      : loads(std::move(points)), stretch(scale), middle(normalise(loads)) {
    centre = {stretch.x * middle.x, stretch.y * middle.y};
    for (const PatchLoad& point : loads) {
      radius = std::max(radius, std::hypot(stretch.x * (point.x - middle.x), stretch.y * (point.y - middle.y)));
    }
    measure_moment_ratio();
  }

  /// The sum at the user's twist about `reference`, not stretched either. Adds to `lost` the loads of points whose slip
  /// is below the rounding of the twist.
  [[nodiscard]] PatchFriction sum(const PatchTwist& twist, PatchPoint reference, PatchPoint factors,
                                  double& lost) const noexcept {
    PatchFriction friction;
    for (const PatchLoad& point : loads) {
      const double x = point.x - reference.x;
      const double y = point.y - reference.y;
      auto [ux, uy] = velocity_at(twist, x, y);
      // Within the rounding of the twist the COR is on the point, which then bears no force.
      if (std::fabs(ux) <= 2.0 * epsilon * std::fabs(twist.vx) &&
          std::fabs(uy) <= 2.0 * epsilon * std::fabs(twist.vy)) {
        if (ux != 0.0 || uy != 0.0) lost += point.load;
        continue;
      }
      // Stretched only now: the factors would round the twist, and with it the direction of a small slip.
      ux *= factors.x;
      uy *= factors.y;
      const double speed = std::sqrt(ux * ux + uy * uy);
      // The square of a small speed underflows, but its direction still counts.
      const double safe = speed > 1e-150 ? speed : std::hypot(ux, uy);
      ux *= point.load / safe;
      uy *= point.load / safe;
      friction.power += point.load * safe;
      friction.wrench.fx += ux;
      friction.wrench.fy += uy;
      friction.wrench.moment += stretch.x * x * uy - stretch.y * y * ux;
    }
    return friction;
  }

  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist, double& lost) const noexcept {
    const PatchTwist unstretched{twist.vx / stretch.y, twist.vy / stretch.x, twist.omega};
    return sum(unstretched, middle, {stretch.y, stretch.x}, lost);
  }
  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept override {
    double lost = 0.0;
    return evaluate(twist, lost);
  }
  [[nodiscard]] double error(const PatchTwist& twist) const noexcept override {
    double lost = 0.0;
    (void)evaluate(twist, lost);
    return rounding(loads.size(), radius, moment_ratio) +
           lost * (1.0 + (moment_ratio > 0.0 ? radius / moment_ratio : 0.0));
  }
  [[nodiscard]] PatchFriction about_origin(const PatchTwist& twist, PatchPoint factors,
                                           PatchPoint) const noexcept override {
    double lost = 0.0;
    PatchFriction friction = sum(twist, {0.0, 0.0}, factors, lost);
    friction.wrench.fx *= factors.x;
    friction.wrench.fy *= factors.y;
    const double reach = radius + std::hypot(centre.x, centre.y);
    friction.error =
        rounding(loads.size(), reach, moment_ratio) + lost * (1.0 + (moment_ratio > 0.0 ? reach / moment_ratio : 0.0));
    return friction;
  }

  [[nodiscard]] std::vector<PatchLoad> stretched_loads() const { return stretch_loads(loads, stretch.x, stretch.y); }
  [[nodiscard]] std::shared_ptr<Shape> stretched(double sx, double sy) const override {
    return std::make_shared<Points>(loads, PatchPoint{sx * stretch.x, sy * stretch.y});
  }
  [[nodiscard]] std::shared_ptr<Shape> smoothed(double least_radius) const override {
    return make_soft_points(stretched_loads(), least_radius);
  }
  [[nodiscard]] double nanoseconds() const noexcept override { return 10.0 + 4.0 * static_cast<double>(loads.size()); }
  [[nodiscard]] std::vector<PatchLoad> concentrations() const override { return stretched_loads(); }
};

/// H = Σ w √(|u|² + ε²ω²).
struct SoftPoints final : Shape {
  std::vector<PatchLoad> loads;
  std::vector<double> xs;
  std::vector<double> ys;
  std::vector<double> weights;
  double softness;  ///< ε²

  SoftPoints(std::vector<PatchLoad> points, double point_radius)
      : loads(std::move(points)), softness(point_radius * point_radius) {
    centre = normalise(loads);
    for (const PatchLoad& point : loads) {
      xs.push_back(point.x - centre.x);
      ys.push_back(point.y - centre.y);
      weights.push_back(point.load);
      radius = std::max(radius, std::hypot(xs.back(), ys.back()) + point_radius);
    }
    measure_moment_ratio();
  }

  [[nodiscard]] PatchFriction evaluate(const PatchTwist& twist) const noexcept override {
    if (only_slides(twist, radius)) return sliding(twist);
    return sum_soft_points(xs.data(), ys.data(), weights.data(), xs.size(), twist,
                           softness * twist.omega * twist.omega);
  }
  [[nodiscard]] double error(const PatchTwist&) const noexcept override {
    return rounding(loads.size(), radius, moment_ratio);
  }
  [[nodiscard]] std::shared_ptr<Shape> stretched(double sx, double sy) const override {
    return std::make_shared<SoftPoints>(stretch_loads(loads, sx, sy), std::sqrt(softness * sx * sy));
  }
  [[nodiscard]] double nanoseconds() const noexcept override { return 20.0 + 1.5 * static_cast<double>(loads.size()); }
  [[nodiscard]] std::vector<PatchLoad> concentrations() const override {
    std::vector<PatchLoad> middles = loads;
    for (PatchLoad& middle : middles) middle.load = 0.0;
    return middles;
  }
};

}  // namespace

std::shared_ptr<Shape> make_points(std::span<const PatchLoad> loads) {
  std::vector<PatchLoad> pressed;
  const auto fits = [](double coordinate) { return std::fabs(coordinate) <= most_length; };
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const auto& [x, y, load] = loads[i];
    const std::string place = "point " + std::to_string(i + 1) + ": ";
    if (!fits(x)) throw std::invalid_argument(place + out_of_range("x", x, "m", "-1e100 <= x <= 1e100").what());
    if (!fits(y)) throw std::invalid_argument(place + out_of_range("y", y, "m", "-1e100 <= y <= 1e100").what());
    if (!(load >= 0.0 && load <= std::numeric_limits<double>::max())) {
      throw std::invalid_argument(place + out_of_range("load", load, "1", "a finite number >= 0").what());
    }
    if (load > 0.0) pressed.push_back(loads[i]);
  }
  if (loads.empty()) throw std::invalid_argument("no points, expected at least one");
  if (pressed.empty())
    throw std::invalid_argument("all " + std::to_string(loads.size()) +
                                " points have load 0, expected one of load > 0");
  require_size(std::span<const PatchLoad>(pressed));
  return std::make_shared<Points>(std::move(pressed));
}

std::shared_ptr<Shape> make_soft_points(std::vector<PatchLoad> loads, double radius) {
  return std::make_shared<SoftPoints>(std::move(loads), radius);
}

}  // namespace limitcurve::patch
