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

/// One ratio for all materials: the mean weighted by n/sd², and the contact radius that it implies under the law. With
/// n: standard errors, and a test of the assumption of one ratio, χ² = Σ n_i ((ratio_i − ratio)/sd_i)², its degrees of
/// freedom, and p_value, the probability of a larger χ² if the ratios differ only by their scatter; warns if it is
/// below 0.05. Without n a standard deviation says nothing of the error of a mean: the standard errors are NaN, χ² is n
/// times `chi_squared_per_n`, and p falls below 0.05 from n = `n_for_p_0.05` on (∞ if all ratios are equal). Cost:
/// below 1 ms. Throws std::invalid_argument for fewer than two samples, and for a bad sample, which it names.
FitReport fit_ratio(std::span<const RatioSample> samples, const PressureLaw& law);

}  // namespace limitcurve::fit
