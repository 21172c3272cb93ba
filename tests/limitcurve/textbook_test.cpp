// SPDX-License-Identifier: MIT
// Where the closed forms as printed lose their digits, and ours do not. Drawn in docs/textbook_forms.svg.
#include "limitcurve/accuracy.hpp"
#include "limitcurve/quadrature/closed_form.hpp"
#include "reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace limitcurve::test {

namespace {

/// Moments for s > 1, as printed.
double textbook_moment(const std::string& law, double s) {
  const double angle = std::asin(1.0 / s);
  const double root = std::sqrt(s * s - 1.0);
  if (law == "hertz") return 3.0 / 64.0 * ((8.0 - 8.0 * s * s + 3.0 * s * s * s * s) * angle + 3.0 * (2.0 - s * s) * root);
  if (law == "flat-punch") return 0.5 * ((1.0 - 0.5 * s * s) * angle + 0.5 * root);
  if (law == "cone") {
    return (1.0 / 3.0 - 0.5 * s * s) * angle - root / 6.0 - 4.0 / 9.0 * root * root * root + 4.0 / 9.0 * s * s * s;
  }
  const double k = std::comp_ellint_1(1.0 / s);
  const double e = std::comp_ellint_2(1.0 / s);
  return 4.0 * s / (9.0 * std::numbers::pi) * ((4.0 - 2.0 * s * s) * e + (2.0 * s * s - 5.0 + 3.0 / (s * s)) * k);
}

double our_moment(const std::string& law, double s) {
  if (law == "hertz") return closed_form::hertz(s).moment;
  if (law == "flat-punch") return closed_form::flat_punch(s).moment;
  if (law == "cone") return static_cast<double>(closed_form::cone<Extended>(s).moment);
  return closed_form::uniform(s).moment;
}

/// The relative error of a printed form at s.
struct Cell {
  double s;
  long double error;
};

/// Rounding is luck: within a factor 100.
void expect_order(long double error, long double as_printed, const std::string& where) {
  EXPECT_GE(error, as_printed / 100) << where;
  EXPECT_LE(error, as_printed * 100) << where;
}

TEST(TextbookForms, LoseTheMomentFarFromTheContact) {
  const std::map<std::string, std::vector<Cell>> table{{"hertz", {{10.0, 5e-13L}, {100.0, 6e-9L}, {1e4, 0.1L}, {1e8, 1.0L}}},
                                                       {"uniform", {{10.0, 2e-12L}, {100.0, 1e-8L}, {1e4, 1.0L}, {1e8, 1.0L}}},
                                                       {"flat-punch", {{10.0, 3e-15L}, {100.0, 7e-13L}, {1e4, 4e-9L}, {1e8, 0.1L}}},
                                                       {"cone", {{10.0, 8e-12L}, {100.0, 7e-9L}, {1e4, 3.0L}}}};
  std::size_t met = 0;
  for (const ReferenceRow& row : reference_rows()) {
    const auto law = table.find(row.law);
    if (law == table.end() || !(row.s >= 1.0) || std::isinf(row.s)) continue;
    EXPECT_LE(relative_error(our_moment(row.law, row.s), row.moment), accuracy::evaluate_closed) << row.law << ' ' << row.s;
    for (const Cell& cell : law->second) {
      if (cell.s != row.s) continue;
      expect_order(relative_error(textbook_moment(row.law, row.s), row.moment), cell.error, row.law + " at " + std::to_string(row.s));
      ++met;
    }
  }
  EXPECT_EQ(met, 15U);
}

/// The uniform law's force at small s: (1 + s²)E + (s² − 1)K is a difference of numbers near π/2 that comes to 3πs²/4.
TEST(TextbookForms, LoseTheForceNearTheCentre) {
  const std::vector<Cell> table{{1e-12, 1.0L}, {1e-8, 0.06L}, {1e-4, 1e-9L}, {0.01, 3e-13L}};
  std::size_t met = 0;
  for (const ReferenceRow& row : reference_rows()) {
    if (row.law != "uniform" || row.s > 1.0) continue;
    EXPECT_LE(relative_error(closed_form::uniform(row.s).force, row.force), 1e-15L) << row.s;
    for (const Cell& cell : table) {
      if (cell.s != row.s) continue;
      const double k = std::comp_ellint_1(row.s);
      const double e = std::comp_ellint_2(row.s);
      const double s2 = row.s * row.s;
      const double textbook = 4.0 / (3.0 * std::numbers::pi * row.s) * ((1.0 + s2) * e + (s2 - 1.0) * k);
      expect_order(relative_error(textbook, row.force), cell.error, "uniform at " + std::to_string(row.s));
      ++met;
    }
  }
  EXPECT_EQ(met, table.size());
}

}  // namespace

}  // namespace limitcurve::test
