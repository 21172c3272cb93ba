// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/pressure_law.hpp"
#include "estimate.hpp"

#include <span>

namespace limitcurve::fit {

/// μ_r/μ_l of one material, as published: a row of a file with the columns `ratio,ratio_sd` and perhaps `n`. Its
/// standard error is sd/√n.
struct RatioSample {
  double ratio = 0.0;  ///< mean of n measurements [m] > 0
  double sd = 0.0;     ///< their standard deviation [m] > 0
  double n = 0.0;      ///< how many they are, ≥ 1; 0: not known, which then holds for all samples
};

/// Fits a single ratio to all materials, the mean weighted by n/sd², and gives the contact radius that the ratio
/// implies under the law. If you know n, you also get standard errors and a test whether a single ratio explains all
/// materials. The test is χ² = Σ n_i ((ratio_i − ratio)/sd_i)² with the degrees of freedom and p_value, the probability
/// of a larger χ² if the ratios differ only by scatter; p_value below 0.05 gives a warning. Without n, a standard
/// deviation says nothing about the error of a mean. So the standard errors are NaN, χ² is n times `chi_squared_per_n`,
/// and p falls below 0.05 from n = `n_for_p_0.05` on (∞ if all ratios are equal). Cost: below 1 ms. Throws
/// std::invalid_argument if there are fewer than two samples, or if a sample is bad, which the message names.
FitReport fit_ratio(std::span<const RatioSample> samples, const PressureLaw& law);

}  // namespace limitcurve::fit
