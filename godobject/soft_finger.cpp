// SPDX-License-Identifier: MIT
#include "godobject/soft_finger.hpp"

#include "godobject/kernel/finger_step.hpp"

#include <cmath>
#include <utility>

namespace limitcurve::godobject {

using Eigen::Vector3d;

SoftFinger::SoftFinger(FingerCurve curve, const FingerParameters& parameters, Projection projection)
    : curve_(std::move(curve)), parameters_(parameters), projection_(projection), limits_(parameters, curve_.moment_max()) {
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
  // A velocity needs two good samples in succession.
  const bool has_velocity = state.seen && state.state != ContactState::invalid && time_step >= shortest_time_step;
  if (!is_plausible(state, parameters_, contact, device_twist, time_step)) return fade(state, parameters_.fault_decay);
  if (!(contact.depth > 0.0)) return release(state, contact, spin, device_twist);
  if (!state.in_contact) touch_down(state, contact, spin, device_twist);

  // a. The trial deflection of springs and dampers if the proxy stays (eq. 7).
  const TrialDeflection trial = take_sample(state, parameters_, contact, spin, device_twist, has_velocity ? time_step : 0.0);
  const Springs& springs = trial.springs;

  // b. Friction: the part of the trial deflection that the limit curve allows (eqs. 21–23).
  const double r = trial.tangential.norm();
  const double rho = std::fabs(trial.twist);
  const FrictionTrial<double> wrench{springs.stiffness * r, springs.twist_stiffness * rho};
  const FrictionLimits<double> limits = limits_.at<double>(state.limit_load, springs.stiffness / springs.twist_stiffness);
  const FrictionMemory<double> last = state.friction;
  const FrictionResult<double> friction = apply_friction(curve_.view(), projection_, limits, wrench, state.friction);
  const Vector3d kept = trial.tangential * friction.force_ratio;
  const double twist_kept = trial.twist * friction.moment_ratio;

  // The proxy follows. A component without slip keeps its bits; a slip below the rounding of the position counts as stick.
  const Landing landing = friction.force_ratio < 1.0 ? follow(trial, contact, kept) : Landing{trial.proxy, trial.spring.normal};
  const double angle = friction.moment_ratio < 1.0 ? state.goal_angle + trial.twist_rest + twist_kept : state.angle;
  const bool slid = trial.is_brought_round || landing.proxy != trial.proxy;
  const bool turned = angle != state.angle;
  const bool slips = trial.is_brought_round || (friction.slips && (slid || turned));
  if (slips) state.proxy = numbers(landing.proxy);
  if (slips || !limits.has_torsion) state.angle = angle;
  state.friction.slides = state.friction.slides && (last.slides || (curve_.is_box() ? slid : slips));
  state.friction.turns = state.friction.turns && (last.turns || turned);

  // c. Force and moment on the user.
  state.state = slips ? ContactState::slip : ContactState::stick;
  state.load = trial.load(slips ? landing.normal : trial.spring.normal);
  state.force = numbers(kept * springs.stiffness);
  state.moment = twist_kept * springs.twist_stiffness;
  state.trial_force = wrench.force;
  state.trial_moment = wrench.moment;
  // A proxy moved to the finger's near side slides without a turn: its COR is at infinity.
  state.cor = friction.slips ? friction.cor : std::numeric_limits<double>::infinity();
  if (!slips) state.cor = std::numeric_limits<double>::quiet_NaN();
  state.slip_work = slips ? landing.along_slope * wrench.force * friction.force_ratio * (r * (1.0 - friction.force_ratio)) +
                                wrench.moment * friction.moment_ratio * (rho * (1.0 - friction.moment_ratio))
                          : 0.0;
}

double SoftFinger::spring_energy() const noexcept {
  if (!state_.in_contact) return 0.0;
  const Deflection spring = deflection(state_);
  const double twist = state_.angle - state_.goal_angle;
  return 0.5 * parameters_.stiffness * (spring.normal * spring.normal + spring.tangential.squaredNorm()) +
         0.5 * parameters_.twist_stiffness * twist * twist;
}

double SoftFinger::margin() const noexcept {
  return limits_.margin(curve_, parameters_, state_);
}

double SoftFinger::load_to_hold() const noexcept {
  return limits_.load_to_hold(curve_, vector(state_.force).norm(), std::fabs(state_.moment));
}

}  // namespace limitcurve::godobject
