// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/contact/radius_law.hpp"
#include "contact.hpp"
#include "friction.hpp"

#include <Eigen/Core>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace limitcurve::godobject {

/// Everything about a soft finger except the limit curve: friction, contact radius, springs, dampers, fault handling.
/// SI units, radians.
struct FingerParameters {
  double mu = 0.5;                                    ///< coefficient of static friction μ, ≥ 0
  std::optional<double> mu_dynamic = {};              ///< coefficient during slip, 0 ≤ μ_d ≤ μ; absent: μ
  RadiusLaw radius_law = RadiusLaw::constant(0.005);  ///< contact radius a(P)
  std::optional<double> mu_r = {};  ///< μ_r [m/N^γ] ≥ 0: Γ = μ_r P^(1+γ), replaces the radius law (eq. 2)
  double gamma = 0.0;               ///< γ ∈ [−0.5, 1] of the moment coefficients
  /// μ_r during slip [m/N^γ]; if absent, μ_r μ_d/μ. If μ_d = 0, only closest_point can keep this moment. radial and
  /// c_curve lose it as soon as the trial has a force, because the ray to that trial meets the limit at 0.
  std::optional<double> mu_r_dynamic = {};
  double stiffness = 1000.0;       ///< k_l [N/m] > 0, normal and tangential
  double twist_stiffness = 0.025;  ///< k_r [N m/rad] > 0; an elastic pad has k_l a² (docs/drive.md)
  double damping = 0.0;            ///< b_l [N s/m] ≥ 0, normal and tangential; acts if `update` has a time step
  double twist_damping = 0.0;      ///< b_r [N m s/rad] ≥ 0
  /// Hysteresis between static and dynamic friction [1] ≥ 0, which prevents chatter: noise, a repeated sample or the
  /// device's resolution must not put a sliding finger back into static friction. A sliding finger comes to rest once
  /// its trial wrench is within the sliding limit divided by 1 + rest_margin·(μ/μ_d − 1). With the default, the trial
  /// must fall by about 0.4 of the gap between the two limits. That is low enough for real stick–slip: a mass on
  /// springs no stiffer than the contact makes the trial fall by at least 0.5 of the gap. With 0, the finger rests as
  /// soon as the trial is within the sliding limit. If μ_d or mu_r_dynamic is 0, the finger can only rest after
  /// lifting, because otherwise a repeated sample would end the slip.
  double rest_margin = 0.4;
  /// Largest speed of the finger past the body [m/s] > 0. A sample is taken for a device fault, and `invalid`, if it
  /// lies farther from the last good one than this times the time since then: the sum of the time steps between, at
  /// least 1 ms. If the next sample stays near the refused one, it is accepted. The default is above what hands (2 m/s,
  /// ISO 13855) and Franka's arms (3 m/s) reach; ∞ accepts every sample.
  double max_speed = 5.0;
  /// How fast the output fades during faults ∈ [0, 1]: each invalid sample after the first multiplies load, force and
  /// moment by this factor. The default leaves a tenth after 45 samples; 1 holds them forever.
  double fault_decay = 0.95;
};

/// In time steps [s] shorter than this, dampers do not act, and in a replay free bodies do not move.
inline constexpr double shortest_time_step = 1e-9;

/// Whether a time step [s] is valid: ≥ 0 and finite, not NaN.
[[nodiscard]] constexpr bool is_time_step(double time_step) noexcept {
  // In one comparison: negative numbers have larger bit patterns than infinity, non-finite ones no smaller; −0 + 0 is
  // 0.
  return std::bit_cast<std::uint64_t>(time_step + 0.0) <
         std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
}

/// The state of a contact.
enum class ContactState : std::uint8_t {
  free,     ///< not touching: depth ≤ 0
  stick,    ///< touching; the proxy rests
  slip,     ///< touching; the proxy slid or turned in this step
  invalid,  ///< bad input: the last good output is held, then fades
};

/// "free", "stick", "slip", "invalid".
constexpr std::string_view to_string(ContactState state) noexcept {
  constexpr std::array<std::string_view, 4> names{"free", "stick", "slip", "invalid"};
  return names[static_cast<std::size_t>(state)];
}

/// Why a sample was rejected: the reason for the state `invalid`.
enum class Fault : std::uint8_t {
  none,
  not_finite,   ///< a NaN or infinity in a position, normal, orientation or twist
  too_far,      ///< beyond `farthest`
  orientation,  ///< the length of the device's orientation is off 1 by more than 1e-2
  normal,       ///< the length of the contact's normal is off 1 by more than 1e-2
  time_step,    ///< < 0 or not finite
  speed,        ///< farther from the last good sample than `max_speed` allows
  body,         ///< the touched body's pose (Grasp, Replay) is not finite, beyond `farthest`, or not of unit length
  force,        ///< the force or the moment on the body (Grasp) is not finite, or would carry it beyond `farthest`
};

/// The fault in words, as in "a sample is invalid: the normal is not of unit length"; "none" without a fault.
constexpr std::string_view to_string(Fault fault) noexcept {
  constexpr std::array<std::string_view, 9> reasons{
      "none",
      "a number is not finite",
      "a coordinate, the depth or the twist is beyond 1e6",
      "the orientation is not of unit length",
      "the normal is not of unit length",
      "the time goes back or is not finite",
      "the finger moved faster than the maximum speed past the body",
      "the body's pose is not finite, beyond 1e6 m, or not of unit length",
      "the force or the moment on the body is not finite, or would move it beyond 1e6"};
  return reasons[static_cast<std::size_t>(fault)];
}

