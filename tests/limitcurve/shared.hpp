// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limitcurve.hpp"
#include "tests/complaint.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

/// What the tests of this folder share: special values, differences of wrenches, slip twists.
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

/// The larger of |Δf| and |Δm| of what has both; NaN if either is.
template <class Found, class Exact>
double apart(const Found& found, const Exact& exact) {
  const auto force = std::fabs(static_cast<double>(found.force - exact.force));
  const auto moment = std::fabs(static_cast<double>(found.moment - exact.moment));
  return std::isnan(force + moment) ? nan : std::max(force, moment);
}

/// Whether force and moment are within their own bounds.
template <class Found, class Exact>
testing::AssertionResult are_near(const Found& found, const Exact& exact, UnitWrench within) {
  if (std::fabs(found.force - exact.force) <= within.force && std::fabs(found.moment - exact.moment) <= within.moment)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << found.force << ' ' << found.moment << " is not " << exact.force << ' '
                                     << exact.moment << " within " << within.force << ' ' << within.moment << ": ";
}
template <class Found, class Exact>
testing::AssertionResult are_near_in_relative_terms(const Found& found, const Exact& exact, double within) {
  return are_near(found, exact, {within * exact.force, within * exact.moment});
}

/// Slip twists from pure sliding to pure spin, the rim among them, and crowding to the rim and to both ends.
inline std::vector<SlipTwist> probes() {
  std::vector<SlipTwist> twists;
  for (int i = 0; i <= 1000; ++i) twists.push_back(SlipTwist::of_spin_fraction(i / 1000.0));
  for (double gap = 0.3; gap > 1e-17; gap *= 0.3)
    twists.insert(twists.end(), {{1.0 - gap, 1.0}, {1.0, 1.0 - gap}, {gap, 1.0}, {1.0, gap}});
  return twists;
}

}  // namespace limitcurve::test
