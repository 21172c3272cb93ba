// SPDX-License-Identifier: MIT
#pragma once

#include "contact_limits.hpp"
#include "surface.hpp"

#include <memory>
#include <optional>

namespace limitcurve {
class Patch;
}

namespace limitcurve::godobject {

class PatchStep;
struct StepInput;

/// A soft-finger god-object on one surface: steps a–c of the paper, corrected (docs/paper.md).
/// The limit curve, or the limit surface of a patch, bounds force and moment together; the projection decides how a slipping proxy moves.
///
///     SoftFinger finger(Table::build(hertz()), {.mu = 0.6, .damping = 2.0});
///     const FingerOutput output = finger.update(surface, device_pose, 1e-3);  // every millisecond
///     device.send(output.whole_force(), output.moment_vector());
///
/// Distinct fingers on distinct threads need no lock. A step does not allocate, throw or lock; about 0.1 µs on a plane.
class SoftFinger {
 public:
  /// Throws std::invalid_argument with parameter, value, unit and range. A box requires the closest point.
  SoftFinger(FingerCurve curve, const FingerParameters& parameters, Projection projection = Projection::closest_point);
  /// A finger whose contact is a patch, for contacts that are not round: the limit surface replaces the limit curve, the projection is the
  /// closest point in F_x, F_y and M, and the radius law is not used. For a disc the step equals that of its limit curve to 1e-9.
  ///
  /// The patch is fixed to the finger: its x axis is the tangent part of the device's x axis, q·x̂, turned about the normal by the proxy's
  /// twist against the finger, α_p − α_g, and by `DevicePose::twist`. The device's x axis must not be normal to the surface. Where it is
  /// (tangent part below 1e-6), the patch's last axis is used, projected on to the tangent plane. `update(contact, twist)` has no
  /// orientation and does the same; a contact then begins with the world's x axis, turned by the shortest rotation from z to the normal.
  /// Without an orientation a closed path of the normal turns the patch by its solid angle: 0.8 rad in 100 circles at 0.05 rad. The
  /// contact point is the centre of pressure: springs act there, and moments refer to it.
  ///
  /// Points get a radius ε: |u| becomes √(|u|² + ε²ω²), which changes the limit by less than ε/m₀ of it. Without it a point under the
  /// centre of rotation bears any force up to its limit, and the search has no derivative there. `point_radius` is ε [m], at least 1e-3 m₀;
  /// 0 means that. A step within the hull of pure slides and pure spins does not evaluate the patch; a slip costs 5 to 20 evaluations
  /// (Patch states the cost of one). Throws as above, also for a moment coefficient, because the patch determines the moments.
  SoftFinger(const Patch& patch, const FingerParameters& parameters, double point_radius = 0.0);

  // Moving copies, which is cheap: what was moved from stays what it was.
  SoftFinger(const SoftFinger&) = default;
  SoftFinger& operator=(const SoftFinger&) = default;

  /// One step. `device` is the device's pose in the frame of the surface. Its twist about the contact normal is the spin of its orientation
  /// (`Spin`) plus `DevicePose::twist`.
  /// With a time step [s] > 0 since the last update the dampers act, too: friction bounds the wrench of springs and dampers together, and
  /// so the force on the user. They do not act in the first good sample and in the first one after invalid samples, because the velocity is
  /// not known. The state is `invalid` for input that is not finite or beyond `farthest`, an orientation or a normal that is not of unit
  /// length, a displacement beyond `max_displacement` and a time step that is < 0 or not finite; `FingerOutput::fault` names the reason.
  /// Then the last good output is held, and fades after more invalid samples (`fault_decay`); the proxy and the contact memory stay.
  FingerOutput update(const AnySurface& surface, const DevicePose& device, double time_step = 0.0) noexcept;
  /// One step with a contact that other code found, and the device's twist α_s [rad] about the normal. The twist may wrap around at any
  /// multiple of 2π: a jump of more than π between steps counts as a turn in the other direction.
  FingerOutput update(const Contact& contact, double twist, double time_step = 0.0) noexcept;
  /// The same with the device's orientation in place of a twist, which is its `Spin` about the normals then.
  FingerOutput update(const Contact& contact, const Orientation& orientation, double time_step = 0.0) noexcept;

