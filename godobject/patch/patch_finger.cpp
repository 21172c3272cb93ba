// SPDX-License-Identifier: MIT
#include "godobject/patch_finger.hpp"

#include "godobject/contact_limits.hpp"
#include "godobject/kernel/finger_step.hpp"
#include "godobject/patch/patch_projection.hpp"
#include "limitcurve/number.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace limitcurve::godobject {

namespace {

using Eigen::Vector3d;

/// The tangent part of the last axis; on a new contact the world's x axis, turned from z to the normal.
Vector3d transported(const Vector3d& axis, const Vector3d& normal) noexcept {
  const Vector3d tangent = axis - normal * normal.dot(axis);
  const double length = tangent.norm();
  if (length > 0.1) return tangent / length;
  return Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), normal) * Vector3d::UnitX();
}

/// The patch's axes in the tangent plane.
struct Axes {
  Vector3d x;
  Vector3d y;

  Axes(const Vector3d& axis, const Vector3d& normal, double angle) noexcept {
    const Vector3d aside = normal.cross(axis);
    x = axis * std::cos(angle) + aside * std::sin(angle);
    y = normal.cross(x);
  }
};

/// The axes in the last friction step, before its slip turned the patch.
Axes last_axes(const PatchFingerState& state) noexcept {
  return {vector(state.axis), vector(state.finger.normal), state.finger.angle + state.slip.omega};
}

Patch drivable(const Patch& patch, double point_radius) {
  const double least = 1e-3 * patch.moment_ratio();
  if (point_radius == 0.0 && least == 0.0) {
    throw std::invalid_argument("point_radius = 0 m: all load of the patch is on one point, which has no friction moment; expected > 0");
  }
  if (point_radius != 0.0 && !(point_radius >= least && point_radius <= 1e15)) {
    throw out_of_range("point_radius", point_radius, "m", ">= 1e-3 of the patch's m0, " + format_number(least));
  }
  return patch.smoothed(point_radius == 0.0 ? least : point_radius);
}

}  // namespace

PatchFinger::PatchFinger(const Patch& patch, const FingerParameters& parameters, double point_radius) : parameters_(parameters) {
  if (parameters.moment_coefficient) {
    throw out_of_range("moment_coefficient", *parameters.moment_coefficient, "m", "absent with a patch, which has its own moments");
  }
  // ContactLimits checks springs, dampers and coefficients.
  static_cast<void>(ContactLimits(parameters, 1.0));
  const double share = parameters.mu > 0.0 ? parameters.mu_dynamic.value_or(parameters.mu) / parameters.mu : 1.0;
  rest_share_ = rest_share(share, parameters.rest_margin);
  projector_ = std::make_shared<PatchProjector>(drivable(patch, point_radius));
}

const Patch& PatchFinger::patch() const noexcept {
  return projector_->patch();
}

FingerOutput PatchFinger::update(const AnySurface& surface, const DevicePose& device, double time_step) noexcept {
  Spin spin;
  const Contact contact = sense(surface, device, state_.finger, spin);
  advance(contact, spin, device.twist, time_step);
  return output();
}

FingerOutput PatchFinger::update(const Contact& contact, double device_twist, double time_step) noexcept {
  advance(contact, state_.finger.spin, device_twist, time_step);
  return output();
}

