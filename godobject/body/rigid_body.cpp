// SPDX-License-Identifier: MIT
#include "godobject/body/rigid_body.hpp"

#include "limitcurve/internal/number.hpp"

#include <cmath>
#include <limits>

namespace limitcurve::godobject {

namespace {

void require_positive(std::string_view name, double value, std::string_view unit) {
  if (!(value > 0.0 && value <= std::numeric_limits<double>::max()))
    throw out_of_range(name, value, unit, "> 0 and finite");
}

}  // namespace

BodyParameters BodyParameters::block(double mass, const Eigen::Vector3d& edges) {
  require_positive("mass", mass, "kg");
  for (const double edge : edges) require_positive("edge", edge, "m");
  const Eigen::Vector3d squares = edges.cwiseProduct(edges);
  BodyParameters result;
  result.mass = mass;
  result.inertia = mass / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  return result;
}

BodyParameters BodyParameters::ball(double mass, double radius) {
  return capsule(mass, radius, 0.0);
}

BodyParameters BodyParameters::cylinder(double mass, double radius, double length) {
  require_positive("mass", mass, "kg");
  require_positive("radius", radius, "m");
  require_positive("length", length, "m");
  const double across = mass * (radius * radius / 4.0 + length * length / 12.0);
  BodyParameters result;
  result.mass = mass;
  result.inertia = {across, across, 0.5 * mass * radius * radius};
  return result;
}

BodyParameters BodyParameters::capsule(double mass, double radius, double length) {
  require_positive("mass", mass, "kg");
  require_positive("radius", radius, "m");
  if (!(length >= 0.0 && length <= std::numeric_limits<double>::max()))
    throw out_of_range("length", length, "m", ">= 0 and finite");
  // A cylinder and two half balls: volumes divided by πr². The centre of mass of a half ball is 3r/8 from its face.
  const double balls = mass * (4.0 / 3.0 * radius) / (4.0 / 3.0 * radius + length);
  const double shaft = mass - balls;
  const double square = radius * radius;
  const double across = shaft * (square / 4.0 + length * length / 12.0) +
                        balls * (0.4 * square + length * length / 4.0 + 0.375 * length * radius);
  BodyParameters result;
  result.mass = mass;
  result.inertia = {across, across, 0.5 * shaft * square + 0.4 * balls * square};
  return result;
}

BodyParameters BodyParameters::planar_block(double mass, const Eigen::Vector3d& edges, double gravity) {
  BodyParameters result = block(mass, edges);
  result.gravity = {0.0, -gravity, 0.0};
  result.free = {true, true, false, false, false, true};
  return result;
}

void BodyParameters::validate() const {
  // So wide that only a wrong unit leaves it, and so narrow that no product in a step overflows.
  const auto check = [](std::string_view name, double value, std::string_view unit, double least, double most) {
    if (!(value >= least && value <= most)) {
      throw out_of_range(name, value, unit, "from " + format_number(least) + " to " + format_number(most));
    }
  };
  check("mass", mass, "kg", 1e-15, 1e15);
  for (const double moment : inertia) check("inertia", moment, "kg m^2", 1e-30, 1e15);
  for (const double component : gravity) check("gravity", component, "m/s^2", -1e15, 1e15);
}

Eigen::Vector3d quarter_turn(const Eigen::Vector3d& angular_velocity, double time) noexcept {
  // To third order: τ(1 + τ²/3).
  const Eigen::Vector3d quarter = angular_velocity * (0.25 * time);
  return quarter * (1.0 + quarter.squaredNorm() / 3.0);
}

Orientation turned(const Orientation& orientation, const Eigen::Vector3d& angular_velocity, double time) noexcept {
  const Eigen::Vector3d tangent = quarter_turn(angular_velocity, time);
  const double square = tangent.squaredNorm();
  const double scale = 1.0 / (1.0 + square);
  Orientation change;
  change.w() = (1.0 - square) * scale;
  change.vec() = tangent * (2.0 * scale);
  return (change * orientation).normalized();
}

double kinetic_energy(const BodyParameters& body, const BodyState& state) noexcept {
  return 0.5 * body.mass * state.velocity.squaredNorm() +
         0.5 * state.angular_velocity.dot(angular_momentum(body, state));
}

double gravity_energy(const BodyParameters& body, const BodyState& state) noexcept {
  return -body.mass * body.gravity.dot(state.position);
}

Eigen::Vector3d angular_momentum(const BodyParameters& body, const BodyState& state) noexcept {
  const Eigen::Vector3d in_body = state.orientation.conjugate() * state.angular_velocity;
  return state.orientation * body.inertia.cwiseProduct(in_body);
}

}  // namespace limitcurve::godobject
