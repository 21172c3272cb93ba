// SPDX-License-Identifier: MIT
#include "limitcurve/table.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table_file.hpp"
#include "tests/limitcurve/table_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <string_view>

namespace limitcurve {
namespace {

using test::table_case_name;
using test::TableCase;

class TableSuite : public testing::TestWithParam<TableCase> {};

/// Slip twists that no table has for nodes: uniform, crowding to both ends, and crowding to the rim.
SlipTwist probe(std::mt19937_64& random, int i) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double sign = unit(random) < 0.5 ? -1.0 : 1.0;
  const double tiny = std::pow(10.0, -14.0 * unit(random));
  if (i % 3 == 0) return SlipTwist::about_cor(1.0 + sign * 0.5 * tiny);
  if (i % 3 == 1) return sign < 0.0 ? SlipTwist{tiny, 1.0} : SlipTwist{1.0, tiny};
  return SlipTwist::of_spin_fraction(unit(random));
}

TEST_P(TableSuite, ErrorIsCertifiedBetweenTheNodes) {
  const Law law = parse_law(GetParam().law);
  const Table table = Table::build(law, GetParam().tolerance);
  EXPECT_LE(table.certified_error(), GetParam().tolerance);
  std::mt19937_64 random(20060325);
  double worst = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const SlipTwist twist = probe(random, i);
    const UnitForces<double> exact = law->forces(twist.cor());
    const UnitWrench read = table.wrench(twist);
    worst = std::max({worst, std::fabs(read.force - exact.force), std::fabs(read.moment - exact.moment)});
  }
  EXPECT_LE(worst, table.certified_error());
  // A certificate ten times too large would hide a table that is larger than it need be.
  EXPECT_GE(worst, 0.1 * table.certified_error());
}

TEST_P(TableSuite, LooksUpByDirectionWhatItLooksUpByTwist) {
  const Table table = Table::build(parse_law(GetParam().law), GetParam().tolerance);
  std::mt19937_64 random(17);
  for (int i = 0; i < 1000; ++i) {
    const SlipTwist twist = probe(random, i);
    const UnitWrench wrench = table.wrench(twist);
    EXPECT_NEAR(table.gauge(wrench), 1.0, 1e-13);
    const RadialPoint found = table.along({0.3 * wrench.force, 0.3 * wrench.moment});
    EXPECT_NEAR(found.wrench.force, wrench.force, 1e-13);
    EXPECT_NEAR(found.wrench.moment, wrench.moment, 1e-13);
  }
}

TEST_P(TableSuite, IsConvexMonotoneAndInsideTheEllipse) {
  const Table table = Table::build(parse_law(GetParam().law), GetParam().tolerance);
  const double m0 = table.moment_ratio();
  UnitWrench before = table.wrench({1.0, 0.0});
  EXPECT_EQ(before, (UnitWrench{1.0, 0.0}));
  double turned = 0.0;
  constexpr int steps = 4000;
  for (int i = 1; i <= steps; ++i) {
    const UnitWrench here = table.wrench(SlipTwist::of_spin_fraction(i / static_cast<double>(steps)));
    EXPECT_LE(here.force, before.force);
    EXPECT_GE(here.moment, before.moment);
    EXPECT_LE(here.force * here.force + here.moment * here.moment / (m0 * m0), 1.0 + 4.0 * table.certified_error());
    // The chord's direction turns one way only.
    const double direction = std::atan2(before.force - here.force, here.moment - before.moment);
    EXPECT_GE(direction, turned - 1e-9) << "at u = " << i / static_cast<double>(steps);
    turned = direction;
    before = here;
  }
  EXPECT_EQ(before.force, 0.0);
  EXPECT_EQ(before.moment, m0);
}

TEST_P(TableSuite, DerivativesAreThoseOfItsCurve) {
  const Table table = Table::build(parse_law(GetParam().law), GetParam().tolerance);
  for (const double u : {0.01, 0.13, 0.37, 0.45, 0.55, 0.7, 0.93, 0.99}) {
    constexpr double step = 1e-6;
    const BoundaryPoint point = table.point(SlipTwist::of_spin_fraction(u));
    const UnitWrench after = table.wrench(SlipTwist::of_spin_fraction(u + step));
    const UnitWrench before = table.wrench(SlipTwist::of_spin_fraction(u - step));
    EXPECT_NEAR(point.slope.force, (after.force - before.force) / (2.0 * step), 2e-5);
    EXPECT_NEAR(point.slope.moment, (after.moment - before.moment) / (2.0 * step), 2e-5);
  }
}

TEST_P(TableSuite, SurvivesBeingWrittenAndRead) {
  const Table table = Table::build(parse_law(GetParam().law), GetParam().tolerance);
  const std::string text = to_csv(table);
  const Table read = read_table_csv(text, "table.csv");
  EXPECT_EQ(to_csv(read), text);
  EXPECT_EQ(read.law_name(), table.law_name());
  for (int i = 0; i <= 1000; ++i) {
    const SlipTwist twist = SlipTwist::of_spin_fraction(i / 1000.0);
    EXPECT_EQ(read.wrench(twist), table.wrench(twist));
  }
}

std::vector<TableCase> cases() {
  std::vector<TableCase> all;
  for (const char* law : {"hertz", "uniform", "flat-punch", "cone", "power:n=-0.9", "power:n=40", "xydas-kao:k=3", "gaussian:sigma=0.3",
                          "mix:0.7*hertz+0.3*uniform"}) {
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8}) all.push_back({law, tolerance});
  }
  for (const char* law : {"hertz", "parabolic", "uniform"}) all.push_back({law, 1e-10});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Laws, TableSuite, testing::ValuesIn(cases()), table_case_name);

