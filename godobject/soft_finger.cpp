// SPDX-License-Identifier: MIT
#include "godobject/soft_finger.hpp"

#include "godobject/finger/patch_step.hpp"
#include "godobject/finger/sample.hpp"
#include "godobject/finger/springs.hpp"
#include "limitcurve/internal/number.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limitcurve::godobject {

using Eigen::Vector3d;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The step of an invalid sample: the last good output is held, and fades from the second invalid sample on.
const FingerOutput& fade(FingerState& state, double fault_decay, Fault fault) noexcept {
  FingerOutput& output = state.output;
  const double kept = output.state == ContactState::invalid ? fault_decay : 1.0;
  output.state = ContactState::invalid;
  output.fault = fault;
  output.slip_work = 0.0;
  output.cor = nan;
  output.load *= kept;
  output.force *= kept;
  output.moment *= kept;
  state.limit_load *= kept;
  return output;
}

void store(FingerState& state, const FingerSample& sample, const StepInput& input) noexcept {
  state.sample = sample;
  state.spin = input.spin;
  state.contact = input.contact.memory;
}

/// The step without contact: the proxy follows the finger.
const FingerOutput& release(FingerState& state, const FingerSample& sample, const StepInput& input) noexcept {
  const FingerFaults faults = state.faults;
  state = {};
  state.faults = faults;
  store(state, sample, input);
  state.output.proxy = sample.position();
  state.output.angle = sample.angle;
  state.output.depth = input.depth();
  state.output.normal = sample.normal;
  return state.output;
}

/// The first sample in contact, or on what the finger landed on anew: the springs are not loaded. Angles are absolute,
/// not relative to α_0 at touch-down as in the paper; only α_p − α_g matters.
void touch_down(FingerState& state, const FingerSample& sample) noexcept {
  state.in_contact = true;
  state.sample = sample;
  state.sample.depth = 0.0;
  state.output.proxy = sample.goal;
  state.output.angle = sample.angle;
  state.friction = {};
  state.patch = {};
}

/// Only what slides already gets the sliding limit: a slip of what rests stays at the static one.
void keep_static(FrictionLimits<double>& limits, const FrictionMemory<double>& memory, bool is_box) noexcept {
  const bool slides = memory.force_slides;
  const bool turns = is_box ? memory.moment_slides : slides;
  if (slides && turns) return;
  const FrictionLimit<double>& moment = turns ? limits.sliding : limits.sticking;
  const double force =
      slides ? std::max(limits.sliding.force, min_sliding_fraction * limits.sticking.force) : limits.sticking.force;
  limits.sliding = {force, force == moment.force ? moment.radius : moment.force / force * moment.radius};
}

/// Step b of a round contact.
KeptDeflection friction_of_curve(const FingerCurve& curve, Projection projection, const ContactLimits& contact_limits,
                                 const TrialDeflection& trial, bool may_begin,
                                 FrictionMemory<double>& memory) noexcept {
  const Springs& springs = trial.springs;
  const FrictionTrial<double> wrench{springs.stiffness * trial.tangential.norm(),
                                     springs.twist_stiffness * std::fabs(trial.twist)};
  FrictionLimits<double> limits =
      contact_limits.at<double>(trial.limit_load, springs.stiffness / springs.twist_stiffness);
  if (!may_begin) keep_static(limits, memory, curve.is_box());
  const FrictionResult<double> friction = apply_friction(curve.view(), projection, limits, wrench, memory);
  return {trial.tangential * friction.force_fraction,
          trial.twist * friction.moment_fraction,
          friction.force_fraction < 1.0,
          friction.moment_fraction < 1.0,
          friction.slips,
          friction.cor,
          wrench.force,
          wrench.moment};
}

/// The proxy after step b.
struct ProxyUpdate {
  Vector3d proxy;      ///< x_p [m]
  double angle;        ///< α_p [rad]
  double height;       ///< of the spring [m]
  double along_slope;  ///< as in MovedProxy
  bool slid;
  bool turned;
  bool slips;
};

/// The proxy follows. A component without slip keeps its bits; a slip below the rounding of the position counts as
/// stick.
ProxyUpdate move_proxy(const TrialDeflection& trial, const KeptDeflection& kept, const FingerSample& sample,
                       const FingerOutput& last) noexcept {
  const MovedProxy followed =
      kept.force_reduced ? follow(trial, sample, kept.tangential) : MovedProxy{trial.proxy, trial.spring.height};
  const double angle = kept.moment_reduced ? sample.angle + trial.relaxed_twist + kept.twist : last.angle;
  const bool slid = trial.moves_along_normal || (kept.force_reduced && followed.proxy != trial.proxy);
  const bool turned = angle != last.angle;
  const bool slips = trial.moves_along_normal || (kept.slips && (slid || turned));
  const bool turns_freely = kept.moment_reduced && !kept.slips;  // without torsion it turns with the finger
  return {slips ? followed.proxy : last.proxy,
          slips || turns_freely ? angle : last.angle,
          slips ? followed.height : trial.spring.height,
          followed.along_slope,
          slid,
          turned,
          slips};
}

}  // namespace

