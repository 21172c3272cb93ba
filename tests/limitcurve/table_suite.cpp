// SPDX-License-Identifier: MIT
// What every law's table keeps, at every tolerance.
#include "table_errors.hpp"

#include <map>

namespace limitcurve {
namespace {

using test::exact_of;
using test::expect_convex_and_smooth;
using test::probe;
using test::worst_error;

/// A law, at all the tolerances that it is quick at.
struct TableCase {
  std::string law;
  std::vector<double> tolerances;
};

void PrintTo(const TableCase& test, std::ostream* stream) {
  *stream << test.law;
}

class TableSuite : public testing::TestWithParam<TableCase> {
 protected:
  /// Built once for all tests of this law.
  static const std::vector<Table>& tables_of(const Law& law) {
    static std::map<std::string, std::vector<Table>> known;
    std::vector<Table>& tables = known[GetParam().law];
    if (!tables.empty()) return tables;
    for (const double tolerance : GetParam().tolerances) tables.push_back(Table::build(law, tolerance));
    return tables;
  }
  const Law law_ = parse_law(GetParam().law);
  const double scale_ = std::max(1.0, law_->moment_ratio());
  const std::vector<Table>& tables_ = tables_of(law_);
};

TEST_P(TableSuite, CheckedErrorHoldsEverywhereAndIsNoLargerThanItNeedBe) {
  for (const Table& table : tables_) {
    EXPECT_LE(table.checked_error(), table.tolerance() * scale_);
    const double worst = worst_error(table, exact_of(law_), 10000);
    EXPECT_LE(worst, table.checked_error()) << table.tolerance();
    EXPECT_GE(worst, 0.3 * table.checked_error()) << table.tolerance();
  }
}

TEST_P(TableSuite, IsConvexAndContinuousWithItsNormal) {
  for (const Table& table : tables_) expect_convex_and_smooth(table);
}

TEST_P(TableSuite, EndsExactly) {
  for (const Table& table : tables_) {
    EXPECT_EQ(table.wrench({1.0, 0.0}), (UnitWrench{1.0, 0.0}));
    EXPECT_EQ(table.wrench({0.0, 1.0}), (UnitWrench{0.0, law_->moment_ratio()}));
    EXPECT_EQ(table.moment_ratio(), law_->moment_ratio());
    EXPECT_EQ(table.force_max(), 1.0);
  }
}

TEST_P(TableSuite, FindsByDirectionWhatItFindsByTwist) {
  std::mt19937_64 random(17);
  for (const Table& table : tables_) {
    for (int i = 0; i < 1000; ++i) {
      const UnitWrench wrench = table.wrench(probe(random, i));
      EXPECT_NEAR(table.gauge(wrench), 1.0, 1e-14);
      EXPECT_LE(test::apart(table.along({0.3 * wrench.force, 0.3 * wrench.moment}).wrench, wrench), 1e-14 * scale_);
    }
  }
}

TEST_P(TableSuite, ItsFileReadsBackTheSameBits) {
  for (const Table& table : tables_) {
    const TableCells cells = table.cells();
    EXPECT_EQ(cells.inside.size() + cells.outside.size(), table.cell_count());
    const std::string text = to_csv(table);
    const Table again = read_table_csv(text, "table.csv");
    EXPECT_EQ(to_csv(again), text);
    EXPECT_EQ(checksum(again), checksum(table));
    EXPECT_EQ(again.law_name(), table.law_name());
    EXPECT_EQ(again.checked_error(), table.checked_error());
    EXPECT_EQ(again.bytes(), table.bytes());
    for (const SlipTwist twist : test::probes()) EXPECT_EQ(again.wrench(twist), table.wrench(twist));
  }
}

TEST_P(TableSuite, IsSmall) {
  for (const Table& table : tables_)
    EXPECT_LE(table.bytes(), table.tolerance() >= 1e-8 ? 16384U : 65536U) << table.tolerance();
}

std::vector<TableCase> cases() {
  std::vector<TableCase> all;
  for (const char* law :
       {"hertz", "uniform", "parabolic", "flat-punch", "cone", "gaussian:sigma=0.4", "gaussian:sigma=1e-3",
        "gaussian:sigma=1e3", "mix:0.7*hertz+0.3*uniform"}) {  // quick at every tolerance
    all.push_back({law, {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}});
  }
  std::vector<std::string_view> slower{"power:n=1000", "power:n=-0.9", "xydas-kao:k=0.1", "xydas-kao:k=20"};
  for (const std::string_view law : law_examples()) {
    if (std::none_of(all.begin(), all.end(), [&](const TableCase& known) { return known.law == law; }))
      slower.push_back(law);
  }
  for (const std::string_view law : slower) all.push_back({std::string(law), {1e-1, 1e-2, 1e-4, 1e-8, 1e-10}});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Laws, TableSuite, testing::ValuesIn(cases()),
                         [](const auto& tested) { return test::test_name(tested.param.law); });

}  // namespace
}  // namespace limitcurve
