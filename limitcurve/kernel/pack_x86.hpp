// SPDX-License-Identifier: MIT
#pragma once

#include "pack.hpp"

#include <immintrin.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/// What packs do by instructions of x86-64 that compilers do not find themselves.
namespace limitcurve::kernel {

// ---- AVX2

// In the units of numbers, where their masks are.
template <class Real>
[[nodiscard]] Pack<Real, Avx2> select(Mask<Real, Avx2> condition, Pack<Real, Avx2> yes, Pack<Real, Avx2> no) noexcept {
  const auto bits = (__m256)condition.bits;
  const __m256 chosen = _mm256_or_ps(_mm256_and_ps(bits, (__m256)yes.lanes), _mm256_andnot_ps(bits, (__m256)no.lanes));
  return Pack<Real, Avx2>((typename Pack<Real, Avx2>::Numbers)chosen);
}
template <class Real>
[[nodiscard]] bool any(Mask<Real, Avx2> condition) noexcept {
  return _mm256_movemask_ps((__m256)condition.bits) != 0;
}

// The processor's min and max return their second argument if one is NaN.
template <class Real>
[[nodiscard]] Pack<Real, Avx2> smaller(Pack<Real, Avx2> a, Pack<Real, Avx2> b) noexcept {
  if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Avx2>(_mm256_min_pd(b.lanes, a.lanes));
  } else {
    return Pack<Real, Avx2>(_mm256_min_ps(b.lanes, a.lanes));
  }
}
template <class Real>
[[nodiscard]] Pack<Real, Avx2> larger(Pack<Real, Avx2> a, Pack<Real, Avx2> b) noexcept {
  if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Avx2>(_mm256_max_pd(b.lanes, a.lanes));
  } else {
    return Pack<Real, Avx2>(_mm256_max_ps(b.lanes, a.lanes));
  }
}

template <class Real, class State>
void store_states(Index<Real, Avx2> lanes, State* states) noexcept {
  __m128i low = _mm256_castsi256_si128((__m256i)lanes.lanes);
  __m128i high = _mm256_extracti128_si256((__m256i)lanes.lanes, 1);
  if constexpr (sizeof(Real) == 8)
    low = high = (__m128i)_mm_shuffle_ps((__m128)low, (__m128)high, _MM_SHUFFLE(2, 0, 2, 0));
  low = _mm_packs_epi32(low, high);
  low = _mm_packs_epi16(low, low);
  __builtin_memcpy(states, &low, Pack<Real, Avx2>::size);
}

template <class Real>
[[nodiscard]] Pack<Real, Avx2> gather(const Real* array, Index<Real, Avx2> at) noexcept {
  if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Avx2>(_mm256_i64gather_pd(array, (__m256i)at.lanes, 8));
  } else {
    return Pack<Real, Avx2>(_mm256_i32gather_ps(array, (__m256i)at.lanes, 4));
  }
}
template <class Real>
[[nodiscard]] Index<Real, Avx2> gather(const std::uint16_t* array, Index<Real, Avx2> at) noexcept {
  using Integers = typename Index<Real, Avx2>::Integers;
  const auto word = (__m256i)(at.lanes >> 1);
  const auto* const words = reinterpret_cast<const int*>(array);
  Integers found;
  if constexpr (sizeof(Real) == 8) {
    found = (Integers)_mm256_cvtepu32_epi64(_mm256_i64gather_epi32(words, word, 4));
  } else {
    found = (Integers)_mm256_i32gather_epi32(words, word, 4);
  }
  return Index<Real, Avx2>((found >> ((at.lanes & 1) * 16)) & 0xFFFF);
}

// ---- AVX-512

/// One bit for each lane.
template <class Real>
struct Mask<Real, Avx512> {
  using Numbers = typename Registers<Real, Avx512>::Numbers;
  using Bits = std::conditional_t<sizeof(Real) == 8, __mmask8, __mmask16>;
  Bits bits;

  static Mask less(Numbers a, Numbers b) noexcept { return compared<_CMP_LT_OQ>(a, b); }
  static Mask not_greater(Numbers a, Numbers b) noexcept { return compared<_CMP_LE_OQ>(a, b); }
  static Mask different(Numbers a, Numbers b) noexcept { return compared<_CMP_NEQ_UQ>(a, b); }
  friend Mask operator&&(Mask a, Mask b) noexcept { return {(Bits)(a.bits & b.bits)}; }
  friend Mask operator||(Mask a, Mask b) noexcept { return {(Bits)(a.bits | b.bits)}; }
  friend Mask operator!(Mask a) noexcept { return {(Bits)~a.bits}; }

 private:
  template <int predicate>
  static Mask compared(Numbers a, Numbers b) noexcept {
    if constexpr (sizeof(Real) == 8) {
      return {_mm512_cmp_pd_mask(a, b, predicate)};
    } else {
      return {_mm512_cmp_ps_mask(a, b, predicate)};
    }
  }
};

