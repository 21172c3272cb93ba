// SPDX-License-Identifier: MIT
#pragma once

#include "pressure_law.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The pressure laws. A factory throws `std::invalid_argument` for a bad parameter, with the name, the value and the
/// range of the parameter. The formula of a law is the pressure p(ρ)·πa²/P on 0 ≤ ρ = r/a ≤ 1; the pressure is zero
/// outside. "Closed" and "ring" name the evaluator (limitcurve/README.md).
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
/// 1/(2ρ): a clutch, brake or pad worn in by rotation, so that pressure times speed is the same everywhere. Ring. The
/// pressure is infinite at the centre, so the slope of f → (s/2)(ln(4/s) + ½) grows without bound as s → 0 (at 0 you
/// get the slope at the smallest s). The methods ring, direct and boost, if asked for by name, leave out the load
/// within 1e-80 of the centre, which changes f below s = 1e-30.
Law uniform_wear();
/// (n+1)(1−ρ²)ⁿ, n ∈ (−1, 1000]. Closed: ₂F₁ by its Euler integral, whose integrand is positive for all n. n → −1: all
/// pressure on the rim.
Law power(double n);
/// C_k(1−ρᵏ)^{1/k}, k ∈ [0.01, 10⁶] (Xydas and Kao 1999). Ring.
Law xydas_kao(double k);
/// exp(−ρ²/2σ²)/(2σ²), σ ∈ [10⁻⁶, 10⁶] in units of a. This law has no rim: a is only a unit of length. Closed (Bessel).
Law gaussian(double sigma);
/// Σ wᵢ pᵢ, weights in (0, 10¹²], scaled to sum 1. f and m are linear in the pressure, so the best method for each part
/// evaluates that part. Throws for an empty list, too.
Law mixture(std::span<const std::pair<double, Law>> parts);

/// The law with the name `text`: `hertz uniform parabolic flat-punch cone uniform-wear power:n=2.3 xydas-kao:k=3
/// gaussian:sigma=0.4 mix:0.7*hertz+0.3*uniform`. Throws `std::invalid_argument`, which quotes the text and says what
/// was expected.
Law parse_law(std::string_view text);

/// One law string for each kind, with an example parameter: the strings above.
std::span<const std::string_view> law_examples();

}  // namespace limitcurve
