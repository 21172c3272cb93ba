// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "godobject/surface.hpp"

/// The parts of a step that SoftFinger and PatchFinger share: the check of samples, springs and dampers, and the motion of the proxy in a
/// slip. Each has its own friction.
namespace limitcurve::godobject {

/// A contact farther than this from the origin [m], or with a larger twist [rad], is a fault of the device.
inline constexpr double farthest = 1e6;

/// The contact of a device with a surface, and in `spin` the spin of its orientation since the last good sample. A pose that is not finite,
/// or an orientation not of unit length, gives a contact that is not plausible; the surface is not called, because it requires a finite
/// position.
[[nodiscard]] Contact sense(const AnySurface& surface, const DevicePose& device, const FingerState& state, Spin& spin) noexcept;

/// Whether a sample is plausible: finite, a normal of unit length, a time step ≥ 0, and within `max_displacement` of the last good
/// position. After a sample was refused for its displacement, samples near it are plausible.
[[nodiscard]] bool is_plausible(FingerState& state, const FingerParameters& parameters, const Contact& contact, double device_twist,
                                double time_step) noexcept;

/// The step of an invalid sample: the last good output is held, and fades from the second invalid sample on.
void fade(FingerState& state, double fault_decay) noexcept;

/// The step without contact: keeps only position and spin.
void release(FingerState& state, const Contact& contact, const Spin& spin, double device_twist) noexcept;

/// The first sample in contact: the springs are not loaded. (The paper's α_0 is the twist here. Angles are absolute; α_p − α_g is the
/// same.)
void touch_down(FingerState& state, const Contact& contact, const Spin& spin, double device_twist) noexcept;

/// The springs between proxy and finger, dampers included. In an implicit step a damper b is an additional spring b/Δt whose rest is the
/// last deflection.
struct Springs {
  double stiffness;               ///< [N/m]
  double twist_stiffness;         ///< [N m/rad]
  double rest_share = 0.0;        ///< rest of the springs divided by the last deflection
  double twist_rest_share = 0.0;  ///< the same for the twist

  /// `time_step` [s]; 0: no damper acts.
  Springs(const FingerParameters& finger, double time_step) noexcept;
};

/// The deflection x_p − x_h of the spring between proxy and finger.
struct Deflection {
  Eigen::Vector3d tangential;  ///< along the surface [m]; r is its length
  double normal;               ///< along the normal [m]: the depth, plus the rise of a curved surface from x_g to the proxy
};

/// The deflection after the last good sample.
[[nodiscard]] Deflection deflection(const FingerState& state) noexcept;

/// Step a: springs and dampers if the proxy stays (eq. 7).
struct TrialDeflection {
  Springs springs;
  Deflection spring;                ///< deflection of the spring, before friction
  Eigen::Vector3d proxy;            ///< x_p [m]
  bool is_brought_round;            ///< the proxy was on the far side of a curved surface, and is moved to the finger's near side
  Eigen::Vector3d tangential_rest;  ///< rest of the springs because of dampers: along the surface [m],
  double normal_rest;               ///< along the normal [m],
  double twist_rest;                ///< and in twist [rad]
  Eigen::Vector3d tangential;       ///< trial deflection along the surface, minus its rest [m]
  double twist;                     ///< trial deflection in twist, α_p − α_g minus its rest [rad]

  /// The normal force on the user [N] for a deflection along the normal [m]. A damper does not pull.
  [[nodiscard]] double load(double normal) const noexcept;
};

/// Step a: stores a plausible sample in contact in the state, and returns the trial deflection. `time_step` [s]; 0: no damper acts.
[[nodiscard]] TrialDeflection take_sample(FingerState& state, const FingerParameters& parameters, const Contact& contact, const Spin& spin,
                                          double device_twist, double time_step) noexcept;

/// The proxy after a slip.
struct Landing {
  Eigen::Vector3d proxy;     ///< x_p [m]
  double normal;             ///< deflection of the spring along the normal then [m]
  double along_slope = 1.0;  ///< work along the surface at the proxy divided by work along the tangent plane at x_g
};

/// The proxy after a slip that leaves `kept` [m] of the trial deflection. Models the surface as a paraboloid about x_g. The proxy does not
/// move away from the finger, so that a slip never adds energy.
[[nodiscard]] Landing follow(const TrialDeflection& trial, const Contact& contact, const Eigen::Vector3d& kept) noexcept;

}  // namespace limitcurve::godobject