template <class Real>
[[nodiscard]] Index<Real, Avx512> select(Mask<Real, Avx512> condition, Index<Real, Avx512> yes,
                                         Index<Real, Avx512> no) noexcept {
  using Integers = typename Index<Real, Avx512>::Integers;
  if constexpr (sizeof(Real) == 8) {
    return Index<Real, Avx512>(
        (Integers)_mm512_mask_blend_epi64(condition.bits, (__m512i)no.lanes, (__m512i)yes.lanes));
  } else {
    return Index<Real, Avx512>(
        (Integers)_mm512_mask_blend_epi32(condition.bits, (__m512i)no.lanes, (__m512i)yes.lanes));
  }
}
template <class Real>
[[nodiscard]] bool any(Mask<Real, Avx512> condition) noexcept {
  return condition.bits != 0;
}

template <class Real>
[[nodiscard]] Pack<Real, Avx512> smaller(Pack<Real, Avx512> a, Pack<Real, Avx512> b) noexcept {
  if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Avx512>(_mm512_maskz_min_pd(0xFF, b.lanes, a.lanes));
  } else {
    return Pack<Real, Avx512>(_mm512_maskz_min_ps(0xFFFF, b.lanes, a.lanes));
  }
}
template <class Real>
[[nodiscard]] Pack<Real, Avx512> larger(Pack<Real, Avx512> a, Pack<Real, Avx512> b) noexcept {
  if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Avx512>(_mm512_maskz_max_pd(0xFF, b.lanes, a.lanes));
  } else {
    return Pack<Real, Avx512>(_mm512_maskz_max_ps(0xFFFF, b.lanes, a.lanes));
  }
}

template <class Real>
[[nodiscard]] Pack<Real, Avx512> gather(const Real* array, Index<Real, Avx512> at) noexcept {
  if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Avx512>(_mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xFF, (__m512i)at.lanes, array, 8));
  } else {
    return Pack<Real, Avx512>(_mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xFFFF, (__m512i)at.lanes, array, 4));
  }
}
template <class Real>
[[nodiscard]] Index<Real, Avx512> gather(const std::uint16_t* array, Index<Real, Avx512> at) noexcept {
  using Integers = typename Index<Real, Avx512>::Integers;
  const auto word = (__m512i)(at.lanes >> 1);
  Integers words;
  if constexpr (sizeof(Real) == 8) {
    words = (Integers)_mm512_maskz_cvtepu32_epi64(
        0xFF, _mm512_mask_i64gather_epi32(_mm256_setzero_si256(), 0xFF, word, array, 4));
  } else {
    words = (Integers)_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xFFFF, word, array, 4);
  }
  return Index<Real, Avx512>((words >> ((at.lanes & 1) * 16)) & 0xFFFF);
}

template <class Real, class State>
[[nodiscard]] __m128i load_states(const State* states) noexcept {
  const auto* const from = reinterpret_cast<const __m128i*>(states);
  return sizeof(Real) == 8 ? _mm_loadl_epi64(from) : _mm_loadu_si128(from);
}
template <class Real, class State>
[[nodiscard]] Mask<Real, Avx512> has_state(const State* states, State wanted, Pack<Real, Avx512>) noexcept {
  return {(typename Mask<Real, Avx512>::Bits)_mm_cmpeq_epi8_mask(load_states<Real>(states),
                                                                 _mm_set1_epi8(static_cast<char>(wanted)))};
}
template <class Real, class State>
void set_states_where(Mask<Real, Avx512> where, State* states, Mask<Real, Avx512> first, Mask<Real, Avx512> second,
                      const std::array<State, 3>& values, Pack<Real, Avx512>) noexcept {
  const auto all = [&](std::size_t i) { return _mm_set1_epi8(static_cast<char>(values[i])); };
  __m128i bytes = _mm_mask_blend_epi8(first.bits, all(0), _mm_mask_blend_epi8(second.bits, all(1), all(2)));
  if (any(!where)) bytes = _mm_mask_blend_epi8(where.bits, load_states<Real>(states), bytes);
  __builtin_memcpy(states, &bytes, Pack<Real, Avx512>::size);
}

// ---- AVX2 and AVX-512

template <class Isa>
concept Wide = (Isa::bytes > 16);

/// Eight numbers in a row from array[at] on, in each lane: loaded in one piece and transposed, because gathers are
/// slow.
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
template <Wide Isa>
struct LoadedCell<double, Isa> {
  using Number = Pack<double, Isa>;
  std::array<Number, 8> low;   // the origin twice, and the pairs of coefficients 0 to 2
  std::array<Number, 8> high;  // 3 to 6, as far as the table has them
  Mask<double, Isa> outside;

  LoadedCell(Index<double, Isa> at, const double* array, Mask<double, Isa> is_outside) noexcept
      : low(load_rows(array, at)), high(load_rows(array + 8, at)), outside(is_outside) {}

  [[nodiscard]] Number origin() const noexcept { return low[0]; }
  [[nodiscard]] Number force(int i) const noexcept { return pair(i)[0]; }
  [[nodiscard]] Number moment(int i) const noexcept { return pair(i)[1]; }
  [[nodiscard]] Number leading(int i) const noexcept { return select(outside, moment(i), force(i)); }
  [[nodiscard]] Number trailing(int i) const noexcept { return select(outside, force(i), moment(i)); }

 private:
  [[nodiscard]] const Number* pair(int i) const noexcept {
    const auto at = static_cast<std::size_t>(2 * i);
    return i < 3 ? &low[at + 2] : &high[at - 6];
  }
};

}  // namespace limitcurve::kernel
