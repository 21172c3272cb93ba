// SPDX-License-Identifier: MIT
#include "limitcurve/quadrature/evaluators.hpp"
#include "table_errors.hpp"
#include "tests/superellipse.hpp"

#include <bit>

namespace limitcurve {
namespace {

using test::complaint;
using test::exact_of;
using test::expect_convex_and_smooth;
using test::expect_mention;
using test::inf;
using test::nan;
using test::worst_error;

/// At 1e-14 the rounding of s = c/a in `forces` counts; the reference has the ratio exactly, and the rounding to double
/// of its own. Where long double is double, its rounding is more than 1e-14: that tolerance is refused.
TEST(Table, ReachesTheFinestTolerance) {
  constexpr double finest = accuracy::has_extended ? Table::finest_tolerance : 5e-14;
  constexpr double rounding = accuracy::has_extended ? 2e-16 : accuracy::evaluate_by_quadrature;
  for (const char* name :
       {"hertz", "uniform", "flat-punch", "cone", "gaussian:sigma=0.4", "mix:0.7*hertz+0.3*uniform", "power:n=2.3"}) {
    const Law law = parse_law(name);
    if (!accuracy::has_extended) {
      EXPECT_THROW(Table::build(law, Table::finest_tolerance), std::runtime_error) << name;
    }
    const Table table = Table::build(law, finest);
    EXPECT_LE(table.checked_error(), finest) << name;
    EXPECT_LE(table.bytes(), 65536U) << name;
    const auto exact = [&](SlipTwist twist) { return law->evaluate(twist.cor()).wrench; };
    EXPECT_LE(worst_error(table, exact, 1000), table.checked_error() + rounding) << name;
    expect_convex_and_smooth(table);
  }
}

TEST(Table, IsSmallForHertz) {
  EXPECT_LE(Table::build(hertz(), 1e-8, {.preferred_bytes = 0}).bytes(), 1536U);
  EXPECT_LE(FloatTable::build(hertz(), 5e-7, {.preferred_bytes = 0}).bytes(), 768U);
}

TEST(Table, HasTheLowestDegreeWithinItsBudget) {
  for (const char* name : {"hertz", "uniform", "flat-punch", "gaussian:sigma=0.4", "xydas-kao:k=0.3"}) {
    const Law law = parse_law(name);
    for (const double tolerance : {1e-3, 1e-6, 1e-8, 1e-10}) {
      std::size_t more = 0;
      int last = 7;
      int steps = Table::build(law, tolerance, {.preferred_bytes = 0}).view().table.halvings;
      for (const std::size_t bytes : {0U, 2048U, 4096U, 16384U, 98304U}) {
        const Table table = Table::build(law, tolerance, {.preferred_bytes = bytes});
        EXPECT_TRUE(table.degree() == 6 || table.bytes() <= bytes) << name << ' ' << tolerance << ' ' << bytes;
        EXPECT_LE(table.degree(), last);
        EXPECT_LE(table.view().table.halvings, steps)
            << name << ' ' << tolerance << ' ' << bytes;  // a search takes longer than all degrees
        EXPECT_GE(table.bytes(), more);
        EXPECT_EQ(table.degree(), Table(TableFacts{"again", tolerance, table.checked_error()}, table.cells()).degree());
        EXPECT_LE(worst_error(table, exact_of(law), 300), table.checked_error() + 2e-16);
        last = table.degree();
        more = table.bytes();
        steps = table.view().table.halvings;
      }
    }
    EXPECT_EQ(Table::build(law, 1e-3).degree(), 3) << name;
    EXPECT_EQ(Table::build(law, 1e-8).view().table.halvings, 0) << name;
    EXPECT_EQ(Table::build(law, 1e-13).degree(), 6) << name;
  }
}

TEST(Table, ManyLookUpsGiveTheBitsOfSingleOnes) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<SlipTwist> twists{{0, 0},  {nan, 1}, {1, nan}, {inf, 1},        {0, inf},        {inf, inf},
                                {0, -1}, {-1, 0},  {1, 1},   {5e-324, 1e308}, {1e-200, 2e-200}};
  while (twists.size() < 1003)
    twists.push_back({std::exp(3 * normal(random)) * (random() % 2 ? 1 : -1), normal(random)});
  for (const double tolerance : {1e-3, 1e-8, 1e-10, 1e-13}) {
    for (const char* name : {"hertz", "xydas-kao:k=0.3"}) {
      if (name[0] == 'x' && tolerance < 1e-9) continue;
      const Table table = Table::build(parse_law(name), tolerance);
      std::vector<UnitWrench> wrenches(twists.size());
      table.wrench(twists, wrenches);
      std::vector<UnitWrench> directions;
      const auto same = [](double one, double other) {
        return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other) ||
               (std::isnan(one) && std::isnan(other));
      };
      for (std::size_t i = 0; i < twists.size(); ++i) {
        const UnitWrench single = table.wrench(twists[i]);
        ASSERT_TRUE(same(wrenches[i].force, single.force) && same(wrenches[i].moment, single.moment))
            << name << ' ' << tolerance << ' ' << i;
        directions.push_back({twists[i].slide, twists[i].spin});
      }
      std::vector<double> gauges(directions.size());
      table.gauge(directions, gauges);
      for (std::size_t i = 0; i < directions.size(); ++i)
        ASSERT_TRUE(same(gauges[i], table.gauge(directions[i]))) << name << ' ' << i;
    }
  }
}

