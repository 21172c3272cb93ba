// SPDX-License-Identifier: MIT
#include "godobject/scene/patch_replay.hpp"

#include "godobject/scene/scene_contact.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace limitcurve::godobject {

namespace {

const ReplayOptions& checked(const ReplayOptions& options) {
  if (options.motion == BodyMotion::free)
    throw std::invalid_argument("body: free, expected fixed or trace (a patch needs a body that fingers do not move)");
  if (!(options.fingers >= 1 && options.fingers <= Replay::most_fingers)) {
    throw std::invalid_argument("fingers = " + std::to_string(options.fingers) + ": expected 1 to " + std::to_string(Replay::most_fingers));
  }
  return options;
}

}  // namespace

PatchReplay::PatchReplay(const Patch& patch, const ReplayOptions& options, double point_radius)
    : surface_(checked(options).surface),
      fingers_(options.fingers, PatchFinger(patch, options.finger, point_radius)),
      contacts_(options.fingers),
      motion_(options.motion) {}

void PatchReplay::step(double time, std::span<const DevicePose> fingers, const BodyPose& body) noexcept {
  const bool in_time = time >= last_time_ && time <= std::numeric_limits<double>::max();
  const bool moves = motion_ == BodyMotion::prescribed;
  const bool begins = last_time_ == -std::numeric_limits<double>::infinity();
  const bool usable = in_time && (!moves || is_pose(body));
  const double time_step = usable && !begins ? time - last_time_ : 0.0;
  if (usable) {
    last_time_ = time;
    if (moves) {
      body_.position = body.position;
      body_.orientation = body.orientation;
    }
  }
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    if (usable && i >= fingers.size()) {
      fingers_[i].reset();
    } else {
      // Every finger refuses an invalid row.
      DevicePose device{Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())};
      if (usable) device = {body_.to_body(fingers[i].position), body_.orientation.conjugate() * fingers[i].orientation, fingers[i].twist};
      fingers_[i].update(surface_, device, time_step);
    }
    describe(contacts_[i], fingers_[i], fingers_[i].state().finger, body_);
  }
}

}  // namespace limitcurve::godobject
