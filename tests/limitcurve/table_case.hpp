// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <string>

namespace limitcurve::test {

/// What a table of any kind is made of.
struct TableCase {
  std::string law;
  double tolerance;
};

/// The law, and the digits of the tolerance: hertz_1em6, gaussian_sigma_0_3_5em7.
inline std::string table_case_name(const testing::TestParamInfo<TableCase>& info) {
  const double tolerance = info.param.tolerance;
  const long exponent = std::lround(std::floor(std::log10(tolerance) + 1e-9));
  const long leading = std::lround(tolerance / std::pow(10.0, static_cast<double>(exponent)));
  std::string name = info.param.law + '_' + std::to_string(leading) + "em" + std::to_string(-exponent);
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

}  // namespace limitcurve::test
