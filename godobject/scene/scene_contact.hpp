// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/replay.hpp"

#include <cmath>

/// Functions that Replay and PatchReplay share.
namespace limitcurve::godobject {

/// Whether a body's pose is valid: within 1e6 m, orientation of unit length.
[[nodiscard]] inline bool is_pose(const BodyPose& pose) noexcept {
  return pose.position.squaredNorm() <= 1e12 && std::fabs(pose.orientation.squaredNorm() - 1.0) <= 1e-6;
}

/// Transforms the output of a finger (SoftFinger or PatchFinger, with the state `state`) from the body's frame to the world. After an
/// invalid sample the held wrench and its normal turn with the body; the position is the last good one.
template <class Finger>
void describe(SceneContact& contact, const Finger& finger, const FingerState& state, const BodyState& body) noexcept {
  contact.state = state.state;
  contact.dissipated += state.slip_work;
  contact.load = state.load;
  contact.force = body.orientation * vector(state.force);
  contact.moment = state.moment;
  if (state.seen) contact.normal = body.orientation * vector(state.normal);
  contact.cor = state.cor;
  contact.centre_of_rotation = finger.centre_of_rotation();
  if (contact.centre_of_rotation.allFinite()) contact.centre_of_rotation = body.to_world(contact.centre_of_rotation);
  if (state.state == ContactState::invalid) return;
  contact.proxy = body.to_world(vector(state.proxy));
  contact.angle = state.angle;
  contact.depth = state.depth;
  contact.margin = finger.margin();
  contact.load_to_hold = finger.load_to_hold();
}

}  // namespace limitcurve::godobject
