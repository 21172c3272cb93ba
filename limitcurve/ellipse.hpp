// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/intercepts.hpp"
#include "limitcurve/limit_boundary.hpp"

#include <cmath>

namespace limitcurve {

/// The ellipse (f/A)² + (m/B)² = 1 (paper, eq. 19): the usual stand-in for the limit curve, and too strong by 6 to 8 %
/// in the middle when it runs through the intercepts (A = 1, B = m₀). A limit boundary; no trigonometry.
class Ellipse {
 public:
  /// Semi-axes in unit wrenches, both > 0 and finite; throws std::invalid_argument otherwise.
  Ellipse(double force_max, double moment_max) : force_max_(force_max), moment_max_(moment_max) { check_intercepts(force_max, moment_max); }

  /// The paper's ellipse: through (1, 0) and (0, m₀).
  static Ellipse through_intercepts(double moment_ratio) { return {1.0, moment_ratio}; }

  [[nodiscard]] double force_max() const noexcept { return force_max_; }
  [[nodiscard]] double moment_max() const noexcept { return moment_max_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_max_ / force_max_; }

  /// Support point: (A²v, B²w)/√(A²v² + B²w²).
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const double x = force_max_ * twist.slide;
    const double y = moment_max_ * twist.spin;
    const double length = std::sqrt(x * x + y * y);
    return {force_max_ * x / length, moment_max_ * y / length};
  }

  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept {
    const double total = twist.slide + twist.spin;
    const double x = force_max_ * (twist.slide / total);
    const double y = moment_max_ * (twist.spin / total);
    const double square = x * x + y * y;
    const double length = std::sqrt(square);
    // d/du of (x, y)/√(x²+y²) with dx/du = −A, dy/du = B is (A B/len³)(−y, x)·…: the turning rate of the unit vector.
    const double turn = (x * moment_max_ + y * force_max_) / (square * length);
    return {{force_max_ * x / length, moment_max_ * y / length}, {-force_max_ * y * turn, moment_max_ * x * turn}};
  }

  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    const double x = direction.force / force_max_;
    const double y = direction.moment / moment_max_;
    const double length = std::sqrt(x * x + y * y);
    return {{direction.force / length, direction.moment / length}, {x / force_max_, y / moment_max_}};
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    const double x = wrench.force / force_max_;
    const double y = wrench.moment / moment_max_;
    return std::sqrt(x * x + y * y);
  }

 private:
  double force_max_;
  double moment_max_;
};

static_assert(LimitBoundary<Ellipse>);

}  // namespace limitcurve
