// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "tests/limitcurve/shared.hpp"

#include <bit>

namespace limitcurve::test {

namespace {

TEST(Number, EveryDoubleReadsBackExactly) {
  std::mt19937_64 random(20061);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = format_number(value);
    EXPECT_LE(text.size(), 24U);
    const auto read = parse_number(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*read), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(Number, IsWrittenAsShortAsItCan) {
  EXPECT_EQ(format_number(0.1), "0.1");
  EXPECT_EQ(format_number(99.0 / 128.0), "0.7734375");
  EXPECT_EQ(format_number(1e-300), "1e-300");
  EXPECT_EQ(format_number(0.0), "0");
  EXPECT_EQ(format_number(5e-324), "5e-324");
}

TEST(Number, WhatIsNotFiniteHasAName) {
  EXPECT_EQ(format_number(inf), "inf");
  EXPECT_EQ(format_number(-inf), "-inf");
  EXPECT_EQ(format_number(nan), "nan");
  EXPECT_EQ(format_number(-nan), "nan");
  EXPECT_EQ(parse_number("inf"), inf);
  EXPECT_EQ(parse_number("-inf"), -inf);
  ASSERT_TRUE(parse_number("nan"));
  EXPECT_TRUE(std::isnan(*parse_number("nan")));
}

TEST(Number, AcceptsWhatSpreadsheetsWrite) {
  EXPECT_EQ(parse_number("+2.5"), 2.5);
  EXPECT_EQ(parse_number("1E3"), 1000.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("-0"), 0.0);
}

TEST(Number, BeyondTheRangeIsTheNearestDouble) {
  EXPECT_EQ(parse_number("1e400"), inf);
  EXPECT_EQ(parse_number("-1e400"), -inf);
  EXPECT_EQ(parse_number("1e-400"), 0.0);
}

TEST(Number, RefusesWhatIsNotOneNumber) {
  for (const char* text : {"", " ", "1 ", " 1", "1,5", "1.5m", "0x10", "--1", "+-1", "++1", "1e", "e5", ".", "+", "-",
                           "1 2", "1\n", "nanx"}) {
    EXPECT_FALSE(parse_number(text)) << '"' << text << '"';
  }
}

TEST(Number, ComplaintHasNameValueUnitAndRange) {
  const std::string what = out_of_range("radius", -0.5, "m", "> 0").what();
  EXPECT_EQ(what, "radius = -0.5 m is out of range: expected > 0");
  EXPECT_EQ(std::string(out_of_range("n", -2.0, "1", "> -1").what()), "n = -2 is out of range: expected > -1");
}

}  // namespace

}  // namespace limitcurve::test
