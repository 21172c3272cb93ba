// SPDX-License-Identifier: MIT
#include "limitcurve/approximations.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace limitcurve {

namespace {

/// The wrench whose coordinates x = f/A and y = m/B are `larger` and `ratio`·`larger`; x is the larger one if `force_leads`.
UnitWrench between_intercepts(double force_max, double moment_max, bool force_leads, double larger, double ratio) noexcept {
  return force_leads ? UnitWrench{force_max * larger, moment_max * (ratio * larger)}
                     : UnitWrench{force_max * (ratio * larger), moment_max * larger};
}

/// Gauge of a wrench for a curve that is symmetric in x = f/A and y = m/B. `unit_length(r)` is the gauge of (x, y) = (1, r), r ∈ [0, 1].
template <class UnitLength>
double symmetric_gauge(double force_max, double moment_max, UnitWrench wrench, UnitLength&& unit_length) noexcept {
  const double x = wrench.force / force_max;
  const double y = wrench.moment / moment_max;
  const double larger = std::max(x, y);
  return larger > 0.0 ? larger * unit_length(std::min(x, y) / larger) : 0.0;
}

}  // namespace

void check_intercepts(double force_max, double moment_max) {
  // The squares of the intercepts must not underflow or overflow.
  constexpr double least = 1e-100;
  constexpr double largest = 1e100;
  if (!(force_max >= least && force_max <= largest)) throw out_of_range("force_max", force_max, "1", "1e-100 to 1e100");
  if (!(moment_max >= least && moment_max <= largest)) throw out_of_range("moment_max", moment_max, "1", "1e-100 to 1e100");
}

Ellipse::Ellipse(double force_max, double moment_max) : force_max_(force_max), moment_max_(moment_max) {
  check_intercepts(force_max, moment_max);
}

SlopedPoint Ellipse::point(SlipTwist twist) const noexcept {
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
  const double length = gauge(direction);
  const double force = direction.force / length;
  const double moment = direction.moment / length;
  return {{force, moment}, {force / (force_max_ * force_max_), moment / (moment_max_ * moment_max_)}};
}

Superellipse::Superellipse(double force_max, double moment_max, double exponent)
    : force_max_(force_max), moment_max_(moment_max), exponent_(exponent), inverse_(1.0 / (exponent - 1.0)) {
  check_intercepts(force_max, moment_max);
  if (!(exponent > 1.0) || std::isinf(exponent)) throw out_of_range("exponent", exponent, "1", "> 1 and finite");
}

UnitWrench Superellipse::wrench(SlipTwist twist) const noexcept {
  if (twist.is_zero()) return {};
  twist = twist.magnitudes();
  const double p = force_max_ * twist.slide;
  const double q = moment_max_ * twist.spin;
  const double ratio = std::pow(std::min(p, q) / std::max(p, q), inverse_);
  const double larger = std::pow(1.0 + std::pow(ratio, exponent_), -1.0 / exponent_);
  return between_intercepts(force_max_, moment_max_, p >= q, larger, ratio);
}

SlopedPoint Superellipse::point(SlipTwist twist) const noexcept {
  const double total = twist.slide + twist.spin;
  const double slide = std::max(twist.slide / total, end_distance);
  const double spin = std::max(twist.spin / total, end_distance);
  // d ln(q/p)/du = 1/(u(1−u)); then d ln x = −yⁿ d ln(y/x), d ln y = xⁿ d ln(y/x).
  const UnitWrench near = wrench({slide, spin});
  const double force_share = std::pow(near.force / force_max_, exponent_);
  const double moment_share = std::pow(near.moment / moment_max_, exponent_);
  const double turn = inverse_ / (slide * spin);
  return {wrench(twist), {-near.force * (moment_share * turn), near.moment * (force_share * turn)}};
}

RadialPoint Superellipse::along(UnitWrench direction) const noexcept {
  const double x = direction.force / force_max_;
  const double y = direction.moment / moment_max_;
  const double ratio = std::min(x, y) / std::max(x, y);
  const double length = std::max(x, y) * unit_length(ratio);
  const double normal = std::pow(ratio, exponent_ - 1.0);
  return {{direction.force / length, direction.moment / length},
          x >= y ? SlipTwist{1.0 / force_max_, normal / moment_max_} : SlipTwist{normal / force_max_, 1.0 / moment_max_}};
}

double Superellipse::gauge(UnitWrench wrench) const noexcept {
  return symmetric_gauge(force_max_, moment_max_, wrench, [this](double ratio) { return unit_length(ratio); });
}

