// SPDX-License-Identifier: MIT
// The truth of the study against mpmath's 30 digits.
#include "truth.hpp"
#include "../../../tests/limitcurve/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace limitcurve::stability {

namespace {

std::optional<ExactWrench> exact(const std::string& law, double s) {
  if (law == "hertz") return exact_hertz(s);
  if (law == "flat-punch") return exact_flat_punch(s);
  if (law == "cone") return exact_cone(s);
  const bool away_from_the_rim = s == 1.0 || std::fabs(s - 1.0) >= 1e-3;
  if (law == "uniform" && away_from_the_rim) return exact_power(0.0, s);
  if (law == "parabolic" && away_from_the_rim) return exact_power(1.0, s);
  if (law.starts_with("power:n=") && away_from_the_rim) return exact_power(std::stod(law.substr(8)), s);
  return std::nullopt;
}

TEST(Truth, AgreesWithTheReference) {
  int met = 0;
  for (const test::ReferenceRow& row : test::reference_rows()) {
    if (row.s == 0.0 || row.s > 1e20) continue;
    const std::optional<ExactWrench> truth = exact(row.law, row.s);
    if (!truth) continue;
    // The reference is read as long double.
    EXPECT_LE(static_cast<double>(abs(Exact(truth->force / row.force - 1))), 1e-18) << row.law << ' ' << row.s;
    EXPECT_LE(static_cast<double>(abs(Exact(truth->moment / row.moment - 1))), 1e-18) << row.law << ' ' << row.s;
    ++met;
  }
  EXPECT_GE(met, 200);
}

}  // namespace

}  // namespace limitcurve::stability
