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

/// The parameters of a soft finger, except its limit curve. SI units; angles in radians.
struct FingerParameters {
  double mu = 0.5;                                    ///< coefficient of static friction μ, ≥ 0
  std::optional<double> mu_dynamic = {};              ///< coefficient during slip, 0 ≤ μ_d ≤ μ; absent: μ
  RadiusLaw radius_law = RadiusLaw::constant(0.005);  ///< contact radius a(P)
  std::optional<double> mu_r = {};                    ///< μ_r [m/N^γ] ≥ 0: Γ = μ_r P^(1+γ), replaces the radius law (eq. 2)
  double gamma = 0.0;                                 ///< γ ∈ [−0.5, 1] of the moment coefficients
  /// μ_r during slip [m/N^γ]; absent: μ_r μ_d/μ. Where μ_d = 0 closest_point keeps this moment; radial and c_curve do not, because the ray to
  /// a trial with a force meets the limit at 0.
  std::optional<double> mu_r_dynamic = {};
  double stiffness = 1000.0;       ///< k_l [N/m] > 0, normal and tangential
  double twist_stiffness = 0.025;  ///< k_r [N m/rad] > 0; a pad's own is k_l a² (docs/drive.md)
  double damping = 0.0;            ///< b_l [N s/m] ≥ 0, normal and tangential; acts if `update` has a time step
  double twist_damping = 0.0;      ///< b_r [N m s/rad] ≥ 0
  /// Hysteresis between static and dynamic friction [1] ≥ 0: a sliding finger comes to rest when its trial is within the sliding limit
  /// divided by 1 + rest_margin·(μ/μ_d − 1). So a repeated sample, noise or the device's resolution do not bring it back to static
  /// friction. With the default the trial must fall by about 0.4 of the gap between the limits; a mass that sticks and slips on springs not
  /// stiffer than the contact makes it fall by 0.5 or more. 0: at rest as soon as the trial is within the sliding limit.
  double rest_margin = 0.4;
  /// Maximum displacement between two samples [m] > 0. A larger one is a fault of the device: the sample is `invalid`. If the next sample
  /// is near it, it is accepted. The default is 500 m/s at 1 kHz; ∞ accepts every sample.
  double max_displacement = 0.5;
  /// Fault decay ∈ [0, 1]: load, force and moment are multiplied by it at each invalid sample after the first. The default halves them in
  /// 70 samples; 1 holds them for ever.
  double fault_decay = 0.99;
};

/// In shorter time steps [s] dampers do not act, and a free body does not move.
inline constexpr double shortest_time_step = 1e-9;

/// Whether a time step [s] is one: ≥ 0 and finite. A NaN is not.
[[nodiscard]] constexpr bool is_time_step(double time_step) noexcept {
  // One comparison: numbers with a sign have larger bits than an infinity, those that are not finite no smaller ones; −0 + 0 is 0.
  return std::bit_cast<std::uint64_t>(time_step + 0.0) < std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
}

/// The state of a contact.
enum class ContactState : std::uint8_t {
  free,     ///< not touching: depth ≤ 0
  stick,    ///< touching, the proxy rests on the surface
  slip,     ///< touching, the proxy slid or turned in this step
  invalid,  ///< bad input: the last good output is held, then fades
};

/// "free", "stick", "slip", "invalid".
constexpr std::string_view to_string(ContactState state) noexcept {
  constexpr std::array<std::string_view, 4> names{"free", "stick", "slip", "invalid"};
  return names[static_cast<std::size_t>(state)];
}

/// Why a sample was refused: the reason of the state `invalid`.
enum class Fault : std::uint8_t {
  none,
  not_finite,    ///< a NaN or an infinity in a position, a normal, an orientation or a twist
  too_far,       ///< beyond `farthest`
  orientation,   ///< the device's orientation is not of unit length
  normal,        ///< the contact's normal is not of unit length
  time_step,     ///< it is < 0 or not finite
  displacement,  ///< more than `max_displacement` since the last sample
  body,          ///< the pose of the touched body (Grasp, Replay) is not finite, beyond `farthest`, or not of unit length
  force,         ///< the force or the moment on the body (Grasp) is not finite, or would carry it beyond `farthest`
};

/// What is wrong, as in "a sample is invalid: the normal is not of unit length"; "none" without a fault.
constexpr std::string_view to_string(Fault fault) noexcept {
  constexpr std::array<std::string_view, 9> reasons{"none",
                                                    "a number is not finite",
                                                    "a coordinate, the depth or the twist is beyond 1e6",
                                                    "the orientation is not of unit length",
                                                    "the normal is not of unit length",
                                                    "the time goes back or is not finite",
                                                    "the finger moved by more than the maximum displacement",
                                                    "the body's pose is not finite, beyond 1e6 m, or not of unit length",
                                                    "the force or the moment on the body is not finite, or would move it beyond 1e6"};
  return reasons[static_cast<std::size_t>(fault)];
}

