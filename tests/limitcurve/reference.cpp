// SPDX-License-Identifier: MIT
#include "reference.hpp"

#include "limitcurve/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace limitcurve::test {

namespace {

std::vector<ReferenceRow> read_rows() {
  const std::string path = LIMITCURVE_DATA_DIR "/reference/limit_curve.csv";
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::vector<ReferenceRow> rows;
  std::string line;
  bool header_seen = false;
  for (int number = 1; std::getline(file, line); ++number) {
    if (line.empty() || line[0] == '#') continue;
    if (!header_seen) {
      if (line != "law,c_over_a,force,moment,force_slope")
        throw std::runtime_error(path + ": unexpected header: " + line);
      header_seen = true;
      continue;
    }
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    if (cells.size() != 5) throw std::runtime_error(path + ":" + std::to_string(number) + ": expected 5 cells");
    const auto number_in = [&](std::size_t i) {
      char* end = nullptr;
      const long double value = std::strtold(cells[i].c_str(), &end);
      if (cells[i].empty() || *end != '\0')
        throw std::runtime_error(path + ":" + std::to_string(number) + ": not a number: " + cells[i]);
      return value;
    };
    rows.push_back({cells[0], std::strtod(cells[1].c_str(), nullptr), number_in(2), number_in(3), number_in(4)});
  }
  if (rows.empty()) throw std::runtime_error(path + ": no rows");
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