SoftFinger::SoftFinger(FingerCurve curve, const FingerParameters& parameters, Projection projection)
    : curve_(std::move(curve)),
      parameters_(parameters),
      projection_(projection),
      limits_(parameters, curve_->moment_max()) {
  check_projection(*curve_, projection);
}

const Patch* SoftFinger::patch() const& noexcept {
  return patch_ ? &patch_->patch() : nullptr;
}

const FingerOutput& SoftFinger::update(const AnySurface& surface, const DevicePose& device,
                                       double time_step) & noexcept {
  return advance(state_, sense(surface, device, time_step, state_));
}

const FingerOutput& SoftFinger::update(const Contact& contact, double twist, double time_step) & noexcept {
  return advance(state_, {contact, twist, time_step, state_.spin});
}

const FingerOutput& SoftFinger::update(const Contact& contact, const Orientation& orientation,
                                       double time_step) & noexcept {
  return advance(state_, sense(contact, orientation, time_step, state_));
}

const FingerOutput& SoftFinger::update_under_load(const Vector3d& point, const Vector3d& normal, double load,
                                                  double twist, double time_step, bool landed) & noexcept {
  // A load that is not finite makes a depth that is NaN.
  return advance(state_,
                 {{point, normal, 0.0 * load, {}, landed}, twist, time_step, state_.spin, Fault::none, true, load});
}

const FingerOutput& SoftFinger::update_under_load(const Vector3d& point, const Vector3d& normal, double load,
                                                  const Orientation& orientation, double time_step,
                                                  bool landed) & noexcept {
  return advance(state_, sense({point, normal, 0.0 * load, {}, landed}, orientation, time_step, state_, load));
}

FingerOutput SoftFinger::preview(const AnySurface& surface, const DevicePose& device, double time_step) const noexcept {
  FingerState state = state_;
  return advance(state, sense(surface, device, time_step, state));
}

FingerOutput SoftFinger::preview(const Contact& contact, double twist, double time_step) const noexcept {
  FingerState state = state_;
  return advance(state, {contact, twist, time_step, state.spin});
}

FingerOutput SoftFinger::preview(const Contact& contact, const Orientation& orientation,
                                 double time_step) const noexcept {
  FingerState state = state_;
  return advance(state, sense(contact, orientation, time_step, state));
}

FingerState SoftFinger::try_step(const AnySurface& surface, const DevicePose& device, double time_step) const noexcept {
  FingerState state = state_;
  advance(state, sense(surface, device, time_step, state, false));
  return state;
}

std::optional<BadParameter> SoftFinger::refusal(const FingerParameters& parameters) const noexcept {
  return first_bad(parameters, curve_ ? std::optional(curve_->moment_max()) : std::nullopt);
}

bool SoftFinger::change(const FingerParameters& parameters) noexcept {
  if (refusal(parameters)) return false;
  limits_ = ContactLimits(parameters, curve_ ? std::optional(curve_->moment_max()) : std::nullopt);
  parameters_ = parameters;
  return true;
}

const FingerOutput& SoftFinger::mark_invalid(Fault fault, double time_step) & noexcept {
  if (is_time_step(time_step)) state_.faults.elapsed += time_step;
  return fade(state_, parameters_.fault_decay, fault);
}

