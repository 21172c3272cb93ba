// SPDX-License-Identifier: MIT
#include "limitcurve/table_side.hpp"

#include "limitcurve/number.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve {

namespace {

[[noreturn]] void refuse(std::size_t node, const TableNode& at, const std::string& what) {
  throw std::invalid_argument("table node " + std::to_string(node) + " at coordinate " + format_number(at.coordinate) + ": " + what);
}

}  // namespace

TableSide::Cell::Cell(const TableNode& from, const TableNode& to) noexcept
    : left(from.coordinate), rise(from.slope), constant{from.primary, from.secondary} {
  const double width = to.coordinate - from.coordinate;
  const auto curved = [&](double rise_of_value, double slope_from, double slope_to) {
    const double chord = rise_of_value / width;
    return std::pair{(3.0 * chord - 2.0 * slope_from - slope_to) / width, (slope_from + slope_to - 2.0 * chord) / (width * width)};
  };
  const auto [primary_square, primary_cube] = curved(to.primary - from.primary, from.slope, to.slope);
  const auto [secondary_square, secondary_cube] =
      curved(to.secondary - from.secondary, -from.coordinate * from.slope, -to.coordinate * to.slope);
  square = Pair{primary_square, secondary_square};
  cube = Pair{primary_cube, secondary_cube};
}

bool is_convex(const TableNode& left, const TableNode& right) noexcept {
  // In the place t ∈ [0, 1] the first derivatives are quadratics a + bt + ct², A + Bt + Ct²; their cross with the second
  // derivatives is again a quadratic, because the cubic terms cancel: (aB − bA) + 2(aC − cA)t + (bC − cB)t².
  const double width = right.coordinate - left.coordinate;
  const TableSide::Cell cell(left, right);
  const double a = width * cell.rise;
  const double b = 2.0 * width * width * cell.square[0];
  const double c = 3.0 * width * width * width * cell.cube[0];
  const double A = -width * cell.left * cell.rise;
  const double B = 2.0 * width * width * cell.square[1];
  const double C = 3.0 * width * width * width * cell.cube[1];
  // On a convex curve traversed towards the rim the direction turns from the primary towards minus the secondary.
  const double constant = A * b - B * a;
  const double linear = 2.0 * (A * c - C * a);
  const double square = B * c - C * b;
  const auto at = [&](double t) { return constant + t * (linear + t * square); };
  double least = std::min(at(0.0), at(1.0));
  const double turn = -linear / (2.0 * square);
  if (turn > 0.0 && turn < 1.0) least = std::min(least, at(turn));
  // The nodes' values are right to a few units of 1e-15, and so are the second derivatives here (differences of them);
  // the first derivatives multiply that.
  constexpr double node_error = 2e-14;
  // Slopes far too steep for their chord turn by a whole round more, to the same side all the way: the primary then falls.
  const double rising = std::min(a, a + b + c);
  const double middle = -b / (2.0 * c);
  const double slowest = middle > 0.0 && middle < 1.0 ? std::min(rising, a + 0.5 * b * middle) : rising;
  if (slowest < -node_error * (std::fabs(a) + std::fabs(b) + std::fabs(c))) return false;
  // Where the first slope is next to nothing for its chord it decides no direction, and the secondary may rise before it falls.
  const double falling = std::max(A, A + B + C);
  const double between = -B / (2.0 * C);
  const double quickest = between > 0.0 && between < 1.0 ? std::max(falling, A + 0.5 * B * between) : falling;
  if (quickest > node_error * left.secondary) return false;
  return least >= -node_error * (std::fabs(a) + std::fabs(b) + std::fabs(A) + std::fabs(B));
}

TableSide::TableSide(std::vector<TableNode> nodes) : nodes_(std::move(nodes)) {
  verify();
  for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) cells_.emplace_back(nodes_[i], nodes_[i + 1]);
  cell_count_ = static_cast<std::uint32_t>(cells_.size());
  build_index();
}

