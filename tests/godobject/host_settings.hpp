// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cfenv>
#include <functional>
#include <string>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace limitcurve::godobject::test {

/// What a host may set.
struct Setting {
  std::string name;
  std::function<void()> set;
};

inline std::vector<Setting> settings() {
  const auto rounding = [](std::string name, int how) {
    return Setting{std::move(name), [how] { EXPECT_EQ(std::fesetround(how), 0); }};
  };
  return {
    rounding("downward", FE_DOWNWARD), rounding("upward", FE_UPWARD), rounding("toward zero", FE_TOWARDZERO),
#if defined(__SSE2__)
    {
      "no subnormals", [] { _mm_setcsr(_mm_getcsr() | 0x8040); }  // FTZ and DAZ
    }
#endif
  };
}

/// What `body` gives under a setting, which then ends.
template <class Body>
auto under(const Setting& setting, Body&& body) {
#if defined(__SSE2__)
  const unsigned before = _mm_getcsr();
#endif
  setting.set();
  auto result = body();
  std::fesetround(FE_TONEAREST);
#if defined(__SSE2__)
  _mm_setcsr(before);
#endif
  return result;
}

}  // namespace limitcurve::godobject::test
