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

/// Friction for a haptic or control loop: a soft finger that sticks, slides and twists on one surface (the paper's
/// god-object, steps a–c, corrected: docs/paper.md). Call `update` in every cycle and render its output. A limit curve,
/// or a patch's limit surface, bounds force and moment together; the projection decides how a slipping proxy moves.
///
///     SoftFinger finger(Table::build(hertz()), {.mu = 0.6, .damping = 2.0});
///     const FingerOutput& output = finger.update(surface, device_pose, 1e-3);  // every millisecond
///     device.send(output.whole_force(), output.moment_vector());
///
/// A step takes about 0.1 µs on a plane, and never allocates, throws or locks. Fingers on different threads need no
/// lock.
class SoftFinger {
 public:
  /// Throws std::invalid_argument, naming the parameter, its value, unit and range. A box requires
  /// Projection::closest_point.
  SoftFinger(FingerCurve curve, const FingerParameters& parameters, Projection projection = Projection::closest_point);
  /// A finger with a contact that is not round. The patch's limit surface replaces the limit curve, the projection is
  /// the closest point in F_x, F_y and M, and the radius law is ignored. For a disc, steps match those of its limit
  /// curve to 1e-9.
  ///
  /// Orientation: the patch turns with the finger. Its x axis is the tangential part of the device's x axis, q·x̂,
  /// turned about the normal by `DevicePose::twist` and by the twist of the proxy relative to the finger, α_p − α_g. If
  /// the device's x axis is normal to the surface (tangential part below 1e-6), the previous axis is projected onto the
  /// tangent plane instead. `update(contact, twist)` has no orientation, so it always projects the previous axis. A
  /// contact then starts with the world's x axis, turned by the shortest rotation from z to the normal and then about
  /// the normal by the twist. A closed path of the normal turns the patch by the solid angle of the path, for example
  /// by 0.8 rad in 100 circles at 0.05 rad. In a step, friction is that of the patch before the slip of the step turns
  /// it. The contact point is the centre of pressure: springs act there, and moments refer to it.
  ///
  /// Smoothing: a point under the centre of rotation can carry any force up to its limit, so the search would have no
  /// derivative there. Each point therefore gets a radius ε: its speed |u| becomes √(|u|² + ε²ω²), which changes the
  /// limit by less than the fraction ε/m₀. `point_radius` is ε [m], at least 1e-3 m₀; 0 selects this minimum. Cost: a
  /// step that stays within the hull of pure slides and pure spins never evaluates the patch; a slip evaluates it 5 to
  /// 20 times (see Patch). Throws as above, and also if `mu_r` or `mu_r_dynamic` is set, because the patch determines
  /// the moments. Defined in godobject/patch/.
  SoftFinger(const Patch& patch, const FingerParameters& parameters, double point_radius = 0.0);

  // Moves are cheap copies; a moved-from finger stays valid.
  SoftFinger(const SoftFinger&) = default;
  SoftFinger& operator=(const SoftFinger&) = default;

  /// One step with the device's pose in the frame of the surface. The twist about the contact normal is the spin of the
  /// device's orientation (`Spin`) plus `DevicePose::twist`. Returns a reference to `output()`, which the next step
  /// overwrites: copy what you want to keep. If one expression updates the same finger twice, both references show the
  /// later result.
  ///
  /// Pass the time since the last update [s]. If it is 0, dampers do not act, and a finger that moves farther than
  /// `max_speed` allows in 1 ms (5 mm by default) is taken for a jump. Friction limits the sum of springs and dampers,
  /// and so the force on the user. The first good sample, and the first after invalid samples, are not damped, because
  /// the velocity is unknown.
  ///
  /// Bad input never reaches the user: the state becomes `invalid`, `FingerOutput::fault` names the reason, and the
  /// last good output is held and fades over further invalid samples (`fault_decay`); proxy and contact memory stay.
  /// Input is bad if it is not finite or lies beyond `farthest`, if the length of an orientation or normal is off 1 by
  /// more than 1e-2, if the finger jumps faster than `max_speed`, or if the time step is < 0 or not finite. This is
  /// true in the air as well. If your collision detection has no contact, and so no place, pass a depth ≤ 0 and the
  /// normal (0, 0, 0). The finger is then free at once, and the next sample is compared with the last good place.
  const FingerOutput& update(const AnySurface& surface, const DevicePose& device, double time_step = 0.0) & noexcept;
  /// One step with a contact found by your own collision detection, and the device's twist α_s [rad] about the normal.
  /// The twist may wrap at any multiple of 2π: a jump of more than π between steps is read as a turn the other way.
  const FingerOutput& update(const Contact& contact, double twist, double time_step = 0.0) & noexcept;
  /// The same with the device's orientation instead of a twist: the twist is then its `Spin` about the normals.
  const FingerOutput& update(const Contact& contact, const Orientation& orientation, double time_step = 0.0) & noexcept;