std::vector<TableSide::Trust> TableSide::trusts(double kappa) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<Trust> result;
  result.reserve(cell_count_);
  for (std::size_t i = 0; i < cell_count_; ++i) {
    const Cell& cell = cells_[i];
    const double width = cells_[i + 1].left - cell.left;
    double fall = never;
    double square = 0.0;
    double cube = 0.0;
    for (const double share : {0.0, 0.5, 1.0}) {
      const double x = cell.left + share * width;
      const Cell::Jet jet = cell.jet(x);
      // For a trial on the curve; one that is outside makes it fall more steeply, and is not in what bends.
      const Residual here = Normal{jet.value, kappa}(jet, x);
      fall = std::min(fall, here.value_and_fall[1]);
      square = std::max(square, std::fabs(here.square));
      cube = std::max(cube, std::fabs(here.cube));
    }
    fall *= 0.9;
    // A parabola that is at most 1 at three places is at most 1.25 between them; the cube is a straight line.
    square *= 1.25;
    // The step leaves δ⁴(2fsc − s³ − f²q)/f³, where q, the fourth coefficient, is κ times a cube's.
    const double of_square = square * (square * square) / closest_share;
    const double of_rest = (2.0 * square * cube / fall + kappa * std::fabs(cell.cube[1])) / closest_share;
    const bool is_even = fall > long_least_steep && fall < long_steepest && of_square < never && of_rest < never;
    result.push_back(is_even ? Trust{fall, of_square, of_rest} : Trust{never, never, never});
  }
  return result;
}

void TableSide::verify() const {
  if (nodes_.size() < 2 || nodes_.size() > most_nodes) {
    throw std::invalid_argument("table side has " + std::to_string(nodes_.size()) + " nodes: expected 2 to " + std::to_string(most_nodes));
  }
  if (nodes_.front().coordinate != 0.0 || nodes_.front().primary != 0.0) refuse(0, nodes_.front(), "expected coordinate 0 and primary 0");
  if (nodes_.back().coordinate != 1.0) refuse(nodes_.size() - 1, nodes_.back(), "expected coordinate 1, the rim");
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const TableNode& node = nodes_[i];
    for (const double value : {node.coordinate, node.primary, node.secondary, node.slope}) {
      if (!std::isfinite(value)) refuse(i, node, "expected finite numbers");
    }
    if (!(node.slope > 0.0)) refuse(i, node, "expected a slope > 0, got " + format_number(node.slope));
    if (!(node.secondary > 0.0)) refuse(i, node, "expected a secondary component > 0, got " + format_number(node.secondary));
    if (i == 0) continue;
    const TableNode& before = nodes_[i - 1];
    if (!(before.coordinate < node.coordinate)) refuse(i, node, "expected coordinates that increase");
    if (!(before.primary < node.primary)) refuse(i, node, "expected a primary component that increases");
    if (!(before.secondary > node.secondary)) refuse(i, node, "expected a secondary component that decreases");
    if (!is_convex(before, node)) refuse(i, node, "expected a convex curve before it");
  }
}

void TableSide::build_index() {
  // As few buckets as leave none with more than two nodes, which both are compared with at once. Laws that are steep at
  // the rim spread their nodes over many octaves of 1 − x; there is a limit to the bytes that is worth.
  constexpr std::size_t few = 1;
  constexpr unsigned mantissa = 52;
  constexpr unsigned finest = 10;
  const std::size_t most_buckets = std::max<std::size_t>(512, 16 * nodes_.size());
  const TableNode& last = nodes_[nodes_.size() - 2];
  for (unsigned bits = 0; bits <= finest; ++bits) {
    const unsigned shift = mantissa - bits;
    const std::uint64_t least = std::bit_cast<std::uint64_t>(1.0 - last.coordinate) >> shift;
    const std::uint64_t buckets = (std::bit_cast<std::uint64_t>(1.0) >> shift) - least + 1;
    if (bits > 0 && buckets > most_buckets) break;
    shift_ = shift;
    least_key_ = least;
    first_cell_.assign(static_cast<std::size_t>(buckets), 0);
    // A bucket's first cell begins with the last node before all of its coordinates: nodes come with falling buckets.
    std::size_t nodes_here = 0;
    std::size_t fullest = 0;
    std::size_t below = static_cast<std::size_t>(buckets);
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) {
      const std::size_t at = bucket(nodes_[i].coordinate);
      nodes_here = at < below ? 1 : nodes_here + 1;
      if (i > 0) fullest = std::max(fullest, nodes_here);
      for (std::size_t j = at; j-- > 0;) first_cell_[j] = static_cast<std::uint16_t>(i);
      below = at;
    }
    probes_ = std::max<std::size_t>(fullest, 1);
    if (probes_ <= few) break;
  }
  cells_.resize(nodes_.size() - 1 + probes_, Cell::end());
}

void TableSide::align(TableSide& one, TableSide& other) {
  one.probes_ = other.probes_ = std::max(one.probes_, other.probes_);
  for (TableSide* side : {&one, &other}) side->cells_.resize(side->nodes_.size() - 1 + side->probes_, Cell::end());
}

}  // namespace limitcurve
