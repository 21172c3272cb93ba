// SPDX-License-Identifier: MIT
#pragma once

#include "pack.hpp"

#include <array>
#include <cstddef>

/// A cell of a table for each lane of a pack, under the names of that of a single number (limitcurve/arithmetic.hpp).
namespace limitcurve::godobject::kernel {

/// Eight numbers in a row from array[at] on, in each lane: loaded in one piece and transposed, because gathers are slow.
template <class Isa>
[[nodiscard]] std::array<Pack<double, Isa>, 8> load_rows(const double* array, Index<double, Isa> at) noexcept {
  using Result = Pack<double, Isa>;
  std::array<Result, 8> result;
  if constexpr (Isa::bytes == 64) {
    __m512d rows[8];
    __m512d twos[8];
    __m512d fours[8];
    for (int i = 0; i < 8; ++i) rows[i] = _mm512_loadu_pd(array + at.lanes[i]);
    for (int i = 0; i < 8; i += 2) {
      twos[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
      twos[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int half = 0; half < 8; half += 4) {
      for (int i = half; i < half + 2; ++i) {
        fours[i] = __builtin_shufflevector(twos[i], twos[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        fours[i + 2] = __builtin_shufflevector(twos[i], twos[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      result[i] = Result(__builtin_shufflevector(fours[i], fours[i + 4], 0, 1, 2, 3, 8, 9, 10, 11));
      result[i + 4] = Result(__builtin_shufflevector(fours[i], fours[i + 4], 4, 5, 6, 7, 12, 13, 14, 15));
    }
  } else {
    for (std::size_t half = 0; half < 8; half += 4) {
      __m256d rows[4];
      __m256d twos[4];
      for (std::size_t i = 0; i < 4; ++i) rows[i] = _mm256_loadu_pd(array + half + at.lanes[i]);
      for (std::size_t i = 0; i < 4; i += 2) {
        twos[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 4, 2, 6);
        twos[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 1, 5, 3, 7);
      }
      for (std::size_t i = 0; i < 2; ++i) {
        result[half + i] = Result(__builtin_shufflevector(twos[i], twos[i + 2], 0, 1, 4, 5));
        result[half + i + 2] = Result(__builtin_shufflevector(twos[i], twos[i + 2], 2, 3, 6, 7));
      }
    }
  }
  return result;
}

/// A cell of a table for each lane.
template <class Real, class Isa, bool in_rows = (sizeof(Real) == 8 && Isa::bytes > 16)>
struct LoadedCell {
  const Real* array;
  Index<Real, Isa> at;
  Mask<Real, Isa> outside;

  [[nodiscard]] Pack<Real, Isa> origin() const noexcept { return gather(array, at); }
  [[nodiscard]] Pack<Real, Isa> leading(int i) const noexcept { return gather(array + 2 * i + 2, at + one_of({0, 1}, outside, at)); }
  [[nodiscard]] Pack<Real, Isa> trailing(int i) const noexcept { return gather(array + 2 * i + 2, at + one_of({1, 0}, outside, at)); }
};
template <class Real, class Isa>
struct LoadedCell<Real, Isa, true> {
  std::array<Pack<Real, Isa>, 8> low;   // the origin twice, and the pairs of coefficients 0 to 2
  std::array<Pack<Real, Isa>, 8> high;  // 3 to 6, as far as the table has them
  Mask<Real, Isa> outside;

  LoadedCell(const Real* array, Index<Real, Isa> at, Mask<Real, Isa> is_outside) noexcept
      : low(load_rows(array, at)), high(load_rows(array + 8, at)), outside(is_outside) {}

  [[nodiscard]] Pack<Real, Isa> origin() const noexcept { return low[0]; }
  [[nodiscard]] Pack<Real, Isa> leading(int i) const noexcept { return select(outside, pair(i)[1], pair(i)[0]); }
  [[nodiscard]] Pack<Real, Isa> trailing(int i) const noexcept { return select(outside, pair(i)[0], pair(i)[1]); }

 private:
  [[nodiscard]] const Pack<Real, Isa>* pair(int i) const noexcept { return i < 3 ? &low[2 * i + 2] : &high[2 * i - 6]; }
};
template <class Real, class Isa>
[[nodiscard]] LoadedCell<Real, Isa> load_cell(const Real* array, Index<Real, Isa> at, Mask<Real, Isa> outside) noexcept {
  return {array, at, outside};
}

}  // namespace limitcurve::godobject::kernel