  /// One step inside a physics engine, which knows the load P [N] but no depth: the engine handles the normal
  /// direction, this finger the friction, bounded at P. All in the surface's frame: `point`, the finger's place on the
  /// surface [m], whose motion drives friction; the outward normal; the twist α_s [rad] about it, or the device's
  /// orientation. If P ≤ 0 the finger is free, even if the rest is bad; a load that is not finite is a fault. The
  /// output repeats the load; its depth is NaN. `landed` as in `Contact`; the rest as in `update`.
  ///
  /// As in `update`, the proxy is a point in space; only the part of its spring in the tangent plane acts. While the
  /// finger sticks, the force therefore depends on point and normal alone, so a closed path of both brings the force
  /// back. This is true while the normal stays within 0.25 rad of one direction, for example on a ball of radius
  /// 4 μP/k_l or more; friction then agrees with that on a plane to 0.07 μP. If the normal tilts farther, as on a
  /// smaller ball, the proxy is carried along. Friction still reaches its limit, but after a change of direction it
  /// differs from that on a plane by up to 0.3 μP if a step turns the normal by at most 0.02 rad, and by more in longer
  /// steps. A sticking finger then creeps: a circle of the normal at 0.3 rad (0.5 rad) turns its deflection by 0.09 rad
  /// (0.6 rad).
  ///
  /// On a ball of radius 4 μP/k_l or more, if the normals are the ball's, no path gains more energy than a sampled
  /// spring does (scene/passivity.hpp). On smaller balls a search found paths that gain a quarter more than that. If
  /// the normal tilts by θ against the way, as smoothed or noisy normals do, a loop may gain θ² of the springs' energy.
  /// The spring energy has a part along the normal. A finger may change between both ways of `update` in a contact; in
  /// that step dampers do not act.
  const FingerOutput& update_under_load(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double load,
                                        double twist, double time_step = 0.0, bool landed = false) & noexcept;
  const FingerOutput& update_under_load(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double load,
                                        const Orientation& orientation, double time_step = 0.0,
                                        bool landed = false) & noexcept;

  /// What `update` would return, without changing the state.
  [[nodiscard]] FingerOutput preview(const AnySurface& surface, const DevicePose& device,
                                     double time_step = 0.0) const noexcept;
  [[nodiscard]] FingerOutput preview(const Contact& contact, double twist, double time_step = 0.0) const noexcept;
  [[nodiscard]] FingerOutput preview(const Contact& contact, const Orientation& orientation,
                                     double time_step = 0.0) const noexcept;

  /// Changes the parameters in the loop, for example when the finger touches another material. If a parameter is out of
  /// range (`refusal`), returns false and changes nothing. `output`, proxy, angle and memories stay bit for bit;
  /// `margin`, `load_to_hold` and `spring_energy` use the new parameters at once, with the wrench and deflection of the
  /// last step. In the next step the new springs act at the same deflection, so load and force scale with k; you supply
  /// the energy ½Δk|x|². If the limit is now below the force, the finger slips in that step, with work ≥ 0. Does not
  /// allocate. Does not free memory either, provided you keep a copy of a sampled radius law that you replace.
  bool change(const FingerParameters& parameters) noexcept;
  /// The first parameter for which `change` returns false and the constructor throws; empty if `change` accepts all of
  /// them.
  [[nodiscard]] std::optional<BadParameter> refusal(const FingerParameters& parameters) const noexcept;

  /// Call this instead of `update` in a step without a sample, with your reason and the time step [s].
  const FingerOutput& mark_invalid(Fault fault, double time_step = 0.0) & noexcept;

  [[nodiscard]] const FingerOutput& output() const& noexcept { return state_.output; }
  [[nodiscard]] FingerOutput output() && noexcept { return state_.output; }
  [[nodiscard]] const FingerState& state() const& noexcept { return state_; }
  void restore(const FingerState& state) noexcept { state_ = state; }
  void reset() noexcept { state_ = {}; }
  /// Makes the next search start cold, as in the first slip.
  void forget_warm_start() noexcept { state_.friction.search_start = state_.friction.search_rate = 0.0; }

  /// The limit curve; null for a patch.
  [[nodiscard]] const FingerCurve* curve() const& noexcept { return curve_ ? &*curve_ : nullptr; }
  /// The patch, its points smoothed by ε; null for a limit curve.
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
  /// How hard to grip: the smallest `FingerOutput::load` [N] that carries the current friction without slip. It is at
  /// most the current load if and only if the contact is within its static limit.
  [[nodiscard]] double load_to_hold() const noexcept;
  /// The slip's centre of rotation in the surface's frame [m]; infinite for pure sliding, NaN without slip.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept;
  /// Energy in the springs [J]: ½ k_l |x_p − x_h|² + ½ k_r (α_p − α_g)², 0 while free. Without dampers,
  /// slip never increases it.
  [[nodiscard]] double spring_energy() const noexcept;

 private:
  friend class Grasp;

  /// The state after `update` if a contact at rest that slips stayed at the sticking limit: makes the force continuous
  /// in the pose.
  [[nodiscard]] FingerState try_step(const AnySurface& surface, const DevicePose& device,
                                     double time_step) const noexcept;
  const FingerOutput& advance(FingerState& state, StepInput&& input) const noexcept;

  // The contact: exactly one of these is set.
  std::optional<FingerCurve> curve_;
  std::shared_ptr<const PatchStep> patch_;
  FingerParameters parameters_;
  Projection projection_ = Projection::closest_point;
  ContactLimits limits_;
  FingerState state_;
};

}  // namespace limitcurve::godobject
