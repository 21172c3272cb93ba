// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "godobject/surface.hpp"

/// What the steps of a round contact (SoftFinger) and of a patch (PatchFinger) share: which samples count, the springs with their dampers, and
/// how the proxy follows a slip. Friction between the two is theirs.
namespace limitcurve::godobject {

/// A contact farther than this from the origin [m], or turned farther [rad], is taken for a fault of the device.
inline constexpr double farthest = 1e6;

/// The contact of a device with a surface, and in `spin` the spin of its orientation since the last good sample. A pose that is not finite, or not
/// of unit length, gives a contact that is not plausible: surfaces answer finite places only.
[[nodiscard]] Contact sense(const AnySurface& surface, const DevicePose& device, const FingerState& state, Spin& spin) noexcept;

/// Whether a sample may be believed: finite, a normal of unit length, no time step < 0, and not farther than `max_displacement` from where the
/// finger last was. One that is refused for that once is believed where it stays.
[[nodiscard]] bool is_plausible(FingerState& state, const FingerParameters& parameters, const Contact& contact, double device_twist,
                                double time_step) noexcept;

/// What a finger does with a sample that is not: `invalid`; the last good output is held, and from the second such sample on it fades.
void fade(FingerState& state, double fault_decay) noexcept;

/// No contact: nothing but the last place and the spin are remembered.
void release(FingerState& state, const Contact& contact, const Spin& spin, double device_twist) noexcept;

/// The first sample in contact: no friction yet, and the springs not yet loaded. (The paper's α_0 is the twist here; angles are kept
/// absolute, and α_p − α_g is the same.)
void touch_down(FingerState& state, const Contact& contact, const Spin& spin, double device_twist) noexcept;

/// The springs between proxy and finger, with the dampers of a timed step in them: implicitly a damper b is a spring b/Δt more, which rests where
/// the deflection was.
struct Springs {
  double stiffness;               ///< [N/m]
  double twist_stiffness;         ///< [N m/rad]
  double rest_share = 0.0;        ///< of the last deflection, where the springs rest
  double twist_rest_share = 0.0;  ///< likewise

  /// `time_step` [s]: 0 where no damper acts.
  Springs(const FingerParameters& finger, double time_step) noexcept;
};

/// How far the spring between proxy and finger is deflected, x_p − x_h.
struct Deflection {
  Eigen::Vector3d tangential;  ///< along the surface [m]: r is its length
  double normal;               ///< along the normal [m]: the depth, and by how much a curved surface rises or falls towards the proxy
};

/// Of the spring after the last good sample.
[[nodiscard]] Deflection deflection(const FingerState& state) noexcept;

/// Step a: the springs while the proxy stays where it is (eq. 7).
struct TrialDeflection {
  Springs springs;
  Deflection spring;                ///< of the proxy as it is
  Eigen::Vector3d proxy;            ///< x_p [m]
  bool is_brought_round;            ///< the finger had left the proxy behind itself, round a curved surface: it slides to the near side
  Eigen::Vector3d tangential_rest;  ///< where dampers let the springs rest: along the surface [m],
  double normal_rest;               ///< along the normal [m],
  double twist_rest;                ///< and in twist [rad]
  Eigen::Vector3d tangential;       ///< the trial: the deflection along the surface less its rest [m]
  double twist;                     ///< and that of the twist, α_p − α_g less its rest [rad]

  /// The normal force on the user [N] where the spring is so long along the normal [m]. Dampers do not pull.
  [[nodiscard]] double load(double normal) const noexcept;
};

/// Takes the sample, which is plausible and touches, into the state, and finds the trial deflection. `time_step` [s] is 0 where no damper acts.
[[nodiscard]] TrialDeflection take_sample(FingerState& state, const FingerParameters& parameters, const Contact& contact, const Spin& spin,
                                          double device_twist, double time_step) noexcept;

/// Where a proxy comes to lie when it slips.
struct Landing {
  Eigen::Vector3d proxy;  ///< x_p [m]
  double normal;          ///< of the spring then, along the normal [m]
  double along_slope =
      1.0;  ///< of the work of a force along the tangent plane at x_g, the share that is done along the surface at the proxy
};

/// Of a proxy of whose trial deflection friction leaves `kept` [m]. The surface is taken for one that rises or falls with the square of the
/// distance from x_g; the proxy does not come farther from the finger than it was, so that no slip adds energy.
[[nodiscard]] Landing follow(const TrialDeflection& trial, const Contact& contact, const Eigen::Vector3d& kept) noexcept;

}  // namespace limitcurve::godobject
