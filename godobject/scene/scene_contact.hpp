// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/scene/replay.hpp"

#include <cmath>

namespace limitcurve::godobject {

/// Whether a body's pose is valid: within `farthest`, orientation of unit length.
[[nodiscard]] inline bool is_pose(const BodyPose& pose) noexcept {
  return pose.position.squaredNorm() <= farthest * farthest && std::fabs(pose.orientation.squaredNorm() - 1.0) <= 1e-6;
}

/// Transforms the output of a finger from the body's frame to the world. After an invalid sample the held wrench and its normal turn with
/// the body; the position is the last good one.
inline void describe(SceneContact& contact, const SoftFinger& finger, const BodyState& body) noexcept {
  const FingerOutput& output = finger.output();
  contact.state = output.state;
  contact.dissipated += output.slip_work;
  contact.load = output.load;
  contact.force = body.orientation * output.force;
  contact.moment = output.moment;
  if (finger.state().faults.seen) contact.normal = body.orientation * output.normal;
  contact.cor = output.cor;
  contact.centre_of_rotation = finger.centre_of_rotation();
  if (contact.centre_of_rotation.allFinite()) contact.centre_of_rotation = body.to_world(contact.centre_of_rotation);
  if (output.state == ContactState::invalid) return;
  contact.proxy = body.to_world(output.proxy);
  contact.angle = output.angle;
  contact.depth = output.depth;
  contact.margin = finger.margin();
  contact.load_to_hold = finger.load_to_hold();
}

}  // namespace limitcurve::godobject