/// What one step returns: the force and moment to render, and the state of the contact.
struct FingerOutput {
  ContactState state = ContactState::free;
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();  ///< x_p [m]; while free, the finger's position
  double angle = 0.0;  ///< α_p [rad], measured like the device's twist; while free, the twist
  double depth = 0.0;  ///< d [m]; NaN in a step under a given load
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward, at the contact
  /// Normal force on the user [N], 0 while free. On a plane it is the load that bounds friction, k_l d plus the
  /// damper's part (`FingerState::limit_load`). A curved surface adds a push: k_l times its rise from x_g to the proxy,
  /// negative on a convex surface. With the push, the force is the gradient of the springs' energy, so that a closed
  /// loop gains no energy; without it, it could. `load_to_hold` includes the push as well.
  double load = 0.0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user [N], tangential
  double moment = 0.0;                                    ///< friction on the user about the normal [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< distance of the slip's COR from the contact centre [m];
                                                          ///< NaN without slip
  double slip_work = 0.0;  ///< energy dissipated by slip in this step [J], ≥ 0 if `converged`
  /// False if the search for a patch's closest point did not converge: the wrench is on the limit surface, but not the
  /// closest point.
  bool converged = true;
  Fault fault = Fault::none;  ///< the reason for `ContactState::invalid`; none in any other state

  /// The force on the user [N]. After `update_under_load` apply `force` and `moment_vector()` alone: the engine pushes.
  [[nodiscard]] Eigen::Vector3d whole_force() const noexcept { return normal * load + force; }
  /// The moment on the user [N m], at the contact.
  [[nodiscard]] Eigen::Vector3d moment_vector() const noexcept { return normal * moment; }
};

/// The result of a step in a body's frame, as the world sees it. If the pose is no rotation, or not finite, nothing can
/// turn the force, so force, load and moment are 0 and the state is `invalid` by Fault::body. Pass the last good pose
/// to keep the force.
[[nodiscard]] inline FingerOutput to_world(const BodyPose& body, FingerOutput output) noexcept {
  const Orientation turn = body.out_of_body();
  if (!(turn.squaredNorm() < 2.0 && is_plausible<double>(body.position.squaredNorm()))) {
    output.force.setZero();
    output.load = output.moment = 0.0;
    output.state = ContactState::invalid;
    output.fault = Fault::body;
    return output;
  }
  output.proxy = body.position + turn * output.proxy;
  output.normal = turn * output.normal;
  output.force = turn * output.force;
  return output;
}

/// The last good sample of the device: where the finger is relative to the surface.
struct FingerSample {
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();     ///< x_g [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward normal there
  double depth = 0.0;                                 ///< d [m]
  double angle = 0.0;                                 ///< α_g [rad], unwrapped
  double twist = 0.0;                                 ///< the device's twist as passed in [rad]
  double unwrapped_by = 0.0;                          ///< what unwrapping added to it [rad], a multiple of 2π

  /// The finger's position x_h [m].
  [[nodiscard]] Eigen::Vector3d position() const noexcept { return goal - normal * depth; }
};

/// Bookkeeping of good and rejected samples.
struct FingerFaults {
  bool seen = false;                                     ///< there has been a good sample
  bool refused = false;                                  ///< a sample since then was rejected for its speed
  Eigen::Vector3d refused_at = Eigen::Vector3d::Zero();  ///< its position [m]
  double elapsed = 0.0;                                  ///< time since the last good sample [s]
  double refused_after = 0.0;                            ///< `elapsed` when one was refused [s]
};

/// What a patch's friction remembers between steps. Zero for a limit curve.
struct PatchMemory {
  Eigen::Vector3d zero_axis = Eigen::Vector3d::Zero();  ///< unit tangent: the patch's x axis at α_p = 0
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();       ///< its x axis in the last step, before slip turned it
  Eigen::Vector3d slip =
      Eigen::Vector3d::Zero();  ///< the last slip (v_x, v_y, ω) in those axes [m, rad]; zero without slip
};

/// The complete state of a finger between steps. Plain data: copy it, save it, restore it.
struct FingerState {
  FingerOutput output{};  ///< of the last step; its proxy is the finger's memory
  FingerSample sample{};
  Spin spin{};              ///< of the device's orientation in that sample
  ContactMemory contact{};  ///< state of the contact query in that sample
  FingerFaults faults{};
  FrictionMemory<double> friction{};
  PatchMemory patch{};
  /// Under a given load: the normal that holds the proxy, within 0.25 rad of the current one (finger/springs.hpp).
  Eigen::Vector3d held_normal = Eigen::Vector3d::UnitZ();
  bool in_contact = false;  ///< unchanged by invalid samples
  double limit_load = 0.0;  ///< P that bounds friction [N]: k_l d plus the damper's force; `FingerOutput::load` without
                            ///< the surface's push
  double trial_force =
      0.0;  ///< trial wrench of the last step (eq. 7): force of springs and dampers if the proxy had stayed [N]
  double trial_moment = 0.0;  ///< and their moment [N m]
};

}  // namespace limitcurve::godobject
