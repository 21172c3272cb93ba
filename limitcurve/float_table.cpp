// SPDX-License-Identifier: MIT
#include "limitcurve/float_table.hpp"

#include "limitcurve/number.hpp"
#include "limitcurve/table_builder.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace limitcurve {

namespace {

using Cell = FloatTable::Cell;

/// Half of the distance between 1 and the next float: what one operation adds to its result, relatively, at most.
constexpr double rounding = 0x1p-24;

/// The curve of a side of the table.
class SideOfTable {
 public:
  SideOfTable(const Table& table, Side side) : table_(table), outside_(side == Side::outside) {}

  [[nodiscard]] TableNode at(double x) const {
    const BoundaryPoint point = table_.point(outside_ ? SlipTwist{1.0, x} : SlipTwist{x, 1.0});
    // Slopes are by the spin fraction u = 1/(1+s) = q/(1+q): ds/du = −(1+s)², dq/du = (1+q)².
    const double rate = (1.0 + x) * (1.0 + x);
    if (outside_) return {x, point.wrench.moment, point.wrench.force, point.slope.moment / rate};
    return {x, point.wrench.force, point.wrench.moment, -point.slope.force / rate};
  }

 private:
  const Table& table_;
  bool outside_;
};

/// Where cell number `i` of `count`, counted from the rim, ends towards the rim.
double right_end(std::size_t i, std::size_t count) {
  const double share = static_cast<double>(i) / static_cast<double>(count);
  return static_cast<double>(static_cast<float>(1.0 - share * share));
}

Cell cell_between(const TableNode& left, const TableNode& right) {
  const double width = right.coordinate - left.coordinate;
  const auto rise = static_cast<float>(left.slope);
  Cell cell{static_cast<float>(left.coordinate), rise, {}, {}, {}};
  const auto fill = [&](std::size_t i, double from, double to, double slope_from, double slope_to) {
    const double chord = (to - from) / width;
    cell.constant[i] = static_cast<float>(from);
    cell.square[i] = static_cast<float>((3.0 * chord - 2.0 * slope_from - slope_to) / width);
    cell.cube[i] = static_cast<float>((slope_from + slope_to - 2.0 * chord) / (width * width));
  };
  fill(0, left.primary, right.primary, static_cast<double>(rise), right.slope);
  fill(1, left.secondary, right.secondary, -left.coordinate * static_cast<double>(rise), -right.coordinate * right.slope);
  return cell;
}

/// Of a cell's two cubics, at a distance d from its left end.
struct Values {
  std::array<double, 2> value;
  std::array<double, 2> slope;
};

Values values_of(const Cell& cell, double d) {
  const auto rise = static_cast<double>(cell.rise);
  Values result{};
  for (const std::size_t i : {0U, 1U}) {
    const double linear = i == 0 ? rise : -static_cast<double>(cell.left) * rise;
    const auto square = static_cast<double>(cell.square[i]);
    const auto cube = static_cast<double>(cell.cube[i]);
    result.value[i] = static_cast<double>(cell.constant[i]) + d * (linear + d * (square + d * cube));
    result.slope[i] = linear + d * (2.0 * square + 3.0 * d * cube);
  }
  return result;
}

/// What the rounding of a lookup in the cell adds at most: that of the twist's quotient, and of each operation by the size of
/// its result, in the order in which `FloatTable::float_wrench` takes them.
double rounding_error(const Cell& cell, double right) {
  const double h = right - static_cast<double>(cell.left);
  double most = 0.0;
  for (const std::size_t i : {0U, 1U}) {
    const double slope = std::fabs(static_cast<double>(cell.rise)) * (i == 0 ? 1.0 : static_cast<double>(cell.left));
    const double linear = slope * h;
    const double square = std::fabs(static_cast<double>(cell.square[i])) * h * h;
    const double cube = std::fabs(static_cast<double>(cell.cube[i])) * h * h * h;
    const double value = std::max(std::fabs(values_of(cell, 0.0).value[i]), std::fabs(values_of(cell, h).value[i]));
    const double steepest = slope * h + 2.0 * square + 3.0 * cube;  // · h
    // Two sums of the value's size; of the linear term its products; of the others theirs and a sum; then x and its distance.
    const double operations = 2.0 * value + 2.0 * linear + 4.0 * square + 5.0 * cube + steepest + right * steepest / h;
    most = std::max(most, 1.001 * rounding * operations);
  }
  return most;
}

/// The cells of a side and the bound of their error against the table.
struct Attempt {
  std::vector<Cell> cells;
  double error = 0.0;
};

Attempt attempt(const SideOfTable& side, std::size_t count) {
  Attempt result;
  for (std::size_t i = 0; i < count; ++i) {
    const TableNode left = side.at(right_end(i + 1, count));
    TableNode right = side.at(right_end(i, count));
    const double width = right.coordinate - left.coordinate;
    if (i == 0) {
      // The curve's own slope at the rim may be reached only next to it; the one that makes the middle exact.
      const double middle = side.at(left.coordinate + 0.5 * width).primary;
      const double fitted = left.slope + 8.0 * (0.5 * (left.primary + right.primary) - middle) / width;
      if (fitted > 0.0) right.slope = fitted;
    }
    const Cell cell = cell_between(left, right);
    double worst = 0.0;
    const auto compare = [&](double share) {
      const TableNode truth = side.at(left.coordinate + share * width);
      const auto [value, slope] = values_of(cell, truth.coordinate - left.coordinate);
      worst = std::max({worst, std::fabs(value[0] - truth.primary), std::fabs(value[1] - truth.secondary)});
      if (!(slope[0] > 0.0 && slope[1] <= 0.0)) worst = std::numeric_limits<double>::infinity();  // not monotone: too wide
    };
    for (int k = 0; k <= certificate_points + 1; ++k) compare(k / (certificate_points + 1.0));
    if (i == 0) {
      for (double from_rim = 0.5; from_rim > 1e-6; from_rim *= 0.75) compare(1.0 - from_rim);
    }
    result.error = std::max(result.error, worst * (1.0 + certificate_margin) + rounding_error(cell, right.coordinate));
    result.cells.push_back(cell);
  }
  return result;
}

/// The fewest cells that keep the tolerance, to within a sixteenth.
Attempt fewest(const SideOfTable& side, double tolerance, const std::string& law_name) {
  for (std::size_t count = 1; count <= FloatTable::most_cells; count += 1 + count / 16) {
    Attempt tried = attempt(side, count);
    if (tried.error <= tolerance) return tried;
  }
  throw std::runtime_error("float table of " + law_name + ": too many cells for the tolerance");
}

double checked_tolerance(double tolerance) {
  if (!(tolerance >= FloatTable::finest_tolerance && tolerance <= FloatTable::coarsest_tolerance)) {
    throw out_of_range("tolerance", tolerance, "1", "5e-7 <= tolerance <= 0.1");
  }
  return tolerance;
}

}  // namespace

