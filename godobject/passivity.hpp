// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"

namespace limitcurve::godobject {

/// Whether chosen gains suit the sample time: offline, before a loop runs. A spring that is sampled and held pushes back a
/// little too long, by half a sample, and so gives energy at every stiffness; something must take it.

/// The damping that the device itself must have (friction and inertia do not count) for a sampled spring k and damper b to be
/// passive in any hand: kT/2 + |b| (Colgate and Schenkel, J. Robotic Systems 14:37–47, 1997; the damper's difference is a
/// backward one, as here), and kT more for each whole sample that the force comes late. Per channel: N/m and N s/m, or N m/rad and
/// N m s/rad; T [s] > 0, delay ≥ 0 samples.
///
/// In their condition a spring that is d samples late has Re{(1 − e^{−jθ})e^{−jdθ}}/(1 − cos θ) = 1 + 2 Σ_{i≤d} cos iθ ≤ 2d + 1, and a damper
/// −2 cos((d+1)θ): the bound is exact for either alone, and for both without delay.
///
/// It holds on curved surfaces too, for moving and for twist about the normal (searched for the path that wins most in energy_search_test). A
/// device that also turns while the normal does wins at most |M| |Δn| |Δφ|/2 a sample beside: a moment that is held keeps its direction.
[[nodiscard]] constexpr double device_damping_needed(double stiffness, double damping, double sample_time, int delay = 0) noexcept {
  return (0.5 + delay) * stiffness * sample_time + (damping < 0.0 ? -damping : damping);
}

/// How near a spring k and a damper b are to the end of stability when they couple n fingers to a body of mass m (or k_r, b_r and
/// the moment of inertia) by explicit steps (symplectic Euler): n(kT²/m + 2bT/m)/4. Stable below 1, where the
/// characteristic polynomial z² − (2 − β − κ)z + 1 − β has its roots within the unit circle, κ = nkT²/m, β = nbT/m. Implicit
/// steps have no such limit. All arguments > 0, the damping ≥ 0.
[[nodiscard]] constexpr double explicit_coupling(double stiffness, double damping, double mass, double sample_time,
                                                 int fingers = 1) noexcept {
  return 0.25 * fingers * sample_time / mass * (stiffness * sample_time + 2.0 * damping);
}

/// What a finger's gains need of the device.
struct DeviceDamping {
  double sliding;  ///< normal and tangential [N s/m]
  double twist;    ///< [N m s/rad]
};

/// For a finger's springs and dampers at a sample time [s] > 0. Throws std::invalid_argument naming what is out of range.
[[nodiscard]] DeviceDamping device_damping_needed(const FingerParameters& finger, double sample_time);

/// Throws std::invalid_argument that says by how much, and what to change, unless a device with this damping of its own is passive
/// with these gains at this sample time [s] > 0. The bound is for any user; a hand that damps allows more.
void require_passive(const FingerParameters& finger, double sample_time, const DeviceDamping& device);

}  // namespace limitcurve::godobject
