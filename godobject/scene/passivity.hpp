// SPDX-License-Identifier: MIT
#pragma once

#include "../finger.hpp"

#include <span>

namespace limitcurve::godobject {

// Passivity of a finger's gains at a sample time; offline. A sampled spring holds its force half a sample too long, and
// so adds energy at every stiffness. The device must dissipate it.

/// The smallest damping of the device itself (without friction and inertia) that makes a sampled linear spring k and
/// damper b passive in any hand. Most devices are a sample late. For a force N samples late it is the sup over θ of ½kT
/// sin((N + ½)θ)/sin(θ/2) − b cos((N + 1)θ), at most (N + ½)kT + |b|, and kT/2 + |b| without delay (Colgate and
/// Schenkel, J. Robotic Systems 14:37–47, 1997; the damper uses a backward difference, as here). One channel: N/m and N
/// s/m, or N m/rad and N m s/rad; T [s] > 0, 0 ≤ N ≤ `most_delay` samples.
///
/// With friction and on curved surfaces it is searched, not proved, for translation and for twist about the normal,
/// also with a delay: no path gained more (energy_search_test). If the device also rotates while the normal turns, it
/// gains at most |M| |Δn| |Δφ|/2 more in a sample, because a held moment keeps its direction.
[[nodiscard]] double device_damping_needed(double stiffness, double damping, double sample_time,
                                           int delay = 0) noexcept;

/// The same for time steps [s] > 0 that differ; an infinite one is a gap between two traces. A damper's force of one
/// step is held through the next. So step i needs k t_i/2 + |b|/2 (√(t_i+1/t_i) + √(t_i/t_i−1)), the sum of a row of
/// the tridiagonal form of the energy, and this is the largest: sufficient always, exact for even steps. The first and
/// the last step of a trace count at least as even ones do. With a delay the result is a bound, (N + ½)k times
/// the longest step plus the largest part of the damper, unless the steps are even.
[[nodiscard]] double device_damping_needed(double stiffness, double damping, std::span<const double> steps,
                                           int delay = 0) noexcept;

/// The longest delay that is checked [samples].
inline constexpr int most_delay = 1000;

/// Stability number of n fingers with spring k and damper b on a body under explicit steps (symplectic Euler): n(kT²/m
/// + 2bT/m)/4. The body is stable if the sum of two such numbers is below 1: that of k, b and the mass m which the
/// contact feels, 1/(1/m + r²/I) at a distance r from the centre of mass, and that of k_r, b_r and the moment of
/// inertia I. If one spring acts alone, this is exact: the polynomial z² − (2 − β − κ)z + 1 − β, κ = nkT²/m, β = nbT/m,
/// then has its roots within the unit circle. Of I take the smallest about an axis across r, for the twist the one
/// about the normal. Implicit steps have no such limit. All arguments > 0, the damping ≥ 0.
///
///     explicit_coupling(k, b, 1 / (1 / m + r * r / I), T) + explicit_coupling(k_r, b_r, I, T) < 1
[[nodiscard]] constexpr double explicit_coupling(double stiffness, double damping, double mass, double sample_time,
                                                 int fingers = 1) noexcept {
  return 0.25 * fingers * sample_time / mass * (stiffness * sample_time + 2.0 * damping);
}

/// Damping of a device.
struct DeviceDamping {
  double sliding;  ///< normal and tangential [N s/m]
  double twist;    ///< [N m s/rad]
};

/// The damping that a finger's springs and dampers need at a sample time [s] > 0 with a delay in samples. Throws
/// std::invalid_argument for a parameter out of range.
[[nodiscard]] DeviceDamping device_damping_needed(const FingerParameters& finger, double sample_time, int delay = 0);
[[nodiscard]] DeviceDamping device_damping_needed(const FingerParameters& finger, std::span<const double> steps,
                                                  int delay = 0);

/// Throws std::invalid_argument, with the missing damping and what to change, unless a device with this damping is
/// passive with these gains at this sample time [s] > 0 and delay [samples]. The bound holds for any user; a hand that
/// damps allows higher gains. An infinite damping leaves a channel unchecked.
void require_passive(const FingerParameters& finger, double sample_time, const DeviceDamping& device, int delay = 0);
/// The same for time steps that differ.
void require_passive(const FingerParameters& finger, std::span<const double> steps, const DeviceDamping& device,
                     int delay = 0);

}  // namespace limitcurve::godobject