TEST(Table, StaysWithinItsBudgetOfBytes) {
  for (const char* law : {"hertz", "uniform", "parabolic", "flat-punch", "cone", "xydas-kao:k=3"}) {
    const Table fine = Table::build(parse_law(law), 1e-8);
    EXPECT_LE(fine.bytes(), 4096U) << law;
    EXPECT_LE(fine.working_bytes(), 8192U) << law;
    EXPECT_LE(Table::build(parse_law(law), 1e-3).working_bytes(), 512U) << law;
  }
  for (const char* law : {"power:n=-0.99", "power:n=40", "xydas-kao:k=0.2", "xydas-kao:k=1000", "gaussian:sigma=0.1"}) {
    EXPECT_LE(Table::build(parse_law(law), 1e-8).bytes(), 65536U) << law;
    EXPECT_LE(Table::build(parse_law(law), 1e-3).bytes(), 512U) << law;
  }
}

TEST(Table, NodesGrowWithTheInverseFourthRootOfTheTolerance) {
  for (const char* law : {"hertz", "uniform", "flat-punch"}) {
    const auto coarse = static_cast<double>(Table::build(parse_law(law), 1e-6).node_count());
    const auto fine = static_cast<double>(Table::build(parse_law(law), 1e-10).node_count());
    EXPECT_LE(fine, 11.0 * coarse) << law;
  }
}

TEST(Table, RefusesTolerancesThatMeanNothing) {
  for (const double tolerance : {0.0, -1e-6, 1e-13, 0.2, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(Table::build(hertz(), tolerance), std::invalid_argument) << tolerance;
  }
}

TEST(Table, NormalIsTheExactOneToTheOrderOfTheSlopes) {
  // The slopes at the nodes are exact, so the COR that the table implies is far better than an ellipse's.
  const ExactCurve exact(hertz());
  const Table table = Table::build(hertz(), 1e-6);
  for (const double s : {0.05, 0.3, 0.8, 1.2, 3.0, 20.0}) {
    EXPECT_NEAR(table.along(exact.wrench(SlipTwist::about_cor(s))).normal.cor() / s, 1.0, 1e-3) << s;
  }
}

/// What complaint a damaged file gets.
std::string complaint(const std::string& text) {
  try {
    read_table_csv(text, "torn.csv");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

// Its first slope is next to nothing for its chord: the moment would rise above that of a pure twist, and turn as a convex curve does.
TEST(Table, RefusesASecondaryThatRisesBeforeItFalls) {
  EXPECT_THROW(TableSide({{0.0, 0.0, 0.785, 0.788e-83}, {1.0, 0.785, 0.3925, 1.785}}), std::invalid_argument);
  EXPECT_NO_THROW(TableSide({{0.0, 0.0, 0.785, 0.788}, {1.0, 0.785, 0.3925, 0.785}}));
}

// Whose square overflows. The slope that falls to nothing keeps it convex.
TEST(Table, RefusesAMomentThatNoPressureHas) {
  const Table table = Table::build(hertz(), 1e-2);
  TableNode rim = table.inside().nodes().back();
  rim.slope = 1e-266;
  try {
    const Table bent({"bent", 0.01, 0.01}, TableSide({{0.0, 0.0, 5e250, 0.9}, rim}), table.outside());
    ADD_FAILURE() << bent.moment_ratio();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string_view(error.what()).find("moment_ratio"), std::string_view::npos) << error.what();
  }
}

TEST(TableFile, EveryTornPrefixIsRefusedByPlace) {
  const std::string text = to_csv(Table::build(hertz(), 1e-3));
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_EQ(complaint(text.substr(0, length)).rfind("torn.csv:", 0), 0U) << "first " << length << " bytes";
  }
}

TEST(TableFile, EveryEditedDigitIsNoticed) {
  const std::string text = to_csv(Table::build(uniform(), 1e-2));
  const std::size_t nodes = text.find("inside,");
  int noticed = 0;
  for (std::size_t i = nodes; i < text.size(); ++i) {
    if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) continue;
    std::string edited = text;
    edited[i] = edited[i] == '9' ? '0' : static_cast<char>(edited[i] + 1);
    // The last of seventeen digits may change and still denote the same double.
    if (complaint(edited) == "none") {
      EXPECT_EQ(to_csv(read_table_csv(edited, "edited.csv")), text) << "byte " << i;
    } else {
      ++noticed;
    }
  }
  EXPECT_GT(noticed, 100);
}

TEST(TableFile, NamesWhatIsWrong) {
  EXPECT_NE(complaint("a,b\n1,2\n").find("not a table"), std::string::npos);
  std::string text = to_csv(Table::build(hertz(), 1e-3));
  const std::size_t law = text.find("hertz");
  std::string foreign = text;
  foreign.replace(law, 5, "HERTZ");
  EXPECT_NE(complaint(foreign).find("edited or damaged"), std::string::npos);
  text.replace(text.find("inside,0,0,"), 11, "inside,0,x,");
  EXPECT_NE(complaint(text).find("torn.csv:8:10: expected a number, got 'x'"), std::string::npos);
}

TEST(TableFile, JsonAndHeaderCarryTheSameChecksum) {
  const Table table = Table::build(hertz(), 1e-4);
  EXPECT_NE(to_json(table).find("\"" + checksum(table) + "\""), std::string::npos);
  EXPECT_NE(to_header(table).find(checksum(table)), std::string::npos);
}

}  // namespace
}  // namespace limitcurve
