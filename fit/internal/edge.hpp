// SPDX-License-Identifier: MIT
#pragma once

#include "fit/contact_fit.hpp"

#include <span>

namespace limitcurve::fit::internal {

/// The limits that the wrenches of a log reach and never exceed, `Loss::edge`: no row has to be marked as a slip.
///
/// Each row is at the limit with probability p, or anywhere below it; its noise is known up to a factor k. With s the
/// gauge of the exact curve (1 on it), e = s − 1 and σ = √((k σ_s)² + 0.003²), σ_s from sigma_force and sigma_moment
/// along the gauge's gradient, the likelihood of a row is
///   s [p φ(e/σ)/σ + (1 − p) (Φ((e + 1)/σ) − Φ(e/σ)) + 10⁻³/(1 + e²)]:
/// a normal error about the limit, the same folded with a uniform wrench below it, and gross errors; the factor s is
/// the density of the wrench's logarithm, without which larger limits would make rows likelier. This is a stochastic
/// frontier with a share of efficient rows (Kumbhakar, Parmeter & Tsionas 2013, A zero inefficiency stochastic frontier
/// model, J. Econometrics 172:66–76) over a gauge in place of a production function. μ, μ_r (at the geometric mean
/// load), γ if free, p and k maximise it, from three envelopes of the rows.
///
/// Rows of one grip are not independent: the covariance is the sandwich of whole grips. The standard errors also have
/// half the difference of two halves of the grips, and 0.3 % of μ, 1 % of μ_r and 0.005 of γ, by which soft pads stop
/// before their limit (measured on brush models). That of γ has what an error of 1 % of the load makes, too.
///
/// Throws std::invalid_argument without sigmas or grips, for fewer than four grips, if more than 3 % of the rows lie
/// outside any such curve, if all slips turn about one centre, and if the loads of twists do not tell a free γ. Warns
/// if no sharp edge is found, if another γ than the assumed one fits better, if the halves differ, if few grips slip
/// one way (a limit is then what the wrench reached), and if only grips of the smallest or the largest loads reach the
/// limit. Cost: about 1 s for 5000 rows; of more than 6000 every n-th counts.
ContactFit fit_edge(std::span<const Sample> samples, const ContactModel& model, const ContactFitOptions& options);

}  // namespace limitcurve::fit::internal