/// The result of a step.
struct FingerOutput {
  ContactState state = ContactState::free;
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();    ///< x_p [m]; while free, the finger's position
  double angle = 0.0;                                 ///< α_p [rad], measured like the device's twist; while free, the twist
  double depth = 0.0;                                 ///< d [m]; NaN in a step under a given load
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward, at the contact
  /// Normal force on the user [N], 0 while free: the load that bounds friction (`FingerState::limit_load`, k_l d and the damper's part) plus the
  /// push of a curved surface, k_l times its rise from x_g to the proxy, < 0 on a convex one; on a plane both are one. The push is part of the
  /// gradient of the springs' energy: a closed loop gains nothing with it, and may gain without. `load_to_hold` has the same unit.
  double load = 0.0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user [N], tangential
  double moment = 0.0;                                    ///< friction on the user about the normal [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< distance of the slip's COR from the contact centre [m]; NaN without slip
  double slip_work = 0.0;                                 ///< energy that slip dissipates in this step [J], ≥ 0 if `converged`
  /// False: the search for a patch's closest point did not converge. The wrench is on the limit surface, but not the closest point.
  bool converged = true;
  Fault fault = Fault::none;  ///< the reason of `ContactState::invalid`; none in any other state

  /// The force on the user [N]. After `update_under_load` apply `force` and `moment_vector()` alone: the engine pushes.
  [[nodiscard]] Eigen::Vector3d whole_force() const noexcept { return normal * load + force; }
  /// The moment on the user [N m], at the contact.
  [[nodiscard]] Eigen::Vector3d moment_vector() const noexcept { return normal * moment; }
};

/// The result of a step in a body's frame, as the world sees it.
[[nodiscard]] inline FingerOutput to_world(const BodyPose& body, FingerOutput output) noexcept {
  output.proxy = body.to_world(output.proxy);
  output.normal = body.orientation * output.normal;
  output.force = body.orientation * output.force;
  return output;
}

/// The last good sample of the device: where the finger is against the surface.
struct FingerSample {
  Eigen::Vector3d goal = Eigen::Vector3d::Zero();     ///< x_g [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< outward normal there
  double depth = 0.0;                                 ///< d [m]
  double angle = 0.0;                                 ///< α_g [rad], unwrapped
  double twist = 0.0;                                 ///< the device's twist as it was given [rad]
  double unwrapped_by = 0.0;                          ///< added to it by unwrapping [rad], a multiple of 2π

  /// The finger's position x_h [m].
  [[nodiscard]] Eigen::Vector3d position() const noexcept { return goal - normal * depth; }
};

/// What is known of good and refused samples.
struct FingerFaults {
  bool seen = false;                                     ///< there was a good sample
  bool refused = false;                                  ///< the last sample was refused because of its displacement
  Eigen::Vector3d refused_at = Eigen::Vector3d::Zero();  ///< its position [m]
};

/// What the friction of a patch keeps between steps. Zero for a limit curve.
struct PatchMemory {
  Eigen::Vector3d zero_axis = Eigen::Vector3d::Zero();  ///< unit tangent: the patch's x axis at α_p = 0
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();       ///< its x axis in the last step, before slip turned it
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();       ///< the last slip (v_x, v_y, ω) in those axes [m, rad]; zero without slip
};

/// The whole state of a finger between steps. Plain numbers: copy it, save it, restore it.
struct FingerState {
  FingerOutput output{};  ///< of the last step; its proxy is the finger's memory
  FingerSample sample{};
  Spin spin{};              ///< of the device's orientation in that sample
  ContactMemory contact{};  ///< state of the contact query in that sample
  FingerFaults faults{};
  FrictionMemory<double> friction{};
  PatchMemory patch{};
  /// Under a given load: the normal that holds the proxy, within 0.25 rad of the present one (finger/springs.hpp).
  Eigen::Vector3d held_normal = Eigen::Vector3d::UnitZ();
  bool in_contact = false;    ///< unchanged by invalid samples
  double limit_load = 0.0;    ///< P of the friction limit [N]: k_l d plus the damper's force; `FingerOutput::load` less the surface's push
  double trial_force = 0.0;   ///< trial wrench of the last step (eq. 7): force of springs and dampers if the proxy stayed [N]
  double trial_moment = 0.0;  ///< and their moment [N m]
};

}  // namespace limitcurve::godobject