const FingerOutput& SoftFinger::advance(FingerState& state, StepInput&& input) const noexcept {
  // A velocity needs two good samples of one kind in succession.
  const bool has_velocity = state.faults.seen && state.output.state != ContactState::invalid &&
                            input.time_step >= shortest_time_step &&
                            std::isnan(state.output.depth) == input.load.has_value();
  const Fault fault = accept(state.faults, input, state.sample, parameters_.max_speed);
  if (fault != Fault::none) {
    if (!input.is_absent()) return fade(state, parameters_.fault_decay, fault);
    const FingerSample last = state.sample;  // the next sample is compared with the last good place
    input.spin = state.spin;
    input.contact.memory = state.contact;
    return release(state, last, input);
  }
  const bool continues = state.in_contact && !input.contact.landed;
  const FingerSample sample = take_sample(state.sample, input, continues);
  if (!input.touches()) return release(state, sample, input);
  if (!continues) touch_down(state, sample);
  if (input.load && continues) {
    carry_with_normal(state.output.proxy, state.held_normal, sample);
  } else {
    state.held_normal = sample.normal;
  }
  FingerOutput& output = state.output;  // until c. that of the last step

  // a. The trial deflection of springs and dampers if the proxy stays (eq. 7).
  const TrialDeflection trial(parameters_, output.proxy, output.angle, state.sample, sample,
                              has_velocity ? input.time_step : 0.0, input.load);

  // b. Friction: the part of the trial deflection that the limit curve, or a patch's limit surface, allows (eqs.
  // 21–23).
  FrictionMemory<double> friction = state.friction;
  PatchMemory next_patch;
  Spin spin = input.spin;
  spin.started = spin.started && input.has_orientation;  // a patch must not turn by an orientation of another step
  const KeptDeflection kept = patch_
                                  ? patch_->friction(limits_, trial, sample.normal, spin, output.angle, state.patch,
                                                     input.may_begin, friction, next_patch)
                                  : friction_of_curve(*curve_, projection_, limits_, trial, input.may_begin, friction);

  const ProxyUpdate moved = move_proxy(trial, kept, sample, output);

  // c. Force and moment on the user.
  output.state = moved.slips ? ContactState::slip : ContactState::stick;
  output.proxy = moved.proxy;
  output.angle = moved.angle;
  output.depth = input.depth();
  output.normal = sample.normal;
  output.load = input.load ? *input.load : trial.load(moved.height);
  output.force = kept.tangential * trial.springs.stiffness;
  output.moment = kept.twist * trial.springs.twist_stiffness;
  output.cor = !moved.slips ? nan : kept.slips ? kept.cor : inf;  // moved along the normal it slides without a turn
  const double work = moved.along_slope * output.force.dot(trial.tangential - kept.tangential) +
                      output.moment * (trial.twist - kept.twist);
  output.slip_work = !moved.slips ? 0.0 : kept.converged ? std::max(work, 0.0) : work;
  output.converged = kept.converged;
  output.fault = Fault::none;
  state.friction = settled(state.friction, friction, curve_ && curve_->is_box(), moved.slips, moved.slid, moved.turned);
  if (patch_)
    state.patch = {next_patch.zero_axis, next_patch.axis, moved.slips ? next_patch.slip : Vector3d(Vector3d::Zero())};
  store(state, sample, input);
  state.limit_load = trial.limit_load;
  state.trial_force = kept.trial_force;
  state.trial_moment = kept.trial_moment;
  return output;
}

Vector3d SoftFinger::centre_of_rotation() const noexcept {
  const FingerOutput& output = state_.output;
  const PatchMemory& patch = state_.patch;
  // The proxy moves by v = ω n × (x_p − C), against friction: C follows from the proxy, not from the finger.
  const bool is_round = !patch_ || patch.slip == Vector3d::Zero();  // a restored state may be a patch's
  const Vector3d slide = is_round
                             ? output.force
                             : Vector3d(patch.axis * patch.slip.x() + output.normal.cross(patch.axis) * patch.slip.y());
  const double turn = is_round ? output.moment : patch.slip.z();
  const double size = slide.norm();
  if (std::isinf(output.cor)) return Vector3d::Constant(inf);
  // Without friction nothing tells on which side of the proxy it is.
  if (!(output.cor > 0.0) || size == 0.0)
    return output.proxy + Vector3d::Constant(output.cor > 0.0 ? nan : 0.0 * output.cor);
  return output.proxy + output.normal.cross(slide) * (std::copysign(output.cor, turn) / size);
}

double SoftFinger::spring_energy() const noexcept {
  if (!state_.in_contact) return 0.0;
  const Deflection spring(state_.output.proxy, state_.sample);
  const double twist = state_.output.angle - state_.sample.angle;
  return 0.5 * parameters_.stiffness * (spring.height * spring.height + spring.tangential.squaredNorm()) +
         0.5 * parameters_.twist_stiffness * twist * twist;
}

double SoftFinger::margin() const noexcept {
  if (!patch_) return limits_.margin(*curve_, parameters_, state_);
  if (!state_.in_contact) return 1.0;
  if (state_.output.state == ContactState::slip) return 0.0;
  const double needed = patch_->gauge(state_);
  return needed == 0.0
             ? 1.0
             : std::clamp(1.0 - needed / (limits_.mu(state_.friction.force_slides) * state_.limit_load), 0.0, 1.0);
}

double SoftFinger::load_to_hold() const noexcept {
  const FingerOutput& output = state_.output;
  const double needed = patch_ ? patch_->gauge(state_) / limits_.mu(false)
                               : limits_.load_to_hold(*curve_, output.force.norm(), std::fabs(output.moment));
  // The surface's push is no part of the limit's load, but of `load`.
  return needed > 0.0 ? std::max(needed + (output.load - state_.limit_load), 0.0) : 0.0;
}

}  // namespace limitcurve::godobject
