// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/messages.hpp"

#include "godobject/finger.hpp"

#include <span>
#include <string>

namespace limitcurve::cli {

/// Notes, once, that the radial and the c-curve projection have a large error if k_r/k_l, with the dampers of a time
/// step [s] (0: without), differs more than tenfold from (μ_r/μ_l)² at one of the loads [N] > 0, and names the worst
/// load. `subject` names the user of the projection, `moment_ratio` is m₀ of the law. No note without torsion.
void note_stiffnesses(Messages& messages, const std::string& subject, const godobject::FingerParameters& finger,
                      double time_step, double moment_ratio, std::span<const double> loads);

}  // namespace limitcurve::cli
