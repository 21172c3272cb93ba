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
///  - Between samples: a monotone cubic, which does not overshoot (Fritsch and Carlson 1980; slopes by Fritsch and
///  Butland 1984).
///  - From the centre to the first radius the pressure is that of the first sample. From the last radius to a rim
///  farther out it is 0, and the error includes that it may go on as at the last radius. `remarks` warns of both.
///  - Two samples at the same radius make a jump. A repeated sample is ignored.
///  - `rim`: the radius, in the unit of the samples, that the contact radius a stands for; 0 for the last radius with
///  pressure. That is
///    wrong if noise or an offset of the sensor goes on beyond the contact: no rule finds the true rim, and `remarks`
///    warns. If you name the rim, pressure beyond a sample without pressure that carries the fraction ε of the load
///    changes a force by at most ε μP and a moment by at most ε μP max(r, mean radius of the load), r being where it
///    ends.
///  - Negative pressures are noise: pressures up to 1.5 times the most negative count as 0, and `remarks` counts them.
///  Rejected if they
///    carry more than 2 % of the load, or if the most negative is above 10 % of the largest pressure.
///
/// The error that `evaluate` returns includes the interpolation error. That error is estimated by a bound on the change
/// of the wrench if samples are left out (every second if radii are
/// even), and exceeds the true error wherever the samples resolve the
/// profile. `source` names the data in `name()`. Throws std::invalid_argument if there are fewer than 4 samples, a
/// number is not finite, or the profile has no pressure. Radii must be ≥ 0 and must not fall; neighbours must be equal
/// (but not the last two) or differ by at least 1e-9 of the last radius. The rim must be 1e-3 to 1e3 times the last
/// radius.
Law samples(std::span<const PressureSample> rows, std::string_view source, double rim = 0.0);

}  // namespace limitcurve
