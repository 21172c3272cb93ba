// SPDX-License-Identifier: MIT
#include "limitcurve/chord_table.hpp"

#include "limitcurve/number.hpp"
#include "limitcurve/table_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve {

namespace {

using Cell = ChordTable::Cell;

Pair wrench_at(const Table& table, double u) {
  const UnitWrench wrench = table.wrench(SlipTwist::of_spin_fraction(u));
  return Pair{wrench.force, wrench.moment};
}

Cell chord(const Table& table, double left, double right) {
  const Pair from = wrench_at(table, left);
  const Pair to = wrench_at(table, right);
  const double width = right - left;
  const Pair rise = (to - from) / Pair{width, width};
  // From the end that is nearer to its end of the curve, so that a component is 0 there and nowhere less.
  return right <= 0.5 ? Cell{from - Pair{left, left} * rise, rise} : Cell{to - Pair{right, right} * rise, rise};
}

/// The largest error of a cell against the table, where it was looked for.
double error_of(const Cell& cell, const Table& table, double left, double right) {
  double worst = 0.0;
  const auto compare = [&](double u) {
    const Pair off = cell.start + Pair{u, u} * cell.rise - wrench_at(table, u);
    worst = std::max({worst, std::fabs(off[0]), std::fabs(off[1])});
  };
  const double width = right - left;
  for (int k = 1; k <= certificate_points; ++k) compare(left + k * width / (certificate_points + 1));
  // Next to the rim the curve may bend without bound, and most of it in the last part of a cell.
  for (double share = 0.5; share > 1e-6; share *= 0.75) {
    if (right == 0.5) compare(right - share * width);
    if (left == 0.5) compare(left + share * width);
  }
  const double largest = std::max({std::fabs(cell.rise[0]), std::fabs(cell.rise[1]), 1.0});
  return worst * (1.0 + certificate_margin) + 4.0 * std::numeric_limits<double>::epsilon() * largest;
}

double checked_tolerance(double tolerance) {
  if (!(tolerance >= ChordTable::finest_tolerance && tolerance <= ChordTable::coarsest_tolerance)) {
    throw out_of_range("tolerance", tolerance, "1", "1e-7 <= tolerance <= 0.1");
  }
  return tolerance;
}

}  // namespace

ChordTable ChordTable::build(const Law& law, double tolerance) {
  return {Table::build(law, checked_tolerance(tolerance) / 8.0), tolerance};
}

ChordTable::ChordTable(const Table& table, double tolerance) : tolerance_(checked_tolerance(tolerance)) {
  if (!(table.certified_error() <= 0.5 * tolerance)) {
    throw out_of_range("certified_error of the table", table.certified_error(), "1", "at most half of the chord table's tolerance");
  }
  const double left_for_chords = tolerance - table.certified_error();
  for (std::size_t count = 2; count <= most_cells; count *= 2) {
    count_ = static_cast<double>(count);
    cells_.clear();
    double error = 0.0;
    for (std::size_t i = 0; i < count && error <= left_for_chords; ++i) {
      const double left = static_cast<double>(i) / count_;
      const double right = static_cast<double>(i + 1) / count_;
      cells_.push_back(chord(table, left, right));
      error = std::max(error, error_of(cells_.back(), table, left, right));
    }
    if (error > left_for_chords) continue;
    cells_.push_back({wrench_at(table, 1.0), Pair{0.0, 0.0}});
    certified_error_ = table.certified_error() + error;
    return;
  }
  throw std::runtime_error("chord table of " + table.law_name() + ": too many cells for the tolerance");
}

}  // namespace limitcurve
