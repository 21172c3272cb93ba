// SPDX-License-Identifier: MIT
#include "godobject/finger.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limitcurve::godobject {

using Eigen::Vector3d;

Deflection deflection(const Vector3d& proxy, const Contact& contact) noexcept {
  const Vector3d apart = proxy - contact.point;
  const double rise = contact.normal.dot(apart);
  const Vector3d tangential = apart - contact.normal * rise;
  return {tangential, contact.depth + rise};
}

bool bring_round(Vector3d& proxy, Deflection& now, const Contact& contact) noexcept {
  if (!(now.normal < 0.0)) return false;
  now.normal = std::min(-now.normal, contact.depth);
  proxy = contact.point + now.tangential + contact.normal * (now.normal - contact.depth);
  return true;
}

double rise_after_slip(const Deflection& before, const Vector3d& tangential, double depth) noexcept {
  const double rise = before.normal - depth;
  const double square_before = before.tangential.squaredNorm();
  const double square = tangential.squaredNorm();
  if (rise == 0.0 || !(square < square_before)) return rise;
  const double longest = std::sqrt(before.normal * before.normal + (square_before - square));
  return std::min(rise * (square / square_before), longest - depth);
}

double share_along_slope(const Deflection& after, double rise) noexcept {
  const double square = after.tangential.squaredNorm();
  return rise != 0.0 && square > 0.0 ? std::max(1.0 + 2.0 * after.normal * rise / square, 0.0) : 1.0;
}

Deflection FingerState::deflection() const noexcept {
  return godobject::deflection(vector(proxy), {vector(goal), vector(normal), depth});
}

Vector3d FingerState::position() const noexcept {
  return vector(goal) - vector(normal) * depth;
}

FingerOutput FingerState::output() const noexcept {
  return {state, vector(proxy), angle, depth, vector(normal), load, vector(force), moment, cor, slip_work};
}

Vector3d FingerState::centre_of_rotation() const noexcept {
  // It is the proxy that slides along −force, and turns against the moment: v = ω n × (x_p − C). The finger is ahead by what the springs give.
  const Vector3d friction_force = vector(force);
  const double size = friction_force.norm();
  if (!(cor > 0.0) || size == 0.0) return vector(proxy) + Vector3d::Constant(0.0 * cor);
  return vector(proxy) - friction_force.cross(vector(normal)) * (std::copysign(cor, moment) / size);
}

Springs::Springs(const FingerParameters& finger, double time_step) noexcept
    : stiffness(finger.stiffness), twist_stiffness(finger.twist_stiffness) {
  if (!(time_step > 0.0) || (finger.damping == 0.0 && finger.twist_damping == 0.0)) return;
  const double damper = finger.damping / time_step;
  const double twist_damper = finger.twist_damping / time_step;
  stiffness += damper;
  twist_stiffness += twist_damper;
  rest_share = damper / stiffness;
  twist_rest_share = twist_damper / twist_stiffness;
}

double Springs::energy(const FingerState& state) const noexcept {
  if (!state.in_contact) return 0.0;
  const Deflection spring = state.deflection();
  const double twist = state.angle - state.goal_angle;
  return 0.5 * stiffness * (spring.normal * spring.normal + spring.tangential.squaredNorm()) + 0.5 * twist_stiffness * twist * twist;
}

double unwrap(FingerState& state, double device_twist) noexcept {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double jump = device_twist - state.device_twist;
  if (std::fabs(jump) > std::numbers::pi) state.turns -= turn * std::round(jump / turn);
  state.device_twist = device_twist;
  return device_twist + state.turns;
}

Contact sense(const AnySurface& surface, const DevicePose& device, const FingerState& state, Spin& spin) noexcept {
  if (!device.position.allFinite() || !(std::fabs(device.orientation.squaredNorm() - 1.0) <= 1e-6)) {
    return {Vector3d::Zero(), Vector3d::UnitZ(), std::numeric_limits<double>::quiet_NaN()};
  }
  const Contact contact = surface.contact(device.position, state.contact);
  spin = state.spin.moved(device.orientation, contact.normal);
  return contact;
}

bool is_plausible(FingerState& state, const FingerParameters& parameters, const Contact& contact, double device_twist,
                  double time_step) noexcept {
  const double square = contact.point.squaredNorm() + contact.depth * contact.depth + device_twist * device_twist;
  const bool is_unit = std::fabs(contact.normal.squaredNorm() - 1.0) <= 1e-6;
  if (!(square <= farthest * farthest) || !is_unit || !(time_step >= 0.0)) return false;
  // Plausible is a finger that is near where it last was good, or near where it was refused last, and the first of all.
  const Vector3d position = contact.point - contact.normal * contact.depth;
  const double limit = parameters.max_displacement * parameters.max_displacement;
  if (!state.seen || (position - state.position()).squaredNorm() <= limit) {
    state.refused = false;
    state.seen = true;
    return true;
  }
  const bool stays = state.refused && (position - vector(state.refused_at)).squaredNorm() <= limit;
  state.refused = !stays;
  state.refused_at = numbers(position);
  return stays;
}

void fade(FingerState& state, double fault_decay) noexcept {
  // A single sample that is lost is nothing that a finger should feel.
  const double kept = state.state == ContactState::invalid ? fault_decay : 1.0;
  state.state = ContactState::invalid;
  state.slip_work = 0.0;
  state.cor = std::numeric_limits<double>::quiet_NaN();
  state.load *= kept;
  state.limit_load *= kept;
  state.moment *= kept;
  for (double& component : state.force) component *= kept;
}

void release(FingerState& state, const Contact& contact, const Spin& spin, double device_twist) noexcept {
  FingerState free;
  free.proxy = numbers(contact.point - contact.normal * contact.depth);
  free.goal = numbers(contact.point);
  free.normal = numbers(contact.normal);
  free.device_twist = device_twist;
  free.angle = free.goal_angle = device_twist + spin.angle;
  free.depth = contact.depth;
  free.seen = true;
  free.spin = spin;
  free.contact = contact.memory;
  state = free;
}

void touch_down(FingerState& state, const Contact& contact, const Spin& spin, double device_twist) noexcept {
  state.in_contact = true;
  state.proxy = state.goal = numbers(contact.point);
  state.normal = numbers(contact.normal);
  state.depth = 0.0;
  state.device_twist = device_twist;
  state.angle = state.goal_angle = device_twist + spin.angle;
  state.turns = 0.0;
  state.friction = {};
}

}  // namespace limitcurve::godobject
