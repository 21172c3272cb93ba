// SPDX-License-Identifier: MIT
#include "godobject/scene/replay.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/pressure_law.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace limitcurve::godobject {

namespace {

/// Transforms the output of a finger from the body's frame to the world. After an invalid sample the held wrench and
/// its normal turn with the body; the position is the last good one.
void describe(SceneContact& contact, const SoftFinger& finger, const BodyState& body) noexcept {
  const FingerOutput output = to_world(body, finger.output());
  contact.state = output.state;
  contact.fault = output.fault;
  contact.dissipated += output.slip_work;
  contact.load = output.load;
  contact.force = output.force;
  contact.moment = output.moment;
  if (finger.state().faults.seen) contact.normal = output.normal;
  contact.cor = output.cor;
  contact.centre_of_rotation = finger.centre_of_rotation();
  if (contact.centre_of_rotation.allFinite()) contact.centre_of_rotation = body.to_world(contact.centre_of_rotation);
  contact.margin = finger.margin();
  contact.load_to_hold = finger.load_to_hold();
  if (output.state == ContactState::invalid) return;
  contact.proxy = output.proxy;
  contact.angle = output.angle;
  contact.depth = output.depth;
}

/// The finger of the options, and the error of its curve. Checks all options first, because a table is expensive.
SoftFinger make_finger(const ReplayOptions& options, double& curve_error) {
  if (!options.law && !options.patch) throw std::invalid_argument("law: none given, expected a pressure law");
  if (!(options.fingers >= 1 && options.fingers <= Replay::most_fingers)) {
    throw std::invalid_argument("fingers = " + std::to_string(options.fingers) + ": expected 1 to " +
                                std::to_string(Replay::most_fingers));
  }
  options.body.validate();
  if (options.patch) return {*options.patch, options.finger, options.point_radius};
  const double moment_ratio = options.law->moment_ratio();
  static_cast<void>(ContactLimits(options.finger, moment_ratio));
  if (options.curve == CurveKind::box) {
    static_cast<void>(SoftFinger(box(1.0, moment_ratio), options.finger, options.projection));
  }
  const FingerCurve curve = make_finger_curve(options.curve, options.law, options.tolerance);
  curve_error = curve.error();
  return {curve, options.finger, options.projection};
}

}  // namespace

Replay::Replay(const ReplayOptions& options)
    : grasp_(options.body, BodyState{}, options.surface,
             std::vector<SoftFinger>(options.fingers, make_finger(options, curve_error_))),
      contacts_(options.fingers),
      motion_(options.motion) {}

double SampleClock::step(double time) noexcept {
  const bool begins = last_ == -std::numeric_limits<double>::infinity();
  double time_step = begins && std::isfinite(time) ? 0.0 : time - last_;
  // After one time stamp far ahead all others are earlier: the second of them goes on from the first.
  if (time >= earlier_ && time_step < 0.0) time_step = time - earlier_;
  if (is_time_step(time_step)) {
    last_ = time;
    earlier_ = std::numeric_limits<double>::infinity();
  } else if (std::isfinite(time)) {
    earlier_ = time;
  }
  return time_step;
}

void Replay::step(double time, std::span<const DevicePose> fingers, const BodyPose& body) noexcept {
  move(fingers, body, clock_.step(time));
  for (std::size_t i = 0; i < contacts_.size(); ++i) describe(contacts_[i], grasp_.finger(i), grasp_.body());
}

void Replay::move(std::span<const DevicePose> fingers, const BodyPose& body, double time_step) noexcept {
  if (motion_ == BodyMotion::free && time_step >= shortest_time_step && time_step <= longest_step) {
    grasp_.step(fingers, time_step);
    return;
  }
  BodyState state = grasp_.body();
  if (motion_ == BodyMotion::prescribed) static_cast<BodyPose&>(state) = body;
  grasp_.carry(state, fingers, time_step);
}

}  // namespace limitcurve::godobject
