// SPDX-License-Identifier: MIT
#include "godobject/kernel/finger_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limitcurve::godobject {

using Eigen::Vector3d;

namespace {

/// The device's twist, unwrapped; equal to the device's bit for bit as long as it does not wrap.
double unwrap(FingerState& state, double device_twist) noexcept {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double jump = device_twist - state.device_twist;
  if (std::fabs(jump) > std::numbers::pi) state.turns -= turn * std::round(jump / turn);
  state.device_twist = device_twist;
  return device_twist + state.turns;
}

/// The deflection of a spring from a contact's finger to a proxy.
Deflection deflection(const Vector3d& proxy, const Contact& contact) noexcept {
  const Vector3d apart = proxy - contact.point;
  const double rise = contact.normal.dot(apart);
  return {apart - contact.normal * rise, contact.depth + rise};
}

}  // namespace

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
  // Plausible: the first sample, a sample near the last good one, or one near the last refused one.
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
  // Hold the output for a single lost sample.
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

Deflection deflection(const FingerState& state) noexcept {
  return deflection(vector(state.proxy), {vector(state.goal), vector(state.normal), state.depth});
}

double TrialDeflection::load(double normal) const noexcept {
  const double force = springs.stiffness * (normal - normal_rest);
  return springs.rest_share > 0.0 ? std::max(force, 0.0) : force;
}

TrialDeflection take_sample(FingerState& state, const FingerParameters& parameters, const Contact& contact, const Spin& spin,
                            double device_twist, double time_step) noexcept {
  const Vector3d& n = contact.normal;
  const Springs springs(parameters, time_step);
  Vector3d rest = Vector3d::Zero();
  if (springs.rest_share > 0.0) {
    const Deflection before = deflection(state);
    rest = (before.tangential + vector(state.normal) * before.normal) * springs.rest_share;
  }
  const double normal_rest = n.dot(rest);
  const Vector3d tangential_rest = rest - n * normal_rest;
  const double twist_rest = (state.angle - state.goal_angle) * springs.twist_rest_share;
  const double damper = springs.stiffness - parameters.stiffness;
  state.limit_load = std::max(parameters.stiffness * contact.depth + damper * (contact.depth - state.depth), 0.0);
  state.depth = contact.depth;
  state.goal = numbers(contact.point);
  state.normal = numbers(n);
  state.contact = contact.memory;
  state.spin = spin;
  state.goal_angle = unwrap(state, device_twist) + spin.angle;

  Vector3d proxy = vector(state.proxy);
  Deflection now = deflection(proxy, contact);
  const bool is_behind = now.normal < 0.0;
  if (is_behind) {
    // Springs do not pull a finger in: move the proxy to the finger's near side, not farther away than it was.
    now.normal = std::min(-now.normal, contact.depth);
    proxy = contact.point + now.tangential + n * (now.normal - contact.depth);
  }
  return {springs,
          now,
          proxy,
          is_behind,
          tangential_rest,
          normal_rest,
          twist_rest,
          now.tangential - tangential_rest,
          (state.angle - state.goal_angle) - twist_rest};
}

Landing follow(const TrialDeflection& trial, const Contact& contact, const Vector3d& kept) noexcept {
  const Vector3d tangential = trial.tangential_rest + kept;
  const double before = trial.spring.tangential.squaredNorm();
  const double square = tangential.squaredNorm();
  double rise = trial.spring.normal - contact.depth;
  if (rise != 0.0 && square < before) {
    const double longest = std::sqrt(trial.spring.normal * trial.spring.normal + (before - square));
    rise = std::min(rise * (square / before), longest - contact.depth);
  }
  const double normal = contact.depth + rise;
  // A deflection whose square is near underflow is none: the slope would be infinite.
  constexpr double none = 1e-200;
  const double along_slope = rise != 0.0 && square > none ? std::max(1.0 + 2.0 * normal * rise / square, 0.0) : 1.0;
  return {contact.point + tangential + contact.normal * rise, normal, along_slope};
}

}  // namespace limitcurve::godobject
