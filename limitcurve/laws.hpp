// SPDX-License-Identifier: MIT
#pragma once

#include "pressure_law.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The pressure laws. Each factory checks its parameters and throws `std::invalid_argument`, which names the parameter, its value and its
/// range. The formula of each law is its pressure p(ρ)·πa²/P on 0 ≤ ρ = r/a ≤ 1; the pressure is zero outside. "Closed" and "ring" name the
/// evaluator (limitcurve/README.md).
namespace limitcurve {

/// (3/2)(1−ρ²)^½: elastic sphere (Hertz 1882). Closed.
Law hertz();
/// 1: soft pad, uniform pressure. Closed.
Law uniform();
/// 2(1−ρ²): elastic foundation (Winkler). Closed.
Law parabolic();
/// ½(1−ρ²)^(−½): rigid flat punch on an elastic half-space (Boussinesq). Closed.
Law flat_punch();
/// arccosh(1/ρ): rigid cone on an elastic half-space (Love 1939). Closed.
Law cone();
/// 1/(2ρ): a clutch, brake or pad worn in by rotation, so that pressure times speed is the same everywhere. Ring. The pressure is infinite
/// at the centre: as s → 0, f → (s/2)(ln(4/s) + ½), whose slope grows without bound (at 0 it is that of the smallest s). The methods ring,
/// direct and boost, if asked for by name, leave out the load within 1e-80 of the centre, which changes f below s = 1e-30.
Law uniform_wear();
/// (n+1)(1−ρ²)ⁿ, n ∈ (−1, 1000]. Closed: ₂F₁ by its Euler integral, whose integrand is positive for all n. n → −1: all pressure on the rim.
Law power(double n);
/// C_k(1−ρᵏ)^{1/k}, k ∈ [0.01, 10⁶] (Xydas and Kao 1999). Ring.
Law xydas_kao(double k);
/// exp(−ρ²/2σ²)/(2σ²), σ ∈ [10⁻⁶, 10⁶] in units of a. This law has no rim: a is only a unit of length. Closed (Bessel).
Law gaussian(double sigma);
/// Σ wᵢ pᵢ, weights in (0, 10¹²], scaled to sum 1. f and m are linear in the pressure, so each part is evaluated by its own best method.
/// Throws for an empty list, too.
Law mixture(std::span<const std::pair<double, Law>> parts);

/// A measured pressure: radius [any unit], pressure [any unit].
struct PressureSample {
  double radius;
  double pressure;
};

/// A measured pressure profile, scaled to load 1. Evaluated by ring, piece by piece.
///  - Between samples: a monotone cubic, which does not overshoot (Fritsch and Carlson 1980; slopes by Fritsch and Butland 1984).
///  - From the centre to the first radius: the pressure of the first sample.
///  - Two samples at the same radius: a jump. A repeated sample is ignored.
///  - `rim`: the radius, in the unit of the samples, that the contact radius a stands for; 0 for the last radius with pressure. That is
///    wrong if noise or an offset of the sensor goes on beyond the contact: no rule finds the true rim, and `remarks` warns. If you name
///    the rim, pressure beyond a sample without pressure that carries the fraction ε of the load changes a force by at most ε μP and a
///    moment by at most ε μP max(r, mean radius of the load), r being where it ends.
///  - Negative pressures are noise: pressures up to 1.5 times the most negative count as 0, and `remarks` counts them. Rejected if they
///    carry more than 2 % of the load, or if the most negative is above 10 % of the largest pressure.
///
/// The error that `evaluate` returns includes the interpolation error. It is estimated by a bound on the change of the wrench if samples
/// are left out (every other one of even radii), and exceeds the true error wherever the samples resolve the profile. `source` names the
/// data in `name()`.
/// Throws std::invalid_argument for fewer than 4 samples, a number that is not finite, a radius that is negative, smaller than the one
/// before or nearer to it than 1e-9 of the last radius (two may be equal, but not the last two), a rim beyond 1e-3 to 1e3 times the last
/// radius, and a profile without pressure.
Law samples(std::span<const PressureSample> rows, std::string_view source, double rim = 0.0);

/// The law with the name `text`: `hertz uniform parabolic flat-punch cone uniform-wear power:n=2.3 xydas-kao:k=3
/// gaussian:sigma=0.4 mix:0.7*hertz+0.3*uniform`. Throws `std::invalid_argument`, which quotes the text and says what was expected.
Law parse_law(std::string_view text);

/// One law string for each kind, with an example parameter: the strings above.
std::span<const std::string_view> law_examples();

}  // namespace limitcurve
