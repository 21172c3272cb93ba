// SPDX-License-Identifier: MIT
#pragma once

#include "../law.hpp"

#include <span>
#include <string_view>

namespace limitcurve {

/// A measured pressure: radius [any unit], pressure [any unit].
struct PressureSample {
  double radius;
  double pressure;
};

/// A measured pressure profile, scaled to load 1. Evaluated by ring, piece by piece.
///
/// Between samples, the pressure is a monotone cubic, which does not overshoot (Fritsch and Carlson 1980; slopes by
/// Fritsch and Butland 1984). From the centre to the first radius, it is the pressure of the first sample. From the
/// last radius to a rim farther out it is 0, but the error includes that the pressure may go on as at the last radius;
/// `remarks` warns of these two. Two samples at the same radius make a jump; a repeated sample is ignored.
///
/// `rim` is the radius, in the unit of the samples, that the contact radius a stands for. If it is 0, the rim is the
/// last radius with pressure. That is wrong if noise or an offset of the sensor goes on beyond the contact. No rule can
/// find the true rim, so `remarks` warns. If you name the rim, pressure beyond a sample without pressure, which carries
/// the fraction ε of the load and ends at r, changes a force by at most ε μP and a moment by at most ε μP max(r, mean
/// radius of the load).
///
/// Negative pressures are noise, so pressures up to 1.5 times the most negative count as 0, and `remarks` counts them.
/// They are rejected if they carry more than 2 % of the load, or if the most negative is above 10 % of the largest
/// pressure.
///
/// The error that `evaluate` returns includes the error of interpolation. It is estimated by a bound on the change of
/// the wrench if samples are left out (every second if radii are even), and exceeds the true error wherever the samples
/// resolve the profile.
///
/// `source` names the data in `name()`. Throws std::invalid_argument if there are fewer than 4 samples, a number is not
/// finite, or the profile has no pressure. Radii must be ≥ 0 and must not fall; neighbours must be equal (but not the
/// last two) or differ by at least 1e-9 of the last radius. The rim must be 1e-3 to 1e3 times the last radius.
Law samples(std::span<const PressureSample> rows, std::string_view source, double rim = 0.0);

}  // namespace limitcurve
