// SPDX-License-Identifier: MIT
#include "limitcurve/approximations.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace limitcurve {

void check_intercepts(double force_max, double moment_max) {
  // The squares of the intercepts must not underflow or overflow.
  constexpr double least = 1e-100;
  constexpr double largest = 1e100;
  if (!(force_max >= least && force_max <= largest)) throw out_of_range("force_max", force_max, "1", "1e-100 to 1e100");
  if (!(moment_max >= least && moment_max <= largest))
    throw out_of_range("moment_max", moment_max, "1", "1e-100 to 1e100");
}

Ellipse::Ellipse(double force_max, double moment_max) : force_max_(force_max), moment_max_(moment_max) {
  check_intercepts(force_max, moment_max);
}

SlopedPoint Ellipse::point(SlipTwist twist) const noexcept {
  twist = twist.magnitudes();
  const double total = twist.slide + twist.spin;
  const double x = force_max_ * (twist.slide / total);
  const double y = moment_max_ * (twist.spin / total);
  const double square = x * x + y * y;
  const double length = std::sqrt(square);
  // dx/du = −A and dy/du = B, so the unit vector (x, y)/√(x²+y²) turns at the rate (x B + y A)/(x²+y²).
  const double turn = (x * moment_max_ + y * force_max_) / (square * length);
  return {{force_max_ * x / length, moment_max_ * y / length}, {-force_max_ * y * turn, moment_max_ * x * turn}};
}

RadialPoint Ellipse::along(UnitWrench direction) const noexcept {
  direction = direction.magnitudes();
  const double length = gauge(direction);
  const double force = direction.force / length;
  const double moment = direction.moment / length;
  return {{force, moment}, {force / (force_max_ * force_max_), moment / (moment_max_ * moment_max_)}};
}

void check_vertices(std::span<const UnitWrench> vertices) {
  // Outward normal of the face from vertex i to i + 1.
  const auto face_normal = [vertices](std::size_t i) {
    return SlipTwist{vertices[i + 1].moment - vertices[i].moment, vertices[i].force - vertices[i + 1].force};
  };
  const auto [force_max, no_moment] = vertices.front();
  const auto [no_force, moment_max] = vertices.back();
  check_intercepts(force_max, moment_max);
  if (no_moment != 0.0) throw out_of_range("moment of the first vertex", no_moment, "1", "0");
  if (no_force != 0.0) throw out_of_range("force of the last vertex", no_force, "1", "0");
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    const SlipTwist here = face_normal(i);
    if (!(here.slide >= 0.0 && here.spin >= 0.0 && here.slide + here.spin > 0.0)) {
      throw std::invalid_argument("vertex " + std::to_string(i + 1) +
                                  ": expected force not above and moment not below those of vertex " +
                                  std::to_string(i));
    }
    if (i == 0) continue;
    const SlipTwist before = face_normal(i - 1);
    if (!(before.slide * here.spin > before.spin * here.slide)) {
      throw std::invalid_argument("vertex " + std::to_string(i) +
                                  " is not a convex corner: expected a left turn at every vertex");
    }
  }
}

}  // namespace limitcurve
