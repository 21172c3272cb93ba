// SPDX-License-Identifier: MIT
#include "limitcurve/float_table.hpp"
#include "limitcurve/laws.hpp"
#include "tests/limitcurve/table_case.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace limitcurve {
namespace {

using test::table_case_name;
using test::TableCase;

constexpr float epsilon = std::numeric_limits<float>::epsilon();

/// What a law says to a twist that is given in floats.
UnitForces<double> exact_forces(const Law& law, FloatTwist twist) {
  return law->forces(static_cast<double>(twist.slide) / static_cast<double>(twist.spin));
}

class FloatTableSuite : public testing::TestWithParam<TableCase> {
 protected:
  const Law law_ = parse_law(GetParam().law);
  const FloatTable table_ = FloatTable::build(law_, GetParam().tolerance);
};

TEST_P(FloatTableSuite, ErrorIsCertifiedRoundingIncluded) {
  EXPECT_LE(table_.certified_error(), GetParam().tolerance);
  std::mt19937_64 random(20060325);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 6000; ++i) {
    // Evenly in the spin fraction, crowding to the rim, and crowding to both ends.
    const double tiny = std::pow(10.0, -7.0 * unit(random));
    const double u = i % 3 == 0 ? unit(random) : i % 3 == 1 ? 0.5 + (i % 2 == 0 ? 0.25 : -0.25) * tiny : i % 2 == 0 ? tiny : 1.0 - tiny;
    const FloatTwist twist{static_cast<float>(1.0 - u), static_cast<float>(u)};
    const UnitForces<double> exact = exact_forces(law_, twist);
    const FloatWrench read = table_.float_wrench(twist);
    worst = std::max(
        {worst, std::fabs(static_cast<double>(read.force) - exact.force), std::fabs(static_cast<double>(read.moment) - exact.moment)});
  }
  EXPECT_LE(worst, table_.certified_error());
  // A certificate ten times too large would hide a table that is larger than it need be.
  EXPECT_GE(worst, 0.1 * table_.certified_error());
}

TEST_P(FloatTableSuite, IsExactAtTheEnds) {
  const auto moment_ratio = static_cast<float>(law_->moment_ratio());
  EXPECT_EQ(table_.float_wrench(FloatTwist{0.0F, 1.0F}), (FloatWrench{0.0F, moment_ratio}));
  EXPECT_EQ(table_.float_wrench(FloatTwist{1.0F, 0.0F}), (FloatWrench{1.0F, 0.0F}));
  EXPECT_EQ(table_.wrench(SlipTwist{0.0, 1.0}), (UnitWrench{0.0, static_cast<double>(moment_ratio)}));
  EXPECT_EQ(table_.wrench(SlipTwist{1.0, 0.0}), (UnitWrench{1.0, 0.0}));
  EXPECT_EQ(table_.moment_ratio(), static_cast<double>(moment_ratio));
}

// The moment far out and the force of a near twist are small numbers, and right to four roundings all the same.
TEST_P(FloatTableSuite, KeepsItsDigitsTowardsTheEnds) {
  for (const float tiny : {1e-8F, 1e-12F, 3e-20F, 1e-30F, 1e-36F}) {
    const FloatTwist slide{1.0F, tiny};
    const FloatTwist spin{tiny, 1.0F};
    EXPECT_NEAR(static_cast<double>(table_.float_wrench(slide).moment) / exact_forces(law_, slide).moment, 1.0,
                4.0 * static_cast<double>(epsilon))
        << tiny;
    EXPECT_NEAR(static_cast<double>(table_.float_wrench(spin).force) / exact_forces(law_, spin).force, 1.0,
                4.0 * static_cast<double>(epsilon))
        << tiny;
  }
}

TEST_P(FloatTableSuite, IsMonotoneToARounding) {
  FloatWrench before = table_.float_wrench(FloatTwist{1.0F, 0.0F});
  constexpr int steps = 20'000;
  for (int i = 1; i <= steps; ++i) {
    const float u = static_cast<float>(i) / static_cast<float>(steps);
    const FloatWrench here = table_.float_wrench(FloatTwist{1.0F - u, u});
    ASSERT_LE(here.force, before.force + epsilon) << u;
    ASSERT_GE(here.moment, before.moment - epsilon) << u;
    before = here;
  }
}

