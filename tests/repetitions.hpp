// SPDX-License-Identifier: MIT
// Tests that do a thing many times do it less often where every step is slow: in a build with LIMITCURVE_TESTS_SHORT,
// as those with a sanitizer are. A sanitizer sees in a hundredth of the steps what it would see in all of them; the
// numbers are checked by the other builds, which do everything.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace limitcurve {

#ifdef LIMITCURVE_TESTS_SHORT
inline constexpr bool tests_are_short = true;
#else
inline constexpr bool tests_are_short = false;
#endif

/// How often this build does what is done `full` times: as often, or a hundredth of it, but no less than `least`.
constexpr int repetitions(int full, int least = 1) {
  return tests_are_short ? std::max(full / 100, least) : full;
}

/// Whether a study runs over all its cases, as in scripts/maintain/nightly: LIMITCURVE_WHOLE=1 in the environment.
inline bool studies_are_whole() {
  const char* const text = std::getenv("LIMITCURVE_WHOLE");
  return text != nullptr && text[0] == '1';
}

/// How many of its `whole` seeded cases a study takes: all, or a tenth, but no less than `least`.
inline int study_cases(int whole, int least = 10) {
  return repetitions(studies_are_whole() ? whole : std::max(whole / 10, least), least);
}

}  // namespace limitcurve
