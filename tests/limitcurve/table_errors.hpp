// SPDX-License-Identifier: MIT
#pragma once

#include "tests/limitcurve/shared.hpp"

/// How far a table is from its curve, and whether its cells join.
namespace limitcurve::test {

/// Slip twists without regard to a table's cells: uniform, crowding to both ends, and crowding to the rim.
inline SlipTwist probe(std::mt19937_64& random, int i) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double sign = unit(random) < 0.5 ? -1.0 : 1.0;
  const double tiny = std::pow(10.0, -16.0 * unit(random));
  if (i % 3 == 0) return SlipTwist::about_cor(1.0 + sign * 0.5 * tiny);
  if (i % 3 == 1) return sign < 0.0 ? SlipTwist{tiny, 1.0} : SlipTwist{1.0, tiny};
  return SlipTwist::of_spin_fraction(unit(random));
}

/// The largest error of a table at so many twists.
template <class Real, class Exact>
double worst_error(const BasicTable<Real>& table, const Exact& exact, int count) {
  std::mt19937_64 random(20060325);
  double worst = 0.0;
  for (int i = 0; i < count; ++i) {
    const SlipTwist twist = probe(random, i);
    worst = std::max(worst, apart(table.wrench(twist), exact(twist)));
  }
  return worst;
}

/// `forces` knows s = c/a only, whose rounding moves the wrench: by less than 2e-16, but by 1e-15 where m₀ ≫ 1.
inline auto exact_of(const Law& law) {
  return [law](SlipTwist twist) { return law->forces(twist.cor()); };
}

/// Neighbouring cells have the same D and D′ where they meet, and D″ ≥ 0 everywhere: as TableView reads them.
template <class Real>
void expect_convex_and_smooth(const BasicTable<Real>& table) {
  constexpr double epsilon = std::numeric_limits<Real>::epsilon();
  const TableCells cells = table.cells();
  const TableView<Real>& view = table.view().table;
  std::mt19937_64 random(4);
  for (const bool outside : {false, true}) {
    const std::vector<TableCell>& side = outside ? cells.outside : cells.inside;
    for (std::size_t i = 0; i < side.size(); ++i) {
      const double right = i + 1 < side.size() ? side[i + 1].x : 1.0;
      std::uniform_real_distribution<double> within(side[i].x, right);
      for (int k = 0; k < 20; ++k) {
        const Jet<Real> jet = view.jet(outside, static_cast<Real>(within(random)));
        EXPECT_GE(jet.second, -64 * epsilon * std::fabs(side[i].coefficients[2])) << outside << ' ' << side[i].x;
      }
      if (i == 0) continue;
      const auto x = static_cast<Real>(side[i].x);
      const auto before = std::nextafter(x, Real(0));
      const Jet<Real> here = view.jet(outside, x);
      const Jet<Real> there = view.jet(outside, before);
      const double step = double{x} - double{before};
      const double scale = std::max(table.force_max(), table.force_max() * table.moment_ratio());
      EXPECT_NEAR(here.value(x), there.value(before), step * std::fabs(double{here.leading}) + 8 * epsilon * scale)
          << outside << ' ' << side[i].x;
      EXPECT_NEAR(here.leading, there.leading,
                  2 * step * double{std::max(here.second, there.second)} + 8 * epsilon * scale)
          << outside << ' ' << x;
    }
  }
  const Jet<Real> inside = view.jet(false, Real(1));
  const Jet<Real> outside = view.jet(true, Real(1));
  const double scale = std::max(double{inside.value(1)}, double{outside.value(1)});
  EXPECT_NEAR(inside.value(1), outside.value(1), 8 * epsilon * scale);
  EXPECT_NEAR(inside.leading + outside.leading, inside.value(1), 8 * epsilon * scale);
}

}  // namespace limitcurve::test
