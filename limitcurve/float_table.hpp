// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_boundary.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve {

/// A unit wrench in single precision: force f = F/(μP), moment m = M/(μPa), both ≥ 0.
struct FloatWrench {
  float force = 0.0F;
  float moment = 0.0F;

  friend bool operator==(const FloatWrench&, const FloatWrench&) = default;
};

/// A slip twist in single precision, (|v| : a|ω|): both ≥ 0, not both 0, only the ratio matters.
struct FloatTwist {
  float slide = 0.0F;  ///< |v|
  float spin = 1.0F;   ///< a|ω|
};

/// A limit curve as a lookup table in single precision: for many contacts at once, where a float has half the bytes and twice the
/// lanes of a double. Made from a `Table`, whose error and own it certifies together.
///
/// Cubic Hermite interpolation as in `Table`, one 32-byte cell for both components; but the cells end evenly in √(1 − x), x = s
/// inside the rim and 1/s outside: about the density that a half-power or a logarithm at the rim asks for. A cell is so
/// found by a root and a multiplication, without index, comparison or trigonometry, in a vector of contacts as in one.
///
/// f and m keep their relative digits towards the ends, as far as a float has them: down to 1e-38. Neighbouring cells meet to one
/// rounding of the value, so the curve is monotone and convex but for that.
/// Also a limit boundary in double arithmetic, for any finger and projection: then only its coefficients are floats.
class FloatTable {
 public:
  /// The tolerances that a table may have. Below the finest the rounding of floats takes it all.
  static constexpr double finest_tolerance = 5e-7;
  static constexpr double coarsest_tolerance = 1e-1;
  /// Of a side.
  static constexpr std::size_t most_cells = 4096;

  /// The two cubics of a cell in powers of the distance from its left end: f and m inside the rim, m and f outside. The second's
  /// linear coefficient is −left times the first's (dm/df = −s).
  struct alignas(32) Cell {
    float left;
    float rise;
    std::array<float, 2> constant;
    std::array<float, 2> square;
    std::array<float, 2> cube;
  };
  static_assert(sizeof(Cell) == 32);

  /// The table of `law` with |error| ≤ tolerance in f and in m at every twist, rounding included.
  /// Throws std::invalid_argument if the tolerance is out of range, std::runtime_error naming the law if `most_cells` do not
  /// suffice. Cost: that of `Table::build` for an eighth of the tolerance, and some microseconds.
  static FloatTable build(const Law& law, double tolerance);

  /// The same from a table. Throws std::invalid_argument if the table's own error is more than half of the tolerance.
  FloatTable(const Table& table, double tolerance);

  [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
  /// Upper bound of the absolute error of f and of m, by `float_wrench`: the table's, what was found between the ends of
  /// each cell (raised by 2 % for what lies between the places), and a bound of what rounding adds.
  [[nodiscard]] double certified_error() const noexcept { return certified_error_; }
  [[nodiscard]] double moment_ratio() const noexcept { return static_cast<double>(moment_ratio_); }
  [[nodiscard]] std::size_t cell_count() const noexcept { return cells_.size(); }
  [[nodiscard]] std::size_t bytes() const noexcept { return cells_.size() * sizeof(Cell); }  ///< all that a lookup may touch
  /// The cells of a side, from the rim (x = 1) on: number ⌊n √(1 − x)⌋ of n holds x, the last one x = 0.
  [[nodiscard]] std::span<const Cell> inside() const noexcept { return std::span(cells_).first(inside_count_); }
  [[nodiscard]] std::span<const Cell> outside() const noexcept { return std::span(cells_).subspan(inside_count_); }

  /// The wrench that the slip twist causes, in single precision throughout, within certified_error().
  [[nodiscard]] FloatWrench float_wrench(FloatTwist twist) const noexcept {
    const bool outside = twist.slide > twist.spin;
    const float x = std::min(twist.slide, twist.spin) / std::max(twist.slide, twist.spin);
    const Cell& here = cell(outside, x);
    const float d = x - here.left;
    const auto value = [&](std::size_t i, float linear) {
      return (here.constant[i] + d * linear) + (d * d) * (here.square[i] + d * here.cube[i]);
    };
    // By index: compilers turn a choice between numbers into a branch.
    const float components[2] = {value(0, here.rise), value(1, -here.left * here.rise)};
    return {components[outside], components[!outside]};
  }

  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept { return point(twist).wrench; }
  [[nodiscard]] BoundaryPoint point(SlipTwist twist) const noexcept;

  /// Where the ray through `direction` (not zero) meets the curve, and the twist there: at most 60 lookups, 4 to 7 as a rule.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    const double spin = direction.moment / moment_ratio();
    return search_along(*this, direction, spin / (direction.force * moment_ratio() + spin));
  }

  [[nodiscard]] double gauge(UnitWrench wrench) const noexcept {
    return wrench.force + wrench.moment > 0.0 ? gauge_from(wrench, along(wrench).wrench) : 0.0;
  }

 private:
  struct Place {
    bool outside;
    double x;
  };
  static Place place(SlipTwist twist) noexcept {
    return {twist.slide > twist.spin, std::min(twist.slide, twist.spin) / std::max(twist.slide, twist.spin)};
  }

  [[nodiscard]] const Cell& cell(bool outside, float x) const noexcept {
    const float from_rim = std::sqrt(1.0F - x) * counts_[outside];
    const float last = counts_[outside] - 1.0F;
    return cells_[outside * inside_count_ + static_cast<std::size_t>(static_cast<int>(from_rim < last ? from_rim : last))];
  }

  double tolerance_;
  double certified_error_ = 0.0;
  float moment_ratio_ = 0.0F;
  std::array<float, 2> counts_{};  // of cells inside and outside
  std::size_t inside_count_ = 0;
  std::vector<Cell> cells_;  // of the inside from the rim on, then of the outside
};

static_assert(LimitBoundary<FloatTable>);

}  // namespace limitcurve
