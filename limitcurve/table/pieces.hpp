// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/arithmetic.hpp"
#include "limitcurve/jet.hpp"

#include <cstdint>

namespace limitcurve {

/// A table as a loop reads it: the support function D(x) of both sides (Jet) as polynomials of degree 6, one a cell. Plain data that the
/// table owns; copies are cheap.
///
/// A cell is found without a search, but where a bucket holds several: next to a place where the curve is singular and that is no end. The distance y = min(x, 1 − x) from the nearer end of [0, 1], raised by `offset` = 2^−d, has an
/// exponent and leading mantissa bits: these number a bucket, the same number of buckets in every octave towards either end, where limit
/// curves may be singular. There are four runs of buckets: inside and outside the rim, near x = 0 and near x = 1. `cell_of_bucket` names the
/// last cell that begins in the bucket or before it. A number that is none counts as 0, so that no index leaves the arrays.
template <class Real>
struct TablePieces {
  const Real* cells = nullptr;  ///< eight numbers a cell: its origin x₀, then c₀ … c₆ of D = Σ cᵢ (x − x₀)ⁱ
  const std::uint16_t* cell_of_bucket = nullptr;  ///< four runs: inside near 0, inside near 1, outside near 0, outside near 1
  Real offset = 0;                                ///< 2^−d
  int dropped_bits = 0;                           ///< of the mantissa
  int first_bucket = 0;                           ///< the leading bits of `offset`
  int buckets = 0;                                ///< in each run
  bool searches = false;                          ///< whether any bucket holds the beginning of a cell other than at its edge

  static constexpr int numbers_per_cell = 8;

  /// D and its derivatives at x ∈ [0, 1]. `Number` is Real or a pack of it, `outside` a bool or the pack's mask.
  template <class Number, class Mask>
  [[nodiscard]] Jet<Number> jet(Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    const auto at = numbers_per_cell * cell(outside, x);
    const Number t = x - gather(cells, at);
    const auto coefficient = [&](int i) { return gather(cells + 1 + i, at); };
    // Horner's scheme for D and its Taylor coefficients at once; each begins one step after the one before.
    Number value = coefficient(6);
    Number first = value;
    value = value * t + coefficient(5);
    Number half_second = first;
    first = first * t + value;
    value = value * t + coefficient(4);
    Number sixth_third = half_second;
    half_second = half_second * t + first;
    first = first * t + value;
    value = value * t + coefficient(3);
    for (int i = 2; i >= 0; --i) {
      sixth_third = sixth_third * t + half_second;
      half_second = half_second * t + first;
      first = first * t + value;
      value = value * t + coefficient(i);
    }
    return {value, first, Number(Real(2)) * half_second, Number(Real(6)) * sixth_third};
  }

  /// The number of the cell that holds x.
  template <class Number, class Mask>
  [[nodiscard]] auto cell(Mask outside, Number x) const noexcept {
    using namespace arithmetic;
    const Number one = Number(Real(1));
    const Number y = max(Number(Real(0)), min(x, one - x));
    const auto bits = leading_bits(y + Number(offset), dropped_bits);
    using Index = decltype(bits + 0);
    const auto run = select(x > one - x, Index{} + buckets, Index{}) + select(outside, Index{} + 2 * buckets, Index{});
    const auto last = gather(cell_of_bucket, bits - first_bucket + run);
    return searches ? search(last, x) : last;
  }

 private:
  /// The cell at or before `cell` that begins at or before x.
  template <class Index, class Number>
  [[nodiscard]] Index search(Index cell, Number x) const noexcept {
    using namespace arithmetic;
    while (true) {
      const Number begin = gather(cells, numbers_per_cell * cell);
      // The first cell of a side begins at 0.
      const auto is_beyond = begin > max(Number(Real(0)), x);
      if (!any(is_beyond)) return cell;
      cell = cell - select(is_beyond, Index{} + 1, Index{});
    }
  }
};

}  // namespace limitcurve
