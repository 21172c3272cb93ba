// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The pressure laws. Each factory validates and throws `std::invalid_argument` naming the parameter, its value and
/// its range. Formulae: p(ρ)·πa²/P on 0 ≤ ρ = r/a ≤ 1, zero outside.
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
/// (n+1)(1−ρ²)ⁿ, n ∈ (−1, 1000]: ₂F₁ by its Euler integral, of one sign for every n. n → −1 is the ring.
Law power(double n);
/// C_k(1−ρᵏ)^{1/k}, k ∈ [0.01, 10⁶] (Xydas and Kao 1999). By `ring`.
Law xydas_kao(double k);
/// exp(−ρ²/2σ²)/(2σ²), σ > 0 in units of a, which is then only a unit of length: there is no rim. Closed (Bessel).
Law gaussian(double sigma);
/// Σ wᵢ pᵢ with positive weights, scaled to sum 1: f and m are linear in the pressure.
Law mixture(std::span<const std::pair<double, Law>> parts);

/// A place of a measured profile: radius [any unit], pressure [any unit].
struct PressureSample {
  double radius;
  double pressure;
};

/// A measured profile, its last radius scaled to a and its pressure to load 1. Between samples a monotone cubic
/// (Fritsch and Carlson 1980) that never overshoots; up to the first radius the first pressure; two samples at one
/// radius make a jump, two equal ones are one; negative pressures, which are noise, count as zero. By `ring`, piece by piece.
///
/// The error that `evaluate` returns includes the interpolation: a bound of the distance to the wrench that every
/// other sample gives, which is above the error wherever the profile is resolved. Throws std::invalid_argument for fewer than 4 samples, radii
/// that decrease, are negative or nearer together than 1e-9 of the last (but not equal), what is not finite, or no pressure at all. `source` names the data in `name()`.
Law samples(std::span<const PressureSample> rows, std::string_view source);

/// Any pressure shape on 0 ≤ ρ ≤ breaks.back() (scaled to 1), analytic between the increasing `breaks` (from 0), finite,
/// ≥ 0; scaled to load 1. Kinks, jumps, rings and grooves that `breaks` leaves out are looked for and found (smooth_pieces.hpp) if they are
/// at least `narrowest_feature` wide, as a share of breaks.back(), in [1e-6, 1]: 0.01 % as it stands. A pressure too rough to be resolved has a
/// larger stated error in `evaluate`. What `breaks` names is found quicker, and for certain. Costs 25 to 150 / narrowest_feature evaluations of
/// `pressure`, and 1e5 for each kink or jump. `pressure` is called from const member functions: it must be safe to share between threads.
/// `name` is what `name()` returns; the grammar does not know it. Throws std::invalid_argument for no `pressure`, `breaks` that do not increase
/// from 0, a pressure that is not finite at one of them or carries no load, and a `narrowest_feature` out of its range.
Law from_pressure(std::string name, std::function<double(double)> pressure, std::span<const double> breaks,
                  double narrowest_feature = 1e-4);

/// The law named by `text`: `hertz uniform parabolic flat-punch cone power:n=2.3 xydas-kao:k=3 gaussian:sigma=0.4
/// mix:0.7*hertz+0.3*uniform`. Throws `std::invalid_argument` that names the place and what was expected.
Law parse_law(std::string_view text);

/// A law string as documentation shows it: one a kind, with an example parameter.
std::span<const std::string_view> law_examples();

}  // namespace limitcurve
