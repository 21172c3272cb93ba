// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_limits.hpp"
#include "godobject/surface.hpp"

namespace limitcurve::godobject {

/// A soft-finger god-object on one surface: steps a–c of the paper, corrected (README, "Corrections to the paper").
/// The limit curve decides how force and moment limit each other, the projection where a slipping proxy comes to lie.
///
///     SoftFinger finger(Table::build(hertz(), 1e-6), {.mu = 0.6, .damping = 2.0});
///     const FingerOutput output = finger.update(surface, device_pose, 1e-3);  // every millisecond
///     device.send(output.normal * output.load + output.force, output.moment);
///
/// Distinct fingers on distinct threads need no lock. No step allocates, throws or takes a lock.
class SoftFinger {
 public:
  /// Throws std::invalid_argument naming parameter, value, unit and range. A box goes with the closest point only.
  SoftFinger(FingerCurve curve, const FingerParameters& parameters, Projection projection = Projection::closest_point);

  /// One step: the device's pose in the frame of the surface that it may touch. What the device turns about the contact normal is the twist:
  /// the spin of its orientation (`Spin`), and `DevicePose::twist` beside it.
  /// With a time step [s] > 0 since the last update the dampers act too, within the limit: the wrench that friction bounds
  /// is that of springs and dampers together, and so is what the user feels. They do not act in the first good sample, nor in the first
  /// one after invalid ones, from where no velocity is known.
  /// Input that is not finite, an orientation or a normal that is not of unit length, a move beyond `max_displacement` or a time step < 0
  /// gives the state `invalid`: the last good output is held, fades if that lasts (`fault_decay`), and the proxy, and what the
  /// surface remembers, stay.
  FingerOutput update(const AnySurface& surface, const DevicePose& device, double time_step = 0.0) noexcept;
  /// The same with the contact found by other code, and the device's twist α_s [rad] about the normal. The twist may
  /// wrap around at any multiple of 2π: a jump of more than π between steps is taken for a turn of the other sense.
  FingerOutput update(const Contact& contact, double device_twist, double time_step = 0.0) noexcept;

  /// What `update` would give, without remembering it.
  [[nodiscard]] FingerOutput preview(const AnySurface& surface, const DevicePose& device, double time_step = 0.0) const noexcept;
  [[nodiscard]] FingerOutput preview(const Contact& contact, double device_twist, double time_step = 0.0) const noexcept;

  [[nodiscard]] FingerOutput output() const noexcept { return state_.output(); }
  [[nodiscard]] const FingerState& state() const& noexcept { return state_; }
  void restore(const FingerState& state) noexcept { state_ = state; }
  void reset() noexcept { state_ = {}; }
  /// The next search begins as a finger's first does.
  void forget_warm_start() noexcept { state_.friction.parameter = state_.friction.rate = 0.0; }

  [[nodiscard]] const FingerCurve& curve() const& noexcept { return curve_; }
  [[nodiscard]] Projection projection() const noexcept { return projection_; }
  [[nodiscard]] const FingerParameters& parameters() const& noexcept { return parameters_; }
  // Of a finger that is gone at the end of the line there is nothing to refer to.
  void state() const&& = delete;
  void curve() const&& = delete;
  void parameters() const&& = delete;

  /// How far the finger is from slipping, as a fraction: 1 without friction, 0 on the limit; 0 while it slips, 1 while free.
  [[nodiscard]] double margin() const noexcept;
  /// The least load [N] under which the contact would bear its present friction without slipping: the grip needed to hold.
  [[nodiscard]] double load_to_hold() const noexcept;
  /// Where the slip's centre of rotation is, in the surface's frame [m]; infinite for pure sliding, NaN unless it slips.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept { return state_.centre_of_rotation(); }
  /// The energy in the springs [J]: ½ k_l |x_p − x_h|² + ½ k_r (α_p − α_g)², 0 while free. Slip only takes from it.
  [[nodiscard]] double spring_energy() const noexcept;

 private:
  void advance(FingerState& state, const Contact& contact, const Spin& spin, double device_twist, double time_step) const noexcept;

  FingerCurve curve_;
  FingerParameters parameters_;
  Projection projection_;
  ContactLimits limits_;
  FingerState state_;
};

}  // namespace limitcurve::godobject
