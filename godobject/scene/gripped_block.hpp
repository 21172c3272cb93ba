// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/body/grasp.hpp"
#include "godobject/scene/pivot.hpp"

#include <array>

namespace limitcurve::godobject {

/// The block of the paper's experiment (PivotOptions) between two opposite fingers, which stay at the origin while
/// their load changes.
class GrippedBlock {
 public:
  /// Uses length, height, mass, offset and gravity of the options. Both fingers are copies of `finger`. Throws like
  /// Grasp.
  GrippedBlock(const PivotOptions& options, const SoftFinger& finger);

  /// Begins level and at rest, under a load of each finger [N]: the springs just carry the block's weight. Call it
  /// once.
  void take(double load) noexcept;
  /// One time step [s] > 0 under a load of each finger [N]. Bad ones move nothing, as in Grasp.
  void step(double load, double time_step) noexcept;
  /// Goes on with copies of another finger, which take over the state of the current ones.
  void change_fingers(const SoftFinger& finger);

  [[nodiscard]] const Grasp& grasp() const noexcept { return grasp_; }
  /// The block's angle [rad], counter-clockwise, unwrapped.
  [[nodiscard]] double angle() const noexcept { return angle_; }
  /// Where the first finger touched down, in the block's frame [m].
  [[nodiscard]] const Eigen::Vector3d& grip() const noexcept { return grip_; }

 private:
  [[nodiscard]] std::array<DevicePose, 2> devices() const noexcept;

  Eigen::Vector3d edges_;
  double offset_;
  Grasp grasp_;
  Eigen::Vector3d grip_ = Eigen::Vector3d::Zero();
  double depth_ = 0.0;  // of the fingers [m]
  double angle_ = 0.0;
};

}  // namespace limitcurve::godobject
