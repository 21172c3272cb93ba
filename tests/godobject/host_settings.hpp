// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cfenv>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace limitcurve::godobject::test {

/// What a host may set, while it lives.
class Setting {
 public:
  virtual ~Setting() = default;
};

class Rounding final : public Setting {
 public:
  explicit Rounding(int how) { EXPECT_EQ(std::fesetround(how), 0); }
  ~Rounding() override { std::fesetround(FE_TONEAREST); }
};

#if defined(__SSE2__)
class NoSubnormals final : public Setting {
 public:
  NoSubnormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }  // FTZ and DAZ
  ~NoSubnormals() override { _mm_setcsr(before_); }

 private:
  unsigned before_;
};
#endif

struct NamedSetting {
  std::string name;
  std::function<std::unique_ptr<Setting>()> set;
};

inline std::vector<NamedSetting> settings() {
  const auto rounding = [](std::string name, int how) {
    return NamedSetting{std::move(name), [how] { return std::make_unique<Rounding>(how); }};
  };
  return {
    rounding("downward", FE_DOWNWARD), rounding("upward", FE_UPWARD), rounding("toward zero", FE_TOWARDZERO),
#if defined(__SSE2__)
    {
      "no subnormals", [] { return std::make_unique<NoSubnormals>(); }
    }
#endif
  };
}

}  // namespace limitcurve::godobject::test