Quartic::Quartic(double force_max, double moment_max, double kappa) : force_max_(force_max), moment_max_(moment_max), kappa_(kappa) {
  check_intercepts(force_max, moment_max);
  if (!(kappa >= 0.0 && kappa <= 6.0)) throw out_of_range("kappa", kappa, "1", "0 <= kappa <= 6");
}

UnitWrench Quartic::wrench(SlipTwist twist) const noexcept {
  if (twist.is_zero()) return {};
  twist = twist.magnitudes();
  const double p = force_max_ * twist.slide;
  const double q = moment_max_ * twist.spin;
  const double ratio = ratio_of(std::min(p, q) / std::max(p, q));
  const double larger = 1.0 / unit_length(ratio);
  return between_intercepts(force_max_, moment_max_, p >= q, larger, ratio);
}

SlopedPoint Quartic::point(SlipTwist twist) const noexcept {
  const double total = twist.slide + twist.spin;
  const double p = force_max_ * (twist.slide / total);
  const double q = moment_max_ * (twist.spin / total);
  const bool sliding = p >= q;
  const double greater = std::max(p, q);
  const double ratio = ratio_of(std::min(p, q) / greater);
  const double square = ratio * ratio;
  const double larger = 1.0 / unit_length(ratio);
  // dt/dr = (2κ + (12 − κ²)r² + 2κr⁴)/(2 + κr²)², written so that nothing cancels towards κ = 6, r = 1.
  const double gap = (1.0 - ratio) * (1.0 + ratio);
  const double stiff = 2.0 * kappa_ * gap * gap + (6.0 - kappa_) * (2.0 + kappa_) * square;
  const double denominator = 2.0 + kappa_ * square;
  const double rate = denominator * denominator / std::max(stiff, flattest);
  // d(1, r)·larger/dr, with length⁴ = 1 + κr² + r⁴.
  const double quarter = larger * larger * larger * larger * larger;
  const double larger_rate = -quarter * ratio * (0.5 * kappa_ + square);
  const double smaller_rate = quarter * (1.0 + 0.5 * kappa_ * square);
  // t = Bu/(A(1−u)) or its inverse: |dt/du| = AB/greater².
  const double turn = rate * (force_max_ * moment_max_) / (greater * greater);
  if (sliding) {
    return {{force_max_ * larger, moment_max_ * (ratio * larger)},
            {force_max_ * (larger_rate * turn), moment_max_ * (smaller_rate * turn)}};
  }
  return {{force_max_ * (ratio * larger), moment_max_ * larger},
          {-force_max_ * (smaller_rate * turn), -moment_max_ * (larger_rate * turn)}};
}

RadialPoint Quartic::along(UnitWrench direction) const noexcept {
  const double x = direction.force / force_max_;
  const double y = direction.moment / moment_max_;
  const double ratio = std::min(x, y) / std::max(x, y);
  const double square = ratio * ratio;
  const double length = std::max(x, y) * unit_length(ratio);
  const double major = 2.0 + kappa_ * square;
  const double minor = ratio * (2.0 * square + kappa_);
  return {{direction.force / length, direction.moment / length},
          x >= y ? SlipTwist{major / force_max_, minor / moment_max_} : SlipTwist{minor / force_max_, major / moment_max_}};
}

double Quartic::gauge(UnitWrench wrench) const noexcept {
  return symmetric_gauge(force_max_, moment_max_, wrench, [this](double ratio) { return unit_length(ratio); });
}

double Quartic::ratio_of(double t) const noexcept {
  const double centre = kappa_ * t / 6.0;
  const double third_p = kappa_ / 6.0 * (1.0 - centre * t);
  const double half_q = 0.5 * t * (1.0 - kappa_ * (kappa_ / 12.0) + kappa_ * centre * centre / 3.0);
  const double size = std::fabs(half_q);
  // hypot: the squares of a small t would underflow.
  const double u = std::cbrt(size + std::hypot(size, third_p * std::sqrt(third_p)));
  if (u == 0.0) return centre;
  const double v = third_p / u;
  const double z = 2.0 * half_q / (u * u + third_p + v * v);
  return std::clamp(centre + z, 0.0, 1.0);
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
      throw std::invalid_argument("vertex " + std::to_string(i + 1) + ": expected force not above and moment not below those of vertex " +
                                  std::to_string(i));
    }
    if (i == 0) continue;
    const SlipTwist before = face_normal(i - 1);
    if (!(before.slide * here.spin > before.spin * here.slide)) {
      throw std::invalid_argument("vertex " + std::to_string(i) + " is not a convex corner: expected a left turn at every vertex");
    }
  }
}

}  // namespace limitcurve
