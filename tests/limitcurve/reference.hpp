// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <string>
#include <vector>

namespace limitcurve::test {

/// A line of data/reference/limit_curve.csv: values of 30 digits that mpmath made, not the library.
struct ReferenceRow {
  std::string law;
  double s = 0.0;
  long double force = 0.0L;
  long double moment = 0.0L;
  long double force_slope = 0.0L;
};

/// All rows.
const std::vector<ReferenceRow>& reference_rows();

/// The laws of the file, each once.
std::vector<std::string> reference_laws();

/// Promised by PressureLaw::forces: relative errors of wrench and slope at s.
struct LoopBounds {
  double wrench;
  double slope;
};
LoopBounds loop_bounds(const PressureLaw& law, double s);

/// |value/exact − 1|; below the smallest double there is only absolute precision.
long double relative_error(double value, long double exact);

}  // namespace limitcurve::test
