// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"

#include <span>
#include <string_view>

namespace limitcurve::cli {

/// Says on standard error, once, that the radial and the c-curve projection are far from right where k_r/k_l is more than ten times away from
/// (μ_r/μ_l)² at a load [N] > 0: the worst is named. `subject` is what goes by them, `moment_ratio` the law's m₀. Nothing without torsion.
void note_stiffnesses(std::string_view subject, const godobject::FingerParameters& finger, double moment_ratio,
                      std::span<const double> loads);

}  // namespace limitcurve::cli