TEST(Table, CheckedErrorHoldsBetweenRepresentablePlaces) {
  // At twists (slide, spin), whose quotient rounds: the slope of the curve is steep where pressures are concentrated at
  // the centre.
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const char* name : {"gaussian:sigma=1e-6", "xydas-kao:k=0.05"}) {
    const Law law = parse_law(name);
    const Table table = Table::build(law, 1e-12);
    double worst = 0.0;
    for (int i = 0; i < repetitions(500, 10); ++i) {
      const SlipTwist twist{std::pow(10.0, -12.0 * unit(random)), unit(random)};
      const auto exact = law->unrounded(Extended(twist.slide) / twist.spin, Slope::unwanted).forces;
      worst = std::max(worst, test::apart(table.wrench(twist), exact));
    }
    EXPECT_LE(worst, table.checked_error()) << name;
  }
}

TEST(FloatTable, CheckedErrorHoldsInItsOwnArithmetic) {
  for (const char* name : {"hertz", "uniform", "flat-punch", "cone", "power:n=-0.9", "xydas-kao:k=3",
                           "gaussian:sigma=1e-3", "gaussian:sigma=1e3"}) {
    const Law law = parse_law(name);
    for (const double tolerance : {1e-1, 1e-4, 5e-7}) {
      SCOPED_TRACE(std::string(name) + ' ' + std::to_string(tolerance));
      const FloatTable table = FloatTable::build(law, tolerance);
      EXPECT_LE(table.checked_error(), tolerance * std::max(1.0, law->moment_ratio()));
      EXPECT_LE(worst_error(table, exact_of(law), 3000), table.checked_error());
      EXPECT_EQ(table.wrench({1.0, 0.0}), (UnitWrench{1.0, 0.0}));
      EXPECT_EQ(table.moment_ratio(), double{static_cast<float>(law->moment_ratio())});
      expect_convex_and_smooth(table);
      EXPECT_EQ(FloatTable({"again", tolerance, 0.0}, table.cells()).wrench({0.3, 1.0}), table.wrench({0.3, 1.0}));
    }
  }
}

TEST(Table, RefusesTolerancesThatMeanNothing) {
  for (const double tolerance : {0.0, -1e-6, 9e-15, 0.2, nan, inf}) {
    EXPECT_THROW(Table::build(hertz(), tolerance), std::invalid_argument) << tolerance;
  }
  EXPECT_THROW(FloatTable::build(hertz(), 4e-7), std::invalid_argument);
  const std::string text = complaint([] { Table::build(hertz(), 0.2); });
  expect_mention(text, "0.2");
  expect_mention(text, "1e-14 <= tolerance <= 0.1");
}

// Once xydas-kao of k < 0.02 reached no tolerance. The smaller k, the longer it takes.
TEST(Table, FollowsWhatIsNearerToAnEndThanBucketsGet) {
  for (const double tolerance : studies_are_whole() ? std::vector{0.1, 1e-6} : std::vector{0.1}) {
    const Law law = xydas_kao(studies_are_whole() || !accuracy::has_extended ? 0.01 : 0.019);
    if (!accuracy::has_extended) {  // refused there, by its name: docs/accuracy.md
      expect_mention(complaint<std::runtime_error>([&] { Table::build(law, tolerance); }), "xydas-kao:k=0.01");
      continue;
    }
    const Table table = Table::build(law, tolerance);
    for (const double s : {0.0, 1e-22, 1e-20, 1e-18, 3e-17, 1e-16, 1e-15, 1e-12, 1e-8, 0.1, 1.0, 3.0}) {
      EXPECT_LE(test::apart(table.wrench(SlipTwist::about_cor(s)), law->evaluate(s).wrench), table.checked_error())
          << s;
    }
  }
}

