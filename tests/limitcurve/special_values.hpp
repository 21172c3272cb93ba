// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <limits>
#include <string>

namespace limitcurve::test {

inline constexpr double inf = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A law string as GoogleTest takes a name.
inline std::string test_name(std::string law) {
  for (char& c : law) {
    if (c == '-') c = 'm';
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return law;
}

}  // namespace limitcurve::test
