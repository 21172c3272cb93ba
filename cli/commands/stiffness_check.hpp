// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"

#include <span>
#include <string_view>

namespace limitcurve::cli {

/// Notes on standard error, once, that the radial and the c-curve projection have a large error if k_r/k_l differs more than tenfold from
/// (μ_r/μ_l)² at one of the loads [N] > 0, and names the worst load. `subject` names the user of the projection, `moment_ratio` is m₀ of
/// the law. No note without torsion.
void note_stiffnesses(std::string_view subject, const godobject::FingerParameters& finger, double moment_ratio,
                      std::span<const double> loads);

}  // namespace limitcurve::cli
