// SPDX-License-Identifier: MIT
#include "limitcurve/chord_table.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "tests/limitcurve/table_case.hpp"
#include "tests/repetitions.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace limitcurve {
namespace {

using test::table_case_name;
using test::TableCase;

class ChordTableSuite : public testing::TestWithParam<TableCase> {
 protected:
  const Law law_ = parse_law(GetParam().law);
  const ChordTable table_ = ChordTable::build(law_, GetParam().tolerance);
};

TEST_P(ChordTableSuite, ErrorIsCertified) {
  EXPECT_LE(table_.certified_error(), GetParam().tolerance);
  EXPECT_EQ(table_.tolerance(), GetParam().tolerance);
  std::mt19937_64 random(20061103);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double worst = 0.0;
  const auto compare = [&](double u) {
    const SlipTwist twist = SlipTwist::of_spin_fraction(u);
    const UnitForces<double> exact = law_->forces(twist.cor());
    const UnitWrench read = table_.wrench(twist);
    worst = std::max({worst, std::fabs(read.force - exact.force), std::fabs(read.moment - exact.moment)});
  };
  for (int i = 0; i < (tests_are_short ? 4000 : 20'000); ++i) {
    // Evenly in the spin fraction, and crowding to the rim.
    const double tiny = std::pow(10.0, -12.0 * unit(random));
    compare(i % 2 == 0 ? unit(random) : 0.5 + (i % 4 == 1 ? 0.25 : -0.25) * tiny);
  }
  EXPECT_LE(worst, table_.certified_error());
  // A certificate far too large would hide a table that is larger than it need be.
  EXPECT_GE(worst, 0.5 * table_.certified_error());
}

TEST_P(ChordTableSuite, PromisesNoFrictionThatTheContactDoesNotBear) {
  const ExactCurve exact(law_);
  // The table that it is made from is within its error of the curve, in f and in m.
  const Table table = Table::build(law_, GetParam().tolerance / 8.0);
  const double slack = table.certified_error() * (1.0 + 1.0 / law_->moment_ratio()) + 1e-14;
  constexpr int steps = repetitions(2000, 200);
  for (int i = 0; i <= steps; ++i) {
    const UnitWrench wrench = table_.wrench(SlipTwist::of_spin_fraction(static_cast<double>(i) / steps));
    EXPECT_LE(exact.gauge(wrench), 1.0 + slack) << i;
    EXPECT_GE(wrench.force, 0.0) << i;
    EXPECT_GE(wrench.moment, 0.0) << i;
  }
}

TEST_P(ChordTableSuite, IsExactAtTheEndsAndMonotoneToARounding) {
  EXPECT_EQ(table_.wrench({1.0, 0.0}), (UnitWrench{1.0, 0.0}));
  EXPECT_EQ(table_.wrench({0.0, 1.0}), (UnitWrench{0.0, table_.moment_ratio()}));
  EXPECT_NEAR(table_.moment_ratio(), law_->moment_ratio(), 1e-15);
  UnitWrench before = table_.wrench({1.0, 0.0});
  constexpr int steps = tests_are_short ? 10'000 : 100'000;
  // Lines meet at nodes to a rounding of what they rise by.
  constexpr double rounding = 1e-10;
  for (int i = 1; i <= steps; ++i) {
    const UnitWrench here = table_.wrench(SlipTwist::of_spin_fraction(static_cast<double>(i) / steps));
    ASSERT_LE(here.force, before.force + rounding) << i;
    ASSERT_GE(here.moment, before.moment - rounding) << i;
    before = here;
  }
}

TEST_P(ChordTableSuite, CellsEndAtEvenSpinFractions) {
  ASSERT_TRUE(std::has_single_bit(table_.cell_count()));
  ASSERT_EQ(table_.cells().size(), table_.cell_count() + 1);
  EXPECT_EQ(table_.bytes(), 32 * table_.cells().size());
  const auto count = static_cast<double>(table_.cell_count());
  const std::size_t stride = tests_are_short ? 1 + table_.cell_count() / 1024 : 1;
  for (std::size_t i = 1; i < table_.cell_count(); i += stride) {
    const double u = static_cast<double>(i) / count;
    const UnitWrench node = table_.wrench(SlipTwist::of_spin_fraction(u));
    const UnitWrench below = table_.wrench(SlipTwist::of_spin_fraction(std::nextafter(u, 0.0)));
    ASSERT_NEAR(node.force, below.force, 1e-10) << i;
    ASSERT_NEAR(node.moment, below.moment, 1e-10) << i;
  }
}

std::vector<TableCase> cases() {
  // The finest have tens of thousands of cells, which are made anew for every test.
  const double finest = tests_are_short ? 1e-5 : ChordTable::finest_tolerance;
  std::vector<TableCase> all;
  for (const char* law : {"hertz", "uniform", "flat-punch", "cone", "power:n=40", "xydas-kao:k=3", "gaussian:sigma=0.3"}) {
    for (const double tolerance : {1e-1, 1e-3, finest}) all.push_back({law, tolerance});
  }
  // Nearly all of the pressure at the rim, where the curve then has almost a corner.
  for (const double tolerance : {1e-1, 1e-3, tests_are_short ? 1e-4 : 1e-5}) all.push_back({"power:n=-0.9", tolerance});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Laws, ChordTableSuite, testing::ValuesIn(cases()), table_case_name);

TEST(ChordTable, NumbersThatAreNoneReadNoMemoryButItsOwn) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double largest = std::numeric_limits<double>::max();
  const ChordTable table = ChordTable::build(hertz(), 1e-3);
  for (const SlipTwist twist : {SlipTwist{nan, 1.0}, SlipTwist{1.0, nan}, SlipTwist{infinity, infinity}, SlipTwist{1.0, infinity}}) {
    EXPECT_TRUE(std::isnan(table.wrench(twist).force));
    EXPECT_TRUE(std::isnan(table.wrench(twist).moment));
  }
  EXPECT_EQ(table.wrench({infinity, 1.0}), (UnitWrench{1.0, 0.0}));
  // Sums that overflow are as far as a twist may go: as if it slid.
  EXPECT_EQ(table.wrench({largest, largest}), (UnitWrench{1.0, 0.0}));
  EXPECT_EQ(table.wrench({5e-324, 0.0}), (UnitWrench{1.0, 0.0}));
  EXPECT_EQ(table.wrench({0.0, 5e-324}), (UnitWrench{0.0, table.moment_ratio()}));
}

TEST(ChordTable, RefusesWhatItCannotKeep) {
  EXPECT_THROW(ChordTable::build(hertz(), 0.9e-7), std::invalid_argument);
  EXPECT_THROW(ChordTable::build(hertz(), 0.11), std::invalid_argument);
  EXPECT_THROW(ChordTable::build(hertz(), std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(ChordTable(Table::build(hertz(), 1e-3), 1e-4), std::invalid_argument);
  try {
    static_cast<void>(ChordTable::build(parse_law("power:n=-0.9"), 1e-7));
    FAIL() << "a corner in so few cells";
  } catch (const std::runtime_error& refused) {
    EXPECT_NE(std::string(refused.what()).find("power:n=-0.9"), std::string::npos) << refused.what();
  }
}

// Cells are doubled until they suffice: four times as many for a sixteenth of the tolerance, but for that factor.
TEST(ChordTable, CellsGrowWithTheRootOfTheTolerance) {
  for (const char* law : {"hertz", "uniform", "xydas-kao:k=3", "power:n=2.3"}) {
    const std::size_t coarse = ChordTable::build(parse_law(law), 1e-3).cell_count();
    const std::size_t fine = ChordTable::build(parse_law(law), 1e-7).cell_count();
    EXPECT_LE(fine, 256 * coarse) << law;
    EXPECT_GE(fine, 25 * coarse) << law;
  }
}

}  // namespace
}  // namespace limitcurve
