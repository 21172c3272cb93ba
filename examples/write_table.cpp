// SPDX-License-Identifier: MIT
// Job 1, generate: writes a lookup table of a pressure law with a stated error, reads it back, and checks it between
// its nodes.
//     example_write_table [LAW [TOLERANCE]]
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/table_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>

int main(int argc, char** argv) try {
  const limitcurve::Law law = limitcurve::parse_law(argc > 1 ? argv[1] : "hertz");
  const double tolerance = argc > 2 ? std::strtod(argv[2], nullptr) : 1e-8;

  const limitcurve::Table table = limitcurve::Table::build(law, tolerance);
  const char* const path = "limit_curve_table.csv";
  std::ofstream(path) << limitcurve::to_csv(table);

  std::ifstream file(path);
  const limitcurve::Table read =
      limitcurve::read_table_csv(std::string(std::istreambuf_iterator<char>(file), {}), path);

  const limitcurve::ExactCurve exact(law);
  double worst = 0.0;
  for (int i = 0; i <= 10000; ++i) {
    const auto twist = limitcurve::SlipTwist::of_spin_fraction(i / 10000.0);
    const limitcurve::UnitWrench looked_up = read.wrench(twist);
    const limitcurve::UnitWrench right = exact.wrench(twist);
    worst = std::max({worst, std::abs(looked_up.force - right.force), std::abs(looked_up.moment - right.moment)});
  }
  std::printf("%s: %zu cells, %zu bytes, checked to %.2g; worst of 10001 lookups %.2g\n", path, read.cell_count(),
              read.bytes(), read.checked_error(), worst);
  return worst <= read.checked_error() && read.checked_error() <= tolerance ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "example_write_table: error: %s\n", error.what());
  return 2;
}