FloatTable FloatTable::build(const Law& law, double tolerance) {
  return {Table::build(law, checked_tolerance(tolerance) / 8.0), tolerance};
}

FloatTable::FloatTable(const Table& table, double tolerance)
    : tolerance_(checked_tolerance(tolerance)), moment_ratio_(static_cast<float>(table.moment_ratio())) {
  if (!(table.certified_error() <= 0.5 * tolerance)) {
    throw out_of_range("certified_error of the table", table.certified_error(), "1", "at most half of the float table's tolerance");
  }
  const double left_for_cells = tolerance - table.certified_error();
  for (const Side side : {Side::inside, Side::outside}) {
    const Attempt found = fewest(SideOfTable(table, side), left_for_cells, table.law_name());
    if (side == Side::inside) inside_count_ = found.cells.size();
    counts_[side == Side::outside] = static_cast<float>(found.cells.size());
    certified_error_ = std::max(certified_error_, table.certified_error() + found.error);
    cells_.insert(cells_.end(), found.cells.begin(), found.cells.end());
  }
}

BoundaryPoint FloatTable::point(SlipTwist twist) const noexcept {
  const auto [outside, x] = place(twist);
  const Cell& here = cell(outside, static_cast<float>(x));
  const auto [value, slope] = values_of(here, x - static_cast<double>(here.left));
  // ds/du = −(1+s)², dq/du = (1+q)².
  const double rate = (outside ? 1.0 : -1.0) * (1.0 + x) * (1.0 + x);
  return {{value[outside], value[!outside]}, {rate * slope[outside], rate * slope[!outside]}};
}

}  // namespace limitcurve
