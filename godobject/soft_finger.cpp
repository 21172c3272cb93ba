// SPDX-License-Identifier: MIT
#include "godobject/soft_finger.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limitcurve::godobject {

using Eigen::Vector3d;

SoftFinger::SoftFinger(FingerCurve curve, const FingerParameters& parameters, Projection projection)
    : curve_(std::move(curve)), parameters_(parameters), projection_(projection), limits_(parameters, curve_.moment_ratio()) {
  check_projection(curve_, projection);
}

FingerOutput SoftFinger::update(const AnySurface& surface, const DevicePose& device, double time_step) noexcept {
  Spin spin;
  const Contact contact = sense(surface, device, state_, spin);
  advance(state_, contact, spin, device.twist, time_step);
  return state_.output();
}

FingerOutput SoftFinger::update(const Contact& contact, double device_twist, double time_step) noexcept {
  advance(state_, contact, state_.spin, device_twist, time_step);
  return state_.output();
}

FingerOutput SoftFinger::preview(const AnySurface& surface, const DevicePose& device, double time_step) const noexcept {
  FingerState state = state_;
  Spin spin;
  const Contact contact = sense(surface, device, state, spin);
  advance(state, contact, spin, device.twist, time_step);
  return state.output();
}

FingerOutput SoftFinger::preview(const Contact& contact, double device_twist, double time_step) const noexcept {
  FingerState state = state_;
  advance(state, contact, state.spin, device_twist, time_step);
  return state.output();
}

void SoftFinger::advance(FingerState& state, const Contact& contact, const Spin& spin, double device_twist,
                         double time_step) const noexcept {
  // A velocity is known only from one good sample to the next.
  const bool has_velocity = state.seen && state.state != ContactState::invalid && time_step >= shortest_time_step;
  if (!is_plausible(state, parameters_, contact, device_twist, time_step)) return fade(state, parameters_.fault_decay);
  if (!(contact.depth > 0.0)) return release(state, contact, spin, device_twist);
  if (!state.in_contact) touch_down(state, contact, spin, device_twist);

  // a. The trial deflection (eq. 7): of the spring between proxy and finger, less where dampers let it rest.
  const Vector3d& n = contact.normal;
  const Springs springs(parameters_, has_velocity ? time_step : 0.0);
  Vector3d rest = Vector3d::Zero();
  if (springs.rest_share > 0.0) {
    const Deflection before = state.deflection();
    rest = (before.tangential + vector(state.normal) * before.normal) * springs.rest_share;
  }
  const double normal_rest = n.dot(rest);
  const Vector3d tangential_rest = rest - n * normal_rest;
  const double twist_rest = (state.angle - state.goal_angle) * springs.twist_rest_share;
  const double damper = springs.stiffness - parameters_.stiffness;
  state.limit_load = std::max(parameters_.stiffness * contact.depth + damper * (contact.depth - state.depth), 0.0);
  state.depth = contact.depth;
  state.goal = numbers(contact.point);
  state.normal = numbers(n);
  state.contact = contact.memory;
  state.spin = spin;
  state.goal_angle = unwrap(state, device_twist) + spin.angle;
  Vector3d last = vector(state.proxy);
  Deflection now = deflection(last, contact);
  const bool is_left_behind = bring_round(last, now, contact);
  const Vector3d trial = now.tangential - tangential_rest;
  const double twist_trial = (state.angle - state.goal_angle) - twist_rest;

  // b. What part of it the limit curve lets the springs keep (eqs. 21–23).
  const double r = trial.norm();
  const double rho = std::fabs(twist_trial);
  const FrictionTrial<double> wrench{springs.stiffness * r, springs.twist_stiffness * rho};
  const FrictionLimits<double> limits = limits_.at<double>(state.limit_load, springs.stiffness / springs.twist_stiffness);
  const bool was_sliding = state.friction.slides;
  const FrictionResult<double> friction = apply_friction(curve_.view(), projection_, limits, wrench, state.friction);
  const Vector3d kept = trial * friction.force_ratio;
  const double twist_kept = twist_trial * friction.moment_ratio;

  // The proxy follows. What did not slide is not touched, not even by rounding; and a slip that its rounding swallows is none.
  Deflection after = now;
  Vector3d proxy = last;
  double along_slope = 1.0;
  if (friction.force_ratio < 1.0) {
    after.tangential = tangential_rest + kept;
    const double rise = rise_after_slip(now, after.tangential, contact.depth);
    after.normal = contact.depth + rise;
    along_slope = share_along_slope(after, rise);
    proxy = contact.point + after.tangential + n * rise;
  }
  const double angle = friction.moment_ratio < 1.0 ? state.goal_angle + twist_rest + twist_kept : state.angle;
  const bool slips = is_left_behind || (friction.slips && (proxy != last || angle != state.angle));
  if (slips) state.proxy = numbers(proxy);
  if (slips || !limits.has_torsion) state.angle = angle;
  state.friction.slides = state.friction.slides && (slips || was_sliding);

  // c. Force and moment on the user.
  state.state = slips ? ContactState::slip : ContactState::stick;
  state.load = springs.stiffness * ((slips ? after.normal : now.normal) - normal_rest);
  if (damper > 0.0) state.load = std::max(state.load, 0.0);  // dampers do not pull
  state.force = numbers(kept * springs.stiffness);
  state.moment = twist_kept * springs.twist_stiffness;
  // A proxy that is brought round slides, and does not turn.
  state.cor = friction.slips && slips ? friction.cor : std::numeric_limits<double>::infinity();
  if (!slips) state.cor = std::numeric_limits<double>::quiet_NaN();
  state.slip_work = slips ? along_slope * wrench.force * friction.force_ratio * (r * (1.0 - friction.force_ratio)) +
                                wrench.moment * friction.moment_ratio * (rho * (1.0 - friction.moment_ratio))
                          : 0.0;
}

double SoftFinger::margin() const noexcept {
  return limits_.margin(curve_, parameters_, state_);
}

double SoftFinger::load_to_hold() const noexcept {
  return limits_.load_to_hold(curve_, vector(state_.force).norm(), std::fabs(state_.moment));
}

}  // namespace limitcurve::godobject
