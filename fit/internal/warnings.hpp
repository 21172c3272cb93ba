// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/internal/least_squares.hpp"
#include "fit/measurements.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// Warnings about a fit.
namespace limitcurve::fit::internal {

/// "row 3", or "rows 3, 17 and 2 more".
std::string listed(const char* one, const char* several, const std::vector<std::size_t>& places);

/// The numbers by which messages name the samples at these places (0 is the first).
template <class Samples>
std::vector<std::size_t> names_of(const Samples& samples, std::vector<std::size_t> places) {
  for (std::size_t& place : places) place = samples[place].row > 0 ? samples[place].row : place + 1;
  return places;
}

/// Rows whose distance from the curve of a robust fit is larger than the scatter of the others explains: a normal error
/// reaches it in one of 200 data sets. `noise` is the unit of the residuals, in limits. The scatter comes from the
/// median, with Rousseeuw's correction for few samples. Without sigmas nothing below a thousandth of the limits is
/// gross.
std::vector<std::size_t> outliers_of(const Solution& robust, bool with_sigma, double noise);

/// Adds a warning with the outliers, if any, of a fit with `loss`.
void warn_of_outliers(FitReport& report, const std::vector<std::size_t>& rows, const Loss& loss);

/// Warns if more than 5 % of the rows lie inside the curve by more than half of the limits (`distances` from it are
/// relative to them). Rows that were taken while the finger held are no slips.
void warn_of_rows_inside(FitReport& report, std::span<const double> distances);

/// Warns if the residuals, in standard deviations as given, scatter more or less than those say by more than chance.
void warn_of_scatter(FitReport& report, const Solution& solution, const Loss& loss, bool with_sigma);

/// Throws if a parameter's standard error is more than half of its range.
void refuse_hidden(const Parameter& parameter, double variance);

/// Warns if a parameter ends at the end of its range.
void warn_of_end(FitReport& report, const Parameter& parameter, double value);

/// Adds a warning if `gamma`, fitted with `spare` more rows than parameters and this rms, differs from the assumed
/// gamma by more than chance gives in one of 2000 data sets (Student's distribution).
void warn_of_growth(FitReport& report, double assumed, const Estimate& gamma, double spare, double rms);

}  // namespace limitcurve::fit::internal
