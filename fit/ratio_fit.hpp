// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/pressure_law.hpp"
#include "estimate.hpp"

#include <span>

namespace limitcurve::fit {

/// μ_r/μ_l of one material, as published: a row of a file with the columns `ratio,ratio_sd`.
struct RatioSample {
  double ratio = 0.0;  ///< [m] > 0
  double sigma = 0.0;  ///< its standard deviation [m] > 0
};

/// One ratio for all materials: the mean weighted by 1/σ², with its standard error, and the contact radius that it implies under the law.
/// A test of the assumption of one ratio: χ² = Σ((ratio_i − ratio)/σ_i)², its degrees of freedom n − 1, and p_value, the probability of a
/// larger χ² if the ratios differ only by their scatter. Warns if p_value is below 0.05. Throws std::invalid_argument for fewer than two
/// samples, and for a bad sample, which it names. Cost: below 1 ms.
FitReport fit_ratio(std::span<const RatioSample> samples, const PressureLaw& law);

}  // namespace limitcurve::fit
