// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/internal/least_squares.hpp"
#include "fit/measurements.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// What the data say against a fit.
namespace limitcurve::fit::internal {

/// Number with three digits, for sentences.
std::string brief(double value);

/// Rows whose distance from the curve of a robust fit is beyond what the others' scatter explains: a normal error is as large in
/// one of 200 data sets. `noise` is what a unit of the residuals is, in limits. The scatter is the median's, with Rousseeuw's correction for few samples; without sigmas nothing
/// below a thousandth of the limits is gross.
std::vector<std::size_t> outliers_of(const Solution& robust, bool with_sigma, double noise);

/// Names the outliers (0 the first row), if there are any, after a fit by `loss`.
void warn_of_outliers(FitReport& report, const std::vector<std::size_t>& outliers, const Loss& loss);

/// If `gamma`, found with `spare` rows more than parameters and this rms, differs from the one assumed by more than chance explains in one of
/// 2000 data sets (Student's distribution).
void warn_of_growth(FitReport& report, double assumed, const Estimate& gamma, double spare, double rms);

}  // namespace limitcurve::fit::internal