// In double arithmetic it is a boundary like any other, but for the rounding of its coefficients, by which its cells miss each other.
TEST_P(FloatTableSuite, IsALimitBoundary) {
  constexpr double rounding = 1.5e-7;
  for (int i = 0; i <= 1000; ++i) {
    const SlipTwist twist = SlipTwist::of_spin_fraction(i / 1000.0);
    const UnitWrench wrench = table_.wrench(twist);
    EXPECT_EQ(table_.point(twist).wrench, wrench);
    EXPECT_NEAR(table_.gauge(wrench), 1.0, rounding / std::min(1.0, wrench.force + wrench.moment));
    const UnitWrench again = table_.along({7.0 * wrench.force, 7.0 * wrench.moment}).wrench;
    EXPECT_NEAR(again.force, wrench.force, rounding);
    EXPECT_NEAR(again.moment, wrench.moment, rounding);
    const FloatTwist rounded{static_cast<float>(twist.slide), static_cast<float>(twist.spin)};
    const FloatWrench single = table_.float_wrench(rounded);
    const UnitWrench there = table_.wrench(SlipTwist{static_cast<double>(rounded.slide), static_cast<double>(rounded.spin)});
    EXPECT_NEAR(static_cast<double>(single.force), there.force, FloatTable::finest_tolerance);
    EXPECT_NEAR(static_cast<double>(single.moment), there.moment, FloatTable::finest_tolerance);
  }
}

std::vector<TableCase> cases() {
  std::vector<TableCase> all;
  for (const char* law : {"hertz", "uniform", "flat-punch", "cone", "power:n=-0.9", "power:n=40", "xydas-kao:k=3", "gaussian:sigma=0.3"}) {
    for (const double tolerance : {1e-1, 1e-3, 1e-6, 5e-7}) all.push_back({law, tolerance});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Laws, FloatTableSuite, testing::ValuesIn(cases()), table_case_name);

// Not sampled: every float of an octave on each side of the rim; in a short build one of 97.
TEST(FloatTable, NoFloatNextToTheRimIsBeyondTheCertificate) {
  const Law law = hertz();
  const Table fine = Table::build(law, 1e-10);
  const FloatTable table(fine, 1e-6);
  double worst = 0.0;
  constexpr int stride = tests_are_short ? 97 : 1;
  for (int i = 0; i <= 1 << 23; i += stride) {
    const float x = 0.5F + 0x1p-24F * static_cast<float>(i);
    for (const FloatTwist twist : {FloatTwist{x, 1.0F}, FloatTwist{1.0F, x}}) {
      const UnitWrench exact = fine.wrench({static_cast<double>(twist.slide), static_cast<double>(twist.spin)});
      const FloatWrench read = table.float_wrench(twist);
      worst = std::max(
          {worst, std::fabs(static_cast<double>(read.force) - exact.force), std::fabs(static_cast<double>(read.moment) - exact.moment)});
    }
  }
  EXPECT_LE(worst, table.certified_error());
  EXPECT_GE(worst, 0.5 * table.certified_error());
}

TEST(FloatTable, TakesHalfTheBytesOfATable) {
  for (const char* law : {"hertz", "uniform", "parabolic", "flat-punch", "cone", "xydas-kao:k=3"}) {
    const FloatTable table = FloatTable::build(parse_law(law), 1e-6);
    EXPECT_LE(table.bytes(), 1152U) << law;
    EXPECT_LE(table.bytes(), Table::build(parse_law(law), 1e-6).working_bytes()) << law;
  }
}

TEST(FloatTable, OnlyTheRatioOfATwistCounts) {
  const FloatTable table = FloatTable::build(hertz(), 1e-6);
  for (const float s : {0.1F, 0.9F, 1.0F, 1.7F, 30.0F}) {
    const FloatWrench wrench = table.float_wrench(FloatTwist{s, 1.0F});
    for (const float factor : {0x1p-100F, 0x1p-1F, 0x1p100F}) EXPECT_EQ(table.float_wrench(FloatTwist{factor * s, factor}), wrench) << s;
  }
}

TEST(FloatTable, RefusesTolerancesThatMeanNothing) {
  for (const double tolerance : {0.0, -1e-6, 1e-7, 0.2, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(FloatTable::build(hertz(), tolerance), std::invalid_argument) << tolerance;
  }
  // A table that is itself as wrong as the tolerance.
  EXPECT_THROW(FloatTable(Table::build(hertz(), 1e-4), 1e-4), std::invalid_argument);
}

}  // namespace
}  // namespace limitcurve
