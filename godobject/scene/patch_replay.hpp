// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/patch_finger.hpp"
#include "godobject/replay.hpp"

namespace limitcurve::godobject {

/// `Replay` with the contact of a patch, on a body that rests or is moved by the trace: nothing that the fingers do moves it.
class PatchReplay {
 public:
  /// Of the options law, curve, projection and tolerance are not used. Throws std::invalid_argument for a body that is free, and as Replay does.
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
