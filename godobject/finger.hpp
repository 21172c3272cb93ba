// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"
#include "godobject/friction.hpp"
#include "limitcurve/contact_radius.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

namespace limitcurve::godobject {

/// What a soft finger is made of, besides the shape of its limit curve. Every length in metres, every angle in radians.
struct FingerParameters {
  double mu = 0.5;                                        ///< coefficient of static friction μ, ≥ 0
  std::optional<double> mu_dynamic = {};                  ///< while slipping, 0 ≤ μ_d ≤ μ; absent: μ
  RadiusLaw radius_law = RadiusLaw::constant(0.005);      ///< contact radius a(P)
  std::optional<double> moment_coefficient = {};          ///< μ_r [m/N^γ] ≥ 0: Γ = μ_r P^(1+γ) whatever the radius law (eq. 2)
  double moment_exponent = 0.0;                           ///< γ ∈ [−0.5, 1] of the moment coefficients
  std::optional<double> moment_coefficient_dynamic = {};  ///< μ_r while slipping [m/N^γ]; absent: μ_r μ_d/μ
  double stiffness = 1000.0;                              ///< k_l [N/m] > 0, normal and tangential
  double twist_stiffness = 0.04;                          ///< k_r [N m/rad] > 0
  double damping = 0.0;                                   ///< b_l [N s/m] ≥ 0, normal and tangential; acts in timed updates
  double twist_damping = 0.0;                             ///< b_r [N m s/rad] ≥ 0
  /// Between static and dynamic friction [1] ≥ 0: a finger that slides comes to rest when its trial has retreated within the dynamic limit
  /// divided by 1 + rest_margin·(μ/μ_d − 1). A sample that repeats the last one, or is off by the device's noise or resolution, so does not
  /// bring a sliding finger back to static friction. The default asks for a retreat of 0.4 of the gap between the limits; a mass that
  /// sticks and slips on springs not stiffer than the contact retreats by 0.5 or more. 0: at rest as soon as the trial is within the limit.
  double rest_margin = 0.4;
  /// A finger that moves farther than this between two samples [m] > 0 is a fault of the device: refused once, as `invalid`. The
  /// default is 500 m/s at 1 kHz; ∞ believes everything.
  double max_displacement = 0.5;
  /// What is kept of load, force and moment from one invalid sample to the next, ∈ [0, 1]; the first holds all. The default lets go of half
  /// in 70 samples; 1 holds for ever.
  double fault_decay = 0.99;
};

/// Dampers do not act, and a free body does not move, in time steps shorter than this [s].
inline constexpr double shortest_time_step = 1e-9;

/// What a finger does.
enum class ContactState : std::uint8_t {
  free,     ///< not touching: depth ≤ 0
  stick,    ///< touching, the proxy rests on the surface
  slip,     ///< touching, the proxy slid in this step
  invalid,  ///< the input was not usable: the last good output is held, and fades
};

/// "free", "stick", "slip", "invalid".
constexpr std::string_view to_string(ContactState state) noexcept {
  constexpr std::array<std::string_view, 4> names{"free", "stick", "slip", "invalid"};
  return names[static_cast<std::size_t>(state)];
}

/// What a step gives.
struct FingerOutput {
  ContactState state = ContactState::free;
  Eigen::Vector3d proxy = Eigen::Vector3d::Zero();        ///< x_p [m]; while free, the finger itself
  double angle = 0.0;                                     ///< α_p [rad] in the frame of the device's twist; while free, the twist
  double depth = 0.0;                                     ///< d [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();      ///< outward, at the contact; the whole force on the user is normal·load + force
  double load = 0.0;                                      ///< normal force on the user [N], 0 while free; on a plane at rest k_l d
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user [N], tangential
  double moment = 0.0;                                    ///< friction on the user about the normal [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip, from the contact centre [m]; NaN unless it slips
  double slip_work = 0.0;                                 ///< dissipated in this step [J], ≥ 0
};

/// All that a finger remembers from one step to the next. Plain numbers: copy it, save it, restore it.
struct FingerState {
  ContactState state = ContactState::free;
  bool in_contact = false;  ///< also while samples are invalid
  Numbers proxy{};          ///< as FingerOutput has them
  double angle = 0.0;
  double depth = 0.0;
  double load = 0.0;
  Numbers force{};
  double moment = 0.0;
  double cor = std::numeric_limits<double>::quiet_NaN();
  double slip_work = 0.0;
  double trial_force = 0.0;       ///< what springs and dampers would have borne in the last step, had the proxy stayed [N] …
  double trial_moment = 0.0;      ///< … [N m] (eq. 7): force and moment where it stayed
  double limit_load = 0.0;        ///< P that the friction limit grows with [N]: k_l d and what dampers add
  Numbers goal{};                 ///< x_g of the last good sample [m]
  double goal_angle = 0.0;        ///< α_g of the last good sample [rad], unwrapped
  Numbers normal{0.0, 0.0, 1.0};  ///< outward normal there
  double device_twist = 0.0;      ///< the device's twist as it was given [rad]
  double turns = 0.0;             ///< what unwrapping adds to the device's twist [rad], a multiple of 2π
  bool seen = false;              ///< there was a good sample
  bool refused = false;           ///< the last sample was too far from the one before it …
  Numbers refused_at{};           ///< … namely here [m]
  Spin spin{};                    ///< of a device that gives its orientation
  ContactMemory contact{};        ///< of the surface
  FrictionMemory<double> friction{};

  /// Where the finger itself was in the last good sample [m].
  [[nodiscard]] Eigen::Vector3d position() const noexcept;
  /// Where the slip's centre of rotation is, in the surface's frame [m]; infinite for pure sliding, NaN unless it slips.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept;
  [[nodiscard]] FingerOutput output() const noexcept;
};

}  // namespace limitcurve::godobject
