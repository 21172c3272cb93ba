// SPDX-License-Identifier: MIT
#include "reference.hpp"
#include "../rows.hpp"
#include "limitcurve/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace limitcurve::test {

namespace {

std::vector<ReferenceRow> read_rows() {
  std::vector<ReferenceRow> rows;
  for (const std::vector<std::string>& cells : rows_of(LIMITCURVE_DATA_DIR "/reference/limit_curve.csv", 5)) {
    const auto number = [&](std::size_t i) { return std::strtold(cells[i].c_str(), nullptr); };
    rows.push_back({cells[0], std::strtod(cells[1].c_str(), nullptr), number(2), number(3), number(4)});
  }
  return rows;
}

}  // namespace

const std::vector<ReferenceRow>& reference_rows() {
  static const std::vector<ReferenceRow> rows = read_rows();
  return rows;
}

std::vector<std::string> reference_laws() {
  std::vector<std::string> laws;
  for (const ReferenceRow& row : reference_rows()) {
    if (std::find(laws.begin(), laws.end(), row.law) == laws.end()) laws.push_back(row.law);
  }
  return laws;
}

LoopBounds loop_bounds(const PressureLaw& law, double s) {
  const std::string name = law.name();
  const bool elementary =
      name == "hertz" || name == "uniform" || name == "parabolic" || name == "flat-punch" || name == "cone";
  if (elementary || name.starts_with("gaussian:")) return {accuracy::forces_closed, 1e-13};
  // A pressure steeper than rim^(−½) gives the slope a cusp at the rim, where one rounding of s moves it that much.
  if (law.rim_exponent() < -0.5L && std::fabs(s - 1.0) < 1e-6) return {accuracy::forces_by_quadrature, 1e-2};
  return {accuracy::forces_by_quadrature, 1e-12};
}

long double relative_error(double value, long double exact) {
  const long double difference = std::fabs(value - exact);
  if (difference <= std::numeric_limits<double>::denorm_min()) return 0.0L;
  return difference / std::fabs(exact);
}

}  // namespace limitcurve::test
