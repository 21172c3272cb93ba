// SPDX-License-Identifier: MIT
#include "limitcurve/table/check.hpp"

#include "limitcurve/internal/number.hpp"
#include "limitcurve/table/bernstein.hpp"
#include "limitcurve/table/buckets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace limitcurve::table {

namespace {

/// One cell of a table, for the checks of the constructor. Sums are in extended precision. The checks allow for the
/// rounding of the coefficients, and for nothing else.
struct CheckedCell {
  const TableCell& cell;
  Extended width;

  /// A value at the right end, and the scale of its rounding error.
  struct Value {
    Extended value;
    Extended rounding;
  };
  [[nodiscard]] Value support() const {
    return sum([](std::size_t) { return 1; }, 0);
  }
  [[nodiscard]] Value leading() const {
    return sum([](std::size_t i) { return i; }, 1);
  }

  /// Whether D″ has Bernstein coefficients ≥ 0.
  [[nodiscard]] bool is_convex(Extended epsilon) const {
    std::array<Extended, 5> second{};
    Extended size = 0;
    Extended power = 1;
    for (std::size_t i = 0; i < second.size(); ++i, power *= width) {
      second[i] = static_cast<Extended>((i + 2) * (i + 1)) * cell.coefficients[i + 2] * power;
      size += std::fabs(second[i]);
    }
    return least_bernstein_coefficient(second) >= -epsilon * size;
  }

 private:
  template <class Factor>
  [[nodiscard]] Value sum(Factor factor, std::size_t order) const {
    Value result{0, 0};
    Extended power = 1;
    for (std::size_t i = order; i < cell.coefficients.size(); ++i, power *= width) {
      const Extended term = static_cast<Extended>(factor(i)) * cell.coefficients[i] * power;
      result.value += term;
      result.rounding += std::fabs(term);
    }
    return result;
  }
};

/// Throws std::invalid_argument, with `name` and the cell, unless the cells make a side; returns D and D′ at the rim.
template <class Real>
std::array<CheckedCell::Value, 2> check_side(const std::string& name, const std::vector<TableCell>& cells) {
  constexpr Extended epsilon = 4 * Extended(std::numeric_limits<Real>::epsilon());
  const auto refuse = [&](std::size_t i, const std::string& what) {
    return std::invalid_argument("table, " + name + ", cell " + std::to_string(i + 1) +
                                 " (x = " + format_number(cells[i].x) + "): " + what);
  };
  if (cells.empty()) throw std::invalid_argument("table, " + name + ": no cells");
  if (cells.front().x != 0.0) throw refuse(0, "expected x = 0");
  if (cells.front().coefficients[1] != 0.0) throw refuse(0, "expected a leading component of 0");
  if (!(cells.front().coefficients[0] > 0.0)) throw refuse(0, "expected a support function > 0");
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const double c : cells[i].coefficients) {
      if (!std::isfinite(static_cast<Real>(c))) throw refuse(i, "expected finite numbers, got " + format_number(c));
    }
    if (!(cells[i].x >= 0.0 && cells[i].x < 1.0 && double{static_cast<Real>(cells[i].x)} == cells[i].x))
      throw refuse(i, "expected x in [0, 1), and exact in the table's arithmetic");
    if (i > 0 && !(cells[i].x > cells[i - 1].x)) throw refuse(i, "expected x that increases from cell to cell");
    if (i > 0 && !(cells[i].x - cells[i - 1].x >= narrowest_cell<Real>))
      throw refuse(i, "expected x larger than that of the cell before by at least " +
                          format_number(double{narrowest_cell<Real>}));
  }
  for (std::size_t i = 0;; ++i) {
    const bool last = i + 1 == cells.size();
    const CheckedCell here{cells[i], Extended(last ? 1.0 : cells[i + 1].x) - cells[i].x};
    if (!here.is_convex(epsilon)) throw refuse(i, "expected a convex support function");
    if (last) return {here.support(), here.leading()};
    const auto joins = [&](CheckedCell::Value end, double begin) {
      return std::fabs(end.value - begin) <= epsilon * (end.rounding + std::fabs(begin));
    };
    if (!joins(here.support(), cells[i + 1].coefficients[0]))
      throw refuse(i + 1, "expected c0 equal to D at the end of the cell before");
    if (!joins(here.leading(), cells[i + 1].coefficients[1]))
      throw refuse(i + 1, "expected c1 equal to D' at the end of the cell before");
  }
}

void check_facts(const TableFacts& facts, double scale) {
  // The name is one line of a table file.
  for (const char c : facts.law_name) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      throw std::invalid_argument("the name of the table's law has a control character");
  }
  if (!(facts.tolerance > 0.0 && facts.tolerance <= 1.0))
    throw out_of_range("tolerance", facts.tolerance, "1", "0 < tolerance <= 1");
  if (!(facts.checked_error >= 0.0 && facts.checked_error <= facts.tolerance * scale)) {
    throw out_of_range("checked_error", facts.checked_error, "1",
                       "0 <= checked_error <= tolerance * max(force_max, moment_max)");
  }
  if (!(facts.profile_error >= 0.0 && facts.profile_error <= std::numeric_limits<double>::max())) {
    throw out_of_range("profile_error", facts.profile_error, "1", "0 <= profile_error, and finite");
  }
}

}  // namespace

template <class Real>
void check(const TableFacts& facts, const TableCells& cells) {
  constexpr int finest_edge = std::numeric_limits<Real>::digits - 1;
  if (!(cells.index_bits >= Buckets::least_bits && cells.index_bits <= Buckets::most_bits)) {
    throw out_of_range("index_bits", cells.index_bits, "1", "3 to 11");
  }
  if (!(cells.octaves >= 1 && cells.octaves <= finest_edge - cells.index_bits)) {
    throw out_of_range("octaves", cells.octaves, "1", "1 to " + std::to_string(finest_edge - cells.index_bits));
  }
  const Buckets buckets{cells.index_bits, cells.octaves};
  const std::size_t bytes = bytes_of<Real>(cells.inside.size() + cells.outside.size(), cells.degree(), buckets);
  if (bytes > BasicTable<Real>::max_bytes) {
    throw std::invalid_argument("table of " + std::to_string(bytes) + " bytes: expected at most " +
                                std::to_string(BasicTable<Real>::max_bytes));
  }
  const auto [support, force] = check_side<Real>("inside", cells.inside);
  const auto [other_support, moment] = check_side<Real>("outside", cells.outside);
  const Extended forgiven = 4 * Extended(std::numeric_limits<Real>::epsilon()) *
                            (support.rounding + other_support.rounding + force.rounding + moment.rounding);
  if (!(std::fabs(support.value - other_support.value) <= forgiven &&
        std::fabs(force.value + moment.value - support.value) <= forgiven)) {
    throw std::invalid_argument(
        "the two sides of the table differ at the rim (x = 1): expected the same D, force and moment");
  }
  const double force_max = cells.outside.front().coefficients[0];
  const double moment_max = cells.inside.front().coefficients[0];
  // No pressure law has larger or smaller ones, and their squares must be finite.
  constexpr double largest = sizeof(Real) == sizeof(float) ? 1e15 : 1e30;
  for (const double most : {force_max, moment_max}) {
    if (!(most >= 1.0 / largest && most <= largest)) {
      throw out_of_range("the table's largest force or moment", most, "1",
                         format_number(1.0 / largest) + " to " + format_number(largest));
    }
  }
  check_facts(facts, std::max(force_max, moment_max));
}

template void check<double>(const TableFacts&, const TableCells&);
template void check<float>(const TableFacts&, const TableCells&);

}  // namespace limitcurve::table
