// SPDX-License-Identifier: MIT
#pragma once

/// Chances and quantiles of the distributions that fits need. No other file includes Boost's distributions, which are
/// slow to compile.
namespace limitcurve::fit::internal {

double chi_squared_chance(double freedom, double value);  ///< of a larger value
double chi_squared_bound(double freedom, double chance);  ///< that is exceeded with this chance
double student_quantile(double freedom, double share);
double fisher_chance(double freedom, double spare, double ratio);  ///< of a larger ratio

}  // namespace limitcurve::fit::internal