void PatchFinger::advance(const Contact& contact, const Spin& spin, double device_twist, double time_step) noexcept {
  FingerState& state = state_.finger;
  // A velocity needs two good samples in succession.
  const bool has_velocity = state.seen && state.state != ContactState::invalid && time_step >= shortest_time_step;
  if (!is_plausible(state, parameters_, contact, device_twist, time_step)) return fade(state, parameters_.fault_decay);
  if (!(contact.depth > 0.0)) {
    state_.axis = {};
    state_.slip = {};
    return release(state, contact, spin, device_twist);
  }
  if (!state.in_contact) touch_down(state, contact, spin, device_twist);

  // a. The trial deflection, and the patch's axes on the present normal.
  const TrialDeflection trial = take_sample(state, parameters_, contact, spin, device_twist, has_velocity ? time_step : 0.0);
  const Vector3d axis = transported(vector(state_.axis), contact.normal);
  state_.axis = numbers(axis);
  const Axes axes(axis, contact.normal, state.angle);

  // b. Friction: the part of it that the limit surface allows, in the patch's axes.
  const double mu_dynamic = parameters_.mu_dynamic.value_or(parameters_.mu);
  const double stiffness = trial.springs.stiffness;
  const double twist_stiffness = trial.springs.twist_stiffness;
  const PatchWrench wrench{stiffness * axes.x.dot(trial.tangential), stiffness * axes.y.dot(trial.tangential),
                           twist_stiffness * trial.twist};
  const auto project = [&](double mu) -> PatchProjection {
    const double limit = mu * state.limit_load;
    if (limit > 0.0) return projector_->project(wrench, limit, stiffness, std::sqrt(twist_stiffness / stiffness), state_.slip);
    const PatchTwist all{wrench.fx / stiffness, wrench.fy / stiffness, trial.twist};
    return {true, {}, all};
  };
  // A contact at rest holds within the static limit; one that slides comes to rest within a share of the dynamic one.
  const bool was_sliding = state.friction.slides;
  PatchProjection friction = project(was_sliding ? mu_dynamic : parameters_.mu);
  if (friction.slips && !was_sliding && mu_dynamic < parameters_.mu) friction = project(mu_dynamic);

  // The proxy follows. A component without slip keeps its bits; a slip below the rounding of the position counts as stick.
  const Vector3d kept =
      friction.slips ? Vector3d((axes.x * friction.wrench.fx + axes.y * friction.wrench.fy) / stiffness) : trial.tangential;
  const double twist_kept = friction.slips ? friction.wrench.moment / twist_stiffness : trial.twist;
  const Landing landing = friction.slips ? follow(trial, contact, kept) : Landing{trial.proxy, trial.spring.normal};
  const double angle = friction.slips ? state.goal_angle + trial.twist_rest + twist_kept : state.angle;
  const bool slips = trial.is_brought_round || (friction.slips && (landing.proxy != trial.proxy || angle != state.angle));
  if (slips) {
    state.proxy = numbers(landing.proxy);
    state.angle = angle;
  }
  const double dynamic_limit = mu_dynamic * state.limit_load;
  const bool lingers = was_sliding && !slips && rest_share_ < 1.0 && !(projector_->gauge(wrench) < rest_share_ * dynamic_limit);
  state.friction.slides = slips || lingers;
  state_.slip = slips ? friction.slip : PatchTwist{};

  // c. Force and moment on the user.
  const auto& [sx, sy, turn] = friction.slip;
  state.state = slips ? ContactState::slip : ContactState::stick;
  state.load = trial.load(slips ? landing.normal : trial.spring.normal);
  state.force = numbers(Vector3d(kept * stiffness));
  state.moment = twist_kept * twist_stiffness;
  state.trial_force = stiffness * trial.tangential.norm();
  state.trial_moment = std::fabs(wrench.moment);
  constexpr double inf = std::numeric_limits<double>::infinity();
  const double slide = std::hypot(sx, sy);
  state.cor = !slips                                  ? std::numeric_limits<double>::quiet_NaN()
              : turn != 0.0                           ? slide / std::fabs(turn)
              : slide > 0.0 || trial.is_brought_round ? inf
                                                      : 0.0;
  const double work = landing.along_slope * (friction.wrench.fx * sx + friction.wrench.fy * sy) + friction.wrench.moment * turn;
  state.slip_work = slips ? std::max(work, 0.0) : 0.0;
}

double PatchFinger::margin() const noexcept {
  const FingerState& state = state_.finger;
  if (!state.in_contact) return 1.0;
  if (state.state == ContactState::slip) return 0.0;
  const double needed = load_to_hold();  // for the limit at rest; during sliding the dynamic limit acts
  const double share = state.friction.slides ? parameters_.mu_dynamic.value_or(parameters_.mu) / parameters_.mu : 1.0;
  return needed == 0.0 ? 1.0 : std::clamp(1.0 - needed / (share * state.limit_load), 0.0, 1.0);
}

double PatchFinger::load_to_hold() const noexcept {
  const FingerState& state = state_.finger;
  const Vector3d force = vector(state.force);
  if (!state.in_contact || (force.norm() == 0.0 && state.moment == 0.0)) return 0.0;
  if (parameters_.mu == 0.0) return std::numeric_limits<double>::infinity();
  const Axes axes = last_axes(state_);
  return projector_->gauge({axes.x.dot(force), axes.y.dot(force), state.moment}) / parameters_.mu;
}

Vector3d PatchFinger::centre_of_rotation() const noexcept {
  const FingerState& state = state_.finger;
  if (!(state.cor >= 0.0) || std::isinf(state.cor)) return Vector3d::Constant(state.cor);
  // The proxy moves by −slip: its COR is at n × v/ω from the proxy, the same as for the slip.
  const Vector3d normal = vector(state.normal);
  const Axes axes = last_axes(state_);
  return vector(state.proxy) + normal.cross(axes.x * state_.slip.vx + axes.y * state_.slip.vy) / state_.slip.omega;
}

}  // namespace limitcurve::godobject
