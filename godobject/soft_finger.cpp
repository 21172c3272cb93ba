// SPDX-License-Identifier: MIT
#include "godobject/soft_finger.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace limitcurve::godobject {

namespace {

using Eigen::Vector3d;

/// The device's twist without its jumps by whole turns: exactly the device's as long as it does not jump.
double unwrap(FingerState& state, double device_twist) noexcept {
  constexpr double turn = 2.0 * std::numbers::pi;
  const double jump = device_twist - state.device_twist;
  if (std::fabs(jump) > std::numbers::pi) state.turns -= turn * std::round(jump / turn);
  state.device_twist = device_twist;
  return device_twist + state.turns;
}

}  // namespace

SoftFinger::SoftFinger(FingerCurve curve, const FingerParameters& parameters, Projection projection)
    : curve_(std::move(curve)),
      parameters_(parameters),
      projection_(projection),
      limits_(parameters, curve_.moment_ratio()),
      springs_{parameters.stiffness, parameters.twist_stiffness, parameters.stiffness / parameters.twist_stiffness},
      has_dampers_(parameters.damping > 0.0 || parameters.twist_damping > 0.0) {
  check_projection(curve_, projection);
}

FingerOutput SoftFinger::update(const Contact& contact, double device_twist, double time_step) noexcept {
  advance(state_, contact, device_twist, time_step);
  return state_.output();
}

FingerOutput SoftFinger::preview(const Contact& contact, double device_twist, double time_step) const noexcept {
  FingerState state = state_;
  advance(state, contact, device_twist, time_step);
  return state.output();
}

void SoftFinger::advance(FingerState& state, const Contact& contact, double device_twist, double time_step) const noexcept {
  // A velocity is known only from one good sample to the next.
  const bool has_velocity = state.seen && state.state != ContactState::invalid && time_step >= shortest_time_step;
  if (!is_plausible(state, parameters_, contact, device_twist, time_step)) return fade(state, parameters_.fault_decay);
  if (!(contact.depth > 0.0)) return release(state, contact, device_twist);
  if (!state.in_contact) touch_down(state, contact, device_twist);

  // a. The trial deflection (eq. 7).
  const Springs springs = has_dampers_ && has_velocity ? damped(time_step) : springs_;
  Vector3d rest = Vector3d::Zero();
  double twist_rest = 0.0;
  if (has_dampers_) {
    rest = state.deflection() * springs.rest_share;
    twist_rest = (state.angle - state.goal_angle) * springs.twist_rest_share;
  }
  const double damper = springs.stiffness - parameters_.stiffness;
  state.load = std::max(parameters_.stiffness * contact.depth + damper * (contact.depth - state.depth), 0.0);
  state.depth = contact.depth;
  state.goal = numbers(contact.point);
  state.normal = numbers(contact.normal);
  state.goal_angle = unwrap(state, device_twist);
  const Vector3d last = vector(state.proxy);
  const Vector3d apart = last - contact.point;
  const Vector3d trial = apart - contact.normal * contact.normal.dot(apart) - rest;
  const double twist_trial = (state.angle - state.goal_angle) - twist_rest;

  // b. What part of it the limit curve lets the springs keep (eqs. 21–23).
  const double r = trial.norm();
  const double rho = std::fabs(twist_trial);
  const FrictionTrial<double> wrench{springs.stiffness * r, springs.twist_stiffness * rho};
  const FrictionLimits<double> limits = limits_.at<double>(state.load, springs.ratio);
  const FrictionResult<double> friction = apply_friction(curve_.view(), projection_, limits, wrench, state.friction);
  const Vector3d kept = trial * friction.force_ratio;
  const double twist_kept = twist_trial * friction.moment_ratio;

  // The proxy follows. What did not slide is not touched, not even by rounding; and a slip that its rounding swallows is none.
  const Vector3d proxy = friction.force_ratio < 1.0 ? Vector3d(contact.point + rest + kept) : last;
  const double angle = friction.moment_ratio < 1.0 ? state.goal_angle + twist_rest + twist_kept : state.angle;
  const bool slips = friction.slips && (proxy.x() != last.x() || proxy.y() != last.y() || proxy.z() != last.z() || angle != state.angle);
  if (slips) state.proxy = numbers(proxy);
  if (slips || !limits.has_torsion) state.angle = angle;
  if (!slips) state.friction = {};

  // c. Force and moment on the user.
  state.state = slips ? ContactState::slip : ContactState::stick;
  state.force = numbers(kept * springs.stiffness);
  state.moment = twist_kept * springs.twist_stiffness;
  state.cor = slips ? friction.cor : std::numeric_limits<double>::quiet_NaN();
  state.slip_work = slips ? wrench.force * friction.force_ratio * (r * (1.0 - friction.force_ratio)) +
                                wrench.moment * friction.moment_ratio * (rho * (1.0 - friction.moment_ratio))
                          : 0.0;
}

SoftFinger::Springs SoftFinger::damped(double time_step) const noexcept {
  const double damper = parameters_.damping / time_step;
  const double twist_damper = parameters_.twist_damping / time_step;
  const double stiffness = parameters_.stiffness + damper;
  const double twist_stiffness = parameters_.twist_stiffness + twist_damper;
  return {stiffness, twist_stiffness, stiffness / twist_stiffness, damper / stiffness, twist_damper / twist_stiffness};
}

double SoftFinger::margin() const noexcept {
  if (!state_.in_contact) return 1.0;
  if (state_.state == ContactState::slip) return 0.0;
  const FrictionTrial<double> wrench{vector(state_.force).norm(), std::fabs(state_.moment)};
  if (wrench.force == 0.0 && wrench.moment == 0.0) return 1.0;
  const FrictionLimits<double> limits = limits_.at<double>(state_.load, parameters_.stiffness / parameters_.twist_stiffness);
  const UnitTrial<double> trial =
      unit_trial(curve_.view(), state_.friction.slips ? limits.sliding : limits.at_rest, wrench, limits.stiffness_ratio);
  const double used = limits.has_torsion ? gauge(curve_.view(), trial.force, trial.moment, 0.0) : trial.force / curve_.force_max();
  return std::clamp(1.0 - used, 0.0, 1.0);
}

double SoftFinger::load_to_hold() const noexcept {
  return limits_.load_to_hold(curve_, vector(state_.force).norm(), std::fabs(state_.moment));
}

double SoftFinger::spring_energy() const noexcept {
  if (!state_.in_contact) return 0.0;
  const double twist = state_.angle - state_.goal_angle;
  return 0.5 * parameters_.stiffness * (state_.depth * state_.depth + state_.deflection().squaredNorm()) +
         0.5 * parameters_.twist_stiffness * twist * twist;
}

}  // namespace limitcurve::godobject