  /// One step where a physics engine gives the load P [N], and not a depth: friction is bounded at P; the engine pushes apart. `point`: where
  /// the finger is on the surface [m], whose motion friction sees; the outward normal; the twist α_s [rad] about it, or the device's
  /// orientation, all in the surface's frame. Without contact (P ≤ 0) the finger is free; a load that is not finite is a fault. The output has
  /// that load, and no depth: NaN. `landed` as in `Contact`; the rest as in `update`.
  ///
  /// The proxy is a point in space, as in `update`, and its spring acts as far as it lies in the tangent plane. So the force of a stick is
  /// a function of point and normal: no loop of both turns it. This holds while the normal stays within 0.25 rad of one direction, as on a
  /// ball of radius 4 μP/k_l or more; there friction is that of the plane within 0.04 μP. If the normal tilts farther, as on a smaller
  /// ball, the proxy is carried along: friction still reaches its limit, but on the way is off that of the plane by up to 0.3 μP, and a
  /// stick creeps. A circle of the normal at 0.3 rad (0.5 rad) turns its deflection by 0.09 rad (0.6 rad).
  ///
  /// No path gains more energy than a sampled spring does (scene/passivity.hpp). The spring energy has a part along the normal. A finger
  /// may change between both ways of `update` in a contact; in that step dampers do not act.
  FingerOutput update_under_load(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double load, double twist,
                                 double time_step = 0.0, bool landed = false) noexcept;
  FingerOutput update_under_load(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double load, const Orientation& orientation,
                                 double time_step = 0.0, bool landed = false) noexcept;

  /// The result that `update` would have, without a change of the state.
  [[nodiscard]] FingerOutput preview(const AnySurface& surface, const DevicePose& device, double time_step = 0.0) const noexcept;
  [[nodiscard]] FingerOutput preview(const Contact& contact, double twist, double time_step = 0.0) const noexcept;
  [[nodiscard]] FingerOutput preview(const Contact& contact, const Orientation& orientation, double time_step = 0.0) const noexcept;

  /// Other parameters in the loop, as where the finger touches another material. False, and nothing changed, if one is bad (`refusal`). Sets
  /// parameters and limits and nothing else: `output`, proxy, angle and memories keep their bits. The next step has the new springs at the
  /// same deflection, so that load and force scale with k; the energy ½Δk|x|² comes from whoever changes k. Where the limit fell below the
  /// force it slips in that step, at work ≥ 0. `margin`, `load_to_hold` and `spring_energy` use the new parameters at once, with the last
  /// step's wrench and deflection. Does not allocate; nor free, as long as the caller has a copy of a sampled radius law that it replaces.
  bool change(const FingerParameters& parameters) noexcept;
  /// The first bad parameter, for which `change` is false and the constructor throws; none: `change` takes them.
  [[nodiscard]] std::optional<BadParameter> refusal(const FingerParameters& parameters) const noexcept;

  /// A step without a sample: as for an invalid one, with a reason that the caller knows.
  FingerOutput mark_invalid(Fault fault) noexcept;

  [[nodiscard]] const FingerOutput& output() const& noexcept { return state_.output; }
  [[nodiscard]] FingerOutput output() && noexcept { return state_.output; }
  [[nodiscard]] const FingerState& state() const& noexcept { return state_; }
  void restore(const FingerState& state) noexcept { state_ = state; }
  void reset() noexcept { state_ = {}; }
  /// Makes the next search start without a warm start, as in the first slip.
  void forget_warm_start() noexcept { state_.friction.search_start = state_.friction.search_rate = 0.0; }

  /// The limit curve; null for a patch.
  [[nodiscard]] const FingerCurve* curve() const& noexcept { return curve_ ? &*curve_ : nullptr; }
  /// The patch with its points smoothed by ε; null for a limit curve.
  [[nodiscard]] const Patch* patch() const& noexcept;
  [[nodiscard]] Projection projection() const noexcept { return projection_; }
  [[nodiscard]] const FingerParameters& parameters() const& noexcept { return parameters_; }
  // References into a temporary finger would dangle.
  void state() const&& = delete;
  void curve() const&& = delete;
  void patch() const&& = delete;
  void parameters() const&& = delete;

  /// Margin to slip, as a fraction of the limit: 1 without friction or while free, 0 on the limit and during slip.
  [[nodiscard]] double margin() const noexcept;
  /// The smallest `FingerOutput::load` [N] under which the contact bears its present friction without slip: the grip needed to hold. It is at
  /// most the present load if and only if the contact is within its static limit.
  [[nodiscard]] double load_to_hold() const noexcept;
  /// The slip's centre of rotation, in the surface's frame [m]; infinite for pure sliding, NaN without slip.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept;
  /// Energy in the springs [J]: ½ k_l |x_p − x_h|² + ½ k_r (α_p − α_g)², 0 while free. Slip never increases it.
  [[nodiscard]] double spring_energy() const noexcept;

 private:
  friend class Grasp;

  /// The state that `update` would leave if a slip of what rests stayed at the sticking limit: the force is continuous in the pose.
  [[nodiscard]] FingerState try_step(const AnySurface& surface, const DevicePose& device, double time_step) const noexcept;
  FingerOutput advance(FingerState& state, const StepInput& input) const noexcept;

  // The contact: one of both.
  std::optional<FingerCurve> curve_;
  std::shared_ptr<const PatchStep> patch_;
  FingerParameters parameters_;
  Projection projection_ = Projection::closest_point;
  ContactLimits limits_;
  FingerState state_;
};

}  // namespace limitcurve::godobject
