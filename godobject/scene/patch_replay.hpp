// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/patch_finger.hpp"
#include "godobject/replay.hpp"

namespace limitcurve::godobject {

/// `Replay` with PatchFingers, on a body that is fixed or has a prescribed motion; not on a free body.
class PatchReplay {
 public:
  /// Does not use the options law, curve, projection and tolerance. Throws std::invalid_argument for a free body, and like Replay.
  PatchReplay(const Patch& patch, const ReplayOptions& options, double point_radius);

  void step(double time, std::span<const DevicePose> fingers, const BodyPose& body = {}) noexcept;
  [[nodiscard]] std::span<const SceneContact> contacts() const noexcept { return contacts_; }

 private:
  AnySurface surface_;
  BodyState body_;
  std::vector<PatchFinger> fingers_;
  std::vector<SceneContact> contacts_;
  BodyMotion motion_;
  double last_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace limitcurve::godobject
