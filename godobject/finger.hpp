// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"
#include "godobject/friction.hpp"
#include "limitcurve/radius_law.hpp"

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
  /// A finger that moves farther than this between two samples [m] > 0 is a fault of the device: refused once, as `invalid`. The
  /// default is 500 m/s at 1 kHz; ∞ believes everything.
  double max_displacement = 0.5;
  /// What is kept of load, force and moment from one invalid sample to the next, ∈ [0, 1]; the first holds all. The default lets go of half
  /// in 70 samples; 1 holds for ever.
  double fault_decay = 0.99;
};

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
  double load = 0.0;                                      ///< P = k_l d [N], 0 while free
  Eigen::Vector3d force = Eigen::Vector3d::Zero();        ///< friction on the user, k_l (x_p − x_g) [N], tangential
  double moment = 0.0;                                    ///< friction on the user about the normal, k_r (α_p − α_g) [N m]
  double cor = std::numeric_limits<double>::quiet_NaN();  ///< of the slip, from the contact centre [m]; NaN unless it slips
  double slip_work = 0.0;                                 ///< dissipated in this step [J], ≥ 0
};

/// All that a finger remembers from one step to the next. Plain numbers: copy it, save it, restore it.
struct FingerState {
  using Vector = std::array<double, 3>;

  ContactState state = ContactState::free;
  bool in_contact = false;  ///< also while samples are invalid
  Vector proxy{};           ///< as FingerOutput has them
  double angle = 0.0;
  double depth = 0.0;
  double load = 0.0;
  Vector force{};
  double moment = 0.0;
  double cor = std::numeric_limits<double>::quiet_NaN();
  double slip_work = 0.0;
  Vector goal{};                 ///< x_g of the last good sample [m]
  double goal_angle = 0.0;       ///< α_g of the last good sample [rad], unwrapped
  Vector normal{0.0, 0.0, 1.0};  ///< outward normal there
  double device_twist = 0.0;     ///< the device's twist as it was given [rad]
  double turns = 0.0;            ///< what unwrapping adds to the device's twist [rad], a multiple of 2π
  bool seen = false;             ///< there was a good sample
  bool refused = false;          ///< the last sample was too far from the one before it …
  Vector refused_at{};           ///< … namely here [m]
  FrictionMemory<double> friction{};

  /// How far the springs were deflected along the surface after the last good sample: x_p − x_g [m].
  [[nodiscard]] Eigen::Vector3d deflection() const noexcept;
  /// Where the finger itself was in the last good sample [m].
  [[nodiscard]] Eigen::Vector3d position() const noexcept;
  /// Where the slip's centre of rotation is, in the surface's frame [m]; infinite for pure sliding, NaN unless it slips.
  [[nodiscard]] Eigen::Vector3d centre_of_rotation() const noexcept;
  [[nodiscard]] FingerOutput output() const noexcept;
};

[[nodiscard]] inline Eigen::Vector3d vector(const FingerState::Vector& numbers) noexcept {
  return {numbers[0], numbers[1], numbers[2]};
}
[[nodiscard]] inline FingerState::Vector numbers(const Eigen::Vector3d& vector) noexcept {
  return {vector.x(), vector.y(), vector.z()};
}

/// A contact farther than this from the origin [m], or turned farther [rad], is taken for a fault of the device.
inline constexpr double farthest = 1e6;

/// Whether a sample may be believed: finite, a normal of unit length, no time step < 0, and not farther than `max_displacement` from where the
/// finger last was. One that is refused for that once is believed where it stays.
[[nodiscard]] bool is_plausible(FingerState& state, const FingerParameters& parameters, const Contact& contact, double device_twist,
                                double time_step) noexcept;

/// What a finger does with a sample that is not: `invalid`; the last good output is held, and from the second such sample on it fades.
void fade(FingerState& state, double fault_decay) noexcept;

/// No contact: nothing but the last place is remembered.
void release(FingerState& state, const Contact& contact, double device_twist) noexcept;

/// The first sample in contact: no friction yet. (The paper's α_0 is the twist here; angles are kept absolute, and α_p − α_g is the same.)
void touch_down(FingerState& state, const Contact& contact, double device_twist) noexcept;

}  // namespace limitcurve::godobject
