// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_state.hpp"
#include "godobject/stretch.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace limitcurve::godobject {

/// What a step gives. Aligned and in this order so that a step writes two numbers at a time (Stretch::store), and none across cache lines.
struct alignas(16) FingerOutput {
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();        ///< x_p [m]; while free, the finger itself
  double angle = 0.0;                                     ///< α_p [rad] in the frame of the device's twist; while free, the twist
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user, k_l (x_p − x_g) [N], tangential
  double moment = 0.0;                                    ///< friction on the user about the normal, k_r (α_p − α_g) [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip, from the contact centre [m]; NaN unless it slips
  double slip_work = 0.0;                                 ///< dissipated in this step [J], ≥ 0
  double depth = 0.0;                                     ///< d [m]
  double load = 0.0;                                      ///< P = k_l d [N], 0 while free
  ContactState state = ContactState::free;
};

/// All that a finger remembers from one step to the next. A plain value: copy, save and restore it.
struct FingerState {
  FingerOutput output;
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();     ///< x_g of the last good step [m]
  double goal_angle = 0.0;                            ///< α_g of the last good step [rad], unwrapped
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward normal there
  double device_angle = 0.0;                          ///< the device's twist as it was given [rad]
  double start = -1.0;                                ///< place of the last slip, or 0; < 0: it sticks
  double trend = 0.0;                                 ///< how far that has moved since the slip before
  /// Contact [m] and twist [rad] when all was last asked, if one that stays near (Home) need not be asked again whether it
  /// touches, leaps or turns through a jump; else the twist is not a number.
  Eigen::Vector3d home = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  double home_twist = std::numeric_limits<double>::quiet_NaN();
  double turn = 0.0;        ///< what unwrapping has added to the device's twist [rad], a multiple of 2π
  std::uint32_t piece = 0;  ///< of the boundary, where the last slip was found
  bool touching = false;
  /// Without a home: where the finger was when last seen, refused or not [m]; not a number before the first step.
  Eigen::Vector3d seen = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());

  [[nodiscard]] bool has_home() const noexcept { return home_twist == home_twist; }
  /// Where the finger was when last seen [m]; a finger that has a home has not been refused.
  [[nodiscard]] Eigen::Vector3d last_seen() const noexcept { return has_home() ? goal - normal * output.depth : seen; }
  /// The next step asks all.
  void leave_home() noexcept {
    seen = last_seen();
    home_twist = std::numeric_limits<double>::quiet_NaN();
  }

  /// By how much the springs are drawn after the step: x_p − x_g and α_p − α_g.
  [[nodiscard]] Stretch stretch() const noexcept { return (Stretch::load(&output) - Stretch::load(&goal)).along(Stretch::at(normal, 0.0)); }
};

// An angle follows its place, as Stretch reads and writes them.
static_assert(offsetof(FingerOutput, angle) == sizeof(Eigen::Vector3d));
static_assert(offsetof(FingerOutput, moment) == offsetof(FingerOutput, force) + sizeof(Eigen::Vector3d));
static_assert(offsetof(FingerState, goal_angle) == offsetof(FingerState, goal) + sizeof(Eigen::Vector3d));
static_assert(offsetof(FingerState, home_twist) == offsetof(FingerState, home) + sizeof(Eigen::Vector3d));

}  // namespace limitcurve::godobject