TEST(Table, NamesTheCurveAndTheToleranceThatIsNotPossible) {
  // Near pure spin its force is the fifth root of x: no cell begins near enough to 0.
  const std::string text = complaint<std::runtime_error>([] {
    Table::build(test::Superellipse{1.0, 0.58, 6.0}, 1e-12, {.name = "superellipse:n=6"});
  });
  for (const char* part : {"superellipse:n=6", "1e-12", "expected a coarser one"}) expect_mention(text, part);
}

TEST(Table, RefusesCurvesWithCorners) {
  expect_mention(complaint([] { Table::build(box(1.0, 0.6), 1e-3, {.name = "box"}); }), "table of box");
  expect_mention(complaint([] { Table::build(diamond(1.0, 0.6), 1e-3, {.name = "diamond"}); }), "table of diamond");
  // One that does not say that it has.
  struct Corner {
    [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
      return {twist.slide > 0.0 ? 1.0 : 0.0, twist.spin > 0.0 ? 0.6 : 0.0};
    }
  };
  expect_mention(complaint([] { Table::build(Corner{}, 1e-3, {.name = "corner"}); }), "flat face");
}

// The gauge of these is beyond the largest number; the point of the curve on their ray is not.
TEST(Table, FindsTheCurveOnTheRayOfTheLargestWrenches) {
  const Table table = Table::build(hertz(), 1e-6);
  const double largest = std::numeric_limits<double>::max();
  for (const UnitWrench wrench :
       {UnitWrench{largest, largest}, UnitWrench{1e-300, largest}, UnitWrench{largest, 0.0}}) {
    const UnitWrench found = table.along(wrench).wrench;
    EXPECT_NEAR(table.gauge(found), 1.0, 1e-14) << wrench.force;
    EXPECT_NEAR(found.force * (wrench.moment / largest), found.moment * (wrench.force / largest), 1e-15)
        << wrench.force;
  }
}

TEST(Table, NoLawIsRefused) {
  expect_mention(complaint([] { (void)Table::build(Law{}, 1e-3); }), "law: none");
  expect_mention(complaint([] { (void)ExactCurve(Law{}); }), "law: none");
  EXPECT_THROW((void)mixture({}), std::invalid_argument);
  expect_mention(complaint([] { (void)mixture(std::vector<std::pair<double, Law>>{{1.0, Law{}}}); }), "law: none");
}

TEST(Table, OutlivesWhatItWasCopiedOrMovedFrom) {
  Table table = Table::build(hertz(), 1e-4);
  const UnitWrench before = table.wrench({1.0, 1.0});
  { const Table gone = std::move(table); }
  EXPECT_EQ(table.wrench({1.0, 1.0}), before);  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(table.law_name(), "hertz");
  {
    const Table other = Table::build(uniform(), 1e-4);
    table = other;
    EXPECT_EQ(table.view().table.cells, other.view().table.cells);
  }
  EXPECT_EQ(table.law_name(), "uniform");
  EXPECT_NEAR(table.wrench({0.0, 1.0}).moment, 2.0 / 3.0, 1e-15);
}

// A cell may be much wider than all before it: then its error is largest just beside them.
TEST(Table, CheckedErrorHoldsBesideNarrowCells) {
  const Law law = parse_law("mix:0.9927*xydas-kao:k=0.01687+0.0073*uniform");
  const Table table = Table::build(law, 1.00529e-7);
  const TableCells cells = table.cells();
  for (const TableCell& cell : cells.inside) {
    for (double part = 1e-4; part < 0.1; part *= 1.1) {
      const double s = cell.x + part * (1.0 - cell.x);
      EXPECT_LE(test::apart(table.wrench(SlipTwist::about_cor(s)), law->forces(s, Slope::unwanted)),
                table.checked_error())
          << s;
    }
  }
}

}  // namespace
}  // namespace limitcurve
