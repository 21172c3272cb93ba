// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/arithmetic.hpp"

#include <immintrin.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/// Packs of numbers, one vector register each, under the names of single numbers (limitcurve/arithmetic.hpp, batch/step.hpp). A template on
/// Number then computes as many results as a pack has lanes, with the same bits. The only header with extensions of GCC and Clang.
///
/// The instruction set is part of every type's name: sources that are compiled for different processors share no function that the linker
/// could take from the wrong one.
namespace limitcurve::godobject::kernel {

/// Instruction sets.
struct Sse2 {
  static constexpr int bytes = 16;
};
struct Avx2 {
  static constexpr int bytes = 32;
};
struct Avx512 {
  static constexpr int bytes = 64;
};

/// The registers of an instruction set for numbers of one type.
template <class Real, class Isa>
struct Registers {
  static constexpr std::size_t lanes = Isa::bytes / sizeof(Real);
  typedef Real Numbers __attribute__((vector_size(Isa::bytes)));
  typedef Real Unaligned __attribute__((vector_size(Isa::bytes), aligned(alignof(Real))));
  using Integers = decltype(Numbers{} < Numbers{});  // of the numbers' width
  using Integer = std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>;
};

/// The result of comparing packs: all bits of a lane, or none. With AVX-512 one bit for each lane.
template <class Real, class Isa>
struct Mask {
  using Narrow = std::conditional_t<sizeof(Real) == 8, std::uint8_t, std::uint16_t>;
  using Bits = std::conditional_t<Isa::bytes == 64, Narrow, typename Registers<Real, Isa>::Integers>;
  Bits bits;

  friend Mask operator&&(Mask a, Mask b) noexcept { return {(Bits)(a.bits & b.bits)}; }
  friend Mask operator||(Mask a, Mask b) noexcept { return {(Bits)(a.bits | b.bits)}; }
  friend Mask operator!(Mask a) noexcept { return {(Bits)~a.bits}; }
};

/// Integers, one for each lane.
template <class Real, class Isa>
struct Index {
  using Integers = typename Registers<Real, Isa>::Integers;
  Integers lanes{};

  Index() noexcept = default;
  Index(int all) noexcept : lanes(typename Registers<Real, Isa>::Integer{all} - Integers{}) {}  // NOLINT: meant to convert
  explicit Index(Integers of_lanes) noexcept : lanes(of_lanes) {}

  friend Index operator+(Index a, Index b) noexcept { return Index(a.lanes + b.lanes); }
  friend Index operator-(Index a, Index b) noexcept { return Index(a.lanes - b.lanes); }
  friend Index operator*(Index a, Index b) noexcept { return Index(a.lanes * b.lanes); }
};

template <class Real, class Isa>
struct Pack {
  using Numbers = typename Registers<Real, Isa>::Numbers;
  static constexpr std::size_t size = Registers<Real, Isa>::lanes;
  Numbers lanes;

  Pack() noexcept = default;
  explicit Pack(Real all) noexcept : lanes(all - Numbers{}) {}
  explicit Pack(Numbers of_lanes) noexcept : lanes(of_lanes) {}

  friend Pack operator+(Pack a, Pack b) noexcept { return Pack(a.lanes + b.lanes); }
  friend Pack operator-(Pack a, Pack b) noexcept { return Pack(a.lanes - b.lanes); }
  friend Pack operator*(Pack a, Pack b) noexcept { return Pack(a.lanes * b.lanes); }
  friend Pack operator/(Pack a, Pack b) noexcept { return Pack(a.lanes / b.lanes); }
  friend Pack operator-(Pack a) noexcept { return Pack(-a.lanes); }
  friend Mask<Real, Isa> operator<(Pack a, Pack b) noexcept { return mask<_CMP_LT_OQ>(a, b, a.lanes < b.lanes); }
  friend Mask<Real, Isa> operator>(Pack a, Pack b) noexcept { return b < a; }
  friend Mask<Real, Isa> operator<=(Pack a, Pack b) noexcept { return mask<_CMP_LE_OQ>(a, b, a.lanes <= b.lanes); }
  friend Mask<Real, Isa> operator>=(Pack a, Pack b) noexcept { return b <= a; }
  friend Mask<Real, Isa> operator!=(Pack a, Pack b) noexcept { return mask<_CMP_NEQ_UQ>(a, b, a.lanes != b.lanes); }

 private:
  /// The comparison `predicate`, or its result without AVX-512.
  template <int predicate>
  static Mask<Real, Isa> mask(Pack a, Pack b, typename Registers<Real, Isa>::Integers compared) noexcept {
    if constexpr (Isa::bytes < 64) {
      return {compared};
    } else if constexpr (sizeof(Real) == 8) {
      return {_mm512_cmp_pd_mask(a.lanes, b.lanes, predicate)};
    } else {
      return {_mm512_cmp_ps_mask(a.lanes, b.lanes, predicate)};
    }
  }
};

// By intrinsics, because compilers split `?:` of vectors if the processor cannot compare integers of that width.
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> select(Mask<Real, Isa> condition, Pack<Real, Isa> yes, Pack<Real, Isa> no) noexcept {
  using Numbers = typename Registers<Real, Isa>::Numbers;
  if constexpr (Isa::bytes == 64 && sizeof(Real) == 8) {
    return Pack<Real, Isa>(_mm512_mask_blend_pd(condition.bits, no.lanes, yes.lanes));
  } else if constexpr (Isa::bytes == 64) {
    return Pack<Real, Isa>(_mm512_mask_blend_ps(condition.bits, no.lanes, yes.lanes));
  } else if constexpr (Isa::bytes == 32) {
    const auto bits = (__m256)condition.bits;
    return Pack<Real, Isa>((Numbers)_mm256_or_ps(_mm256_and_ps(bits, (__m256)yes.lanes), _mm256_andnot_ps(bits, (__m256)no.lanes)));
  } else {
    const auto bits = (__m128)condition.bits;
    return Pack<Real, Isa>((Numbers)_mm_or_ps(_mm_and_ps(bits, (__m128)yes.lanes), _mm_andnot_ps(bits, (__m128)no.lanes)));
  }
}
template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> one_of(const std::array<int, 2>& values, Mask<Real, Isa> condition, Index<Real, Isa> /*type*/) noexcept {
  using Lanes = Index<Real, Isa>;
  using Numbers = typename Registers<Real, Isa>::Numbers;
  const auto as_numbers = [](int value) { return Pack<Real, Isa>((Numbers)Lanes(value).lanes); };
  return Lanes((typename Lanes::Integers)select(condition, as_numbers(values[1]), as_numbers(values[0])).lanes);
}
template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> not_negative(Index<Real, Isa> i) noexcept {
  return Index<Real, Isa>(i.lanes & ~(i.lanes >> (8 * sizeof(Real) - 1)));
}

template <class Real, class Isa>
[[nodiscard]] bool any(Mask<Real, Isa> condition) noexcept {
  if constexpr (Isa::bytes == 64) {
    return condition.bits != 0;
  } else if constexpr (Isa::bytes == 32) {
    return _mm256_movemask_ps((__m256)condition.bits) != 0;
  } else {
    return _mm_movemask_ps((__m128)condition.bits) != 0;
  }
}

// The processor's min and max return their second argument if the first is NaN.
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> smaller(Pack<Real, Isa> a, Pack<Real, Isa> b) noexcept {
  if constexpr (Isa::bytes == 64 && sizeof(Real) == 8) {
    return Pack<Real, Isa>(_mm512_maskz_min_pd(0xFF, b.lanes, a.lanes));
  } else if constexpr (Isa::bytes == 64) {
    return Pack<Real, Isa>(_mm512_maskz_min_ps(0xFFFF, b.lanes, a.lanes));
  } else if constexpr (Isa::bytes == 32 && sizeof(Real) == 8) {
    return Pack<Real, Isa>(_mm256_min_pd(b.lanes, a.lanes));
  } else if constexpr (Isa::bytes == 32) {
    return Pack<Real, Isa>(_mm256_min_ps(b.lanes, a.lanes));
  } else if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Isa>(_mm_min_pd(b.lanes, a.lanes));
  } else {
    return Pack<Real, Isa>(_mm_min_ps(b.lanes, a.lanes));
  }
}
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> larger(Pack<Real, Isa> a, Pack<Real, Isa> b) noexcept {
  if constexpr (Isa::bytes == 64 && sizeof(Real) == 8) {
    return Pack<Real, Isa>(_mm512_maskz_max_pd(0xFF, b.lanes, a.lanes));
  } else if constexpr (Isa::bytes == 64) {
    return Pack<Real, Isa>(_mm512_maskz_max_ps(0xFFFF, b.lanes, a.lanes));
  } else if constexpr (Isa::bytes == 32 && sizeof(Real) == 8) {
    return Pack<Real, Isa>(_mm256_max_pd(b.lanes, a.lanes));
  } else if constexpr (Isa::bytes == 32) {
    return Pack<Real, Isa>(_mm256_max_ps(b.lanes, a.lanes));
  } else if constexpr (sizeof(Real) == 8) {
    return Pack<Real, Isa>(_mm_max_pd(b.lanes, a.lanes));
  } else {
    return Pack<Real, Isa>(_mm_max_ps(b.lanes, a.lanes));
  }
}
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> abs(Pack<Real, Isa> a) noexcept {
  using Integers = typename Registers<Real, Isa>::Integers;
  const auto sign = (Integers)Pack<Real, Isa>(Real(-0.0)).lanes;
  return Pack<Real, Isa>((typename Pack<Real, Isa>::Numbers)((Integers)a.lanes & ~sign));
}
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> sqrt(Pack<Real, Isa> a) noexcept {
  constexpr bool is_double = sizeof(Real) == 8;
  if constexpr (Isa::bytes == 64) {
    if constexpr (is_double) {
      return Pack<Real, Isa>(_mm512_maskz_sqrt_pd(0xFF, a.lanes));
    } else {
      return Pack<Real, Isa>(_mm512_maskz_sqrt_ps(0xFFFF, a.lanes));
    }
  } else if constexpr (Isa::bytes == 32) {
    if constexpr (is_double) {
      return Pack<Real, Isa>(_mm256_sqrt_pd(a.lanes));
    } else {
      return Pack<Real, Isa>(_mm256_sqrt_ps(a.lanes));
    }
  } else {
    if constexpr (is_double) {
      return Pack<Real, Isa>(_mm_sqrt_pd(a.lanes));
    } else {
      return Pack<Real, Isa>(_mm_sqrt_ps(a.lanes));
    }
  }
}

template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> leading_bits(Pack<Real, Isa> a, int dropped) noexcept {
  return Index<Real, Isa>((typename Index<Real, Isa>::Integers)a.lanes >> dropped);
}

template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> gather(const Real* array, Index<Real, Isa> at) noexcept {
  using Result = Pack<Real, Isa>;
  constexpr bool is_double = sizeof(Real) == 8;
  if constexpr (Isa::bytes == 64) {
    if constexpr (is_double) {
      return Result(_mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xFF, (__m512i)at.lanes, array, 8));
    } else {
      return Result(_mm512_mask_i32gather_ps(_mm512_setzero_ps(), 0xFFFF, (__m512i)at.lanes, array, 4));
    }
  } else if constexpr (Isa::bytes == 32) {
    if constexpr (is_double) {
      return Result(_mm256_i64gather_pd(array, (__m256i)at.lanes, 8));
    } else {
      return Result(_mm256_i32gather_ps(array, (__m256i)at.lanes, 4));
    }
  } else {
    Result result;
    for (std::size_t lane = 0; lane < Result::size; ++lane) result.lanes[lane] = array[at.lanes[lane]];
    return result;
  }
}
/// The array must have an even length and the alignment of a 32-bit word, because the processor gathers no smaller words.
template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> gather(const std::uint16_t* array, Index<Real, Isa> at) noexcept {
  using Integers = typename Index<Real, Isa>::Integers;
  if constexpr (Isa::bytes == 16) {
    Index<Real, Isa> result;
    for (std::size_t lane = 0; lane < Pack<Real, Isa>::size; ++lane) result.lanes[lane] = array[at.lanes[lane]];
    return result;
  } else {
    const Integers word = at.lanes >> 1;
    Integers words;
    if constexpr (Isa::bytes == 64 && sizeof(Real) == 8) {
      words =
          (Integers)_mm512_maskz_cvtepu32_epi64(0xFF, _mm512_mask_i64gather_epi32(_mm256_setzero_si256(), 0xFF, (__m512i)word, array, 4));
    } else if constexpr (Isa::bytes == 64) {
      words = (Integers)_mm512_mask_i32gather_epi32(_mm512_setzero_si512(), 0xFFFF, (__m512i)word, array, 4);
    } else if constexpr (sizeof(Real) == 8) {
      words = (Integers)_mm256_cvtepu32_epi64(_mm256_i64gather_epi32((const int*)array, (__m256i)word, 4));
    } else {
      words = (Integers)_mm256_i32gather_epi32((const int*)array, (__m256i)word, 4);
    }
    return Index<Real, Isa>((words >> ((at.lanes & 1) * 16)) & 0xFFFF);
  }
}

template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> load(const Real* from, Pack<Real, Isa> result) noexcept {
  result.lanes = *reinterpret_cast<const typename Registers<Real, Isa>::Unaligned*>(from);
  return result;
}
template <class Real, class Isa>
void store_where(Mask<Real, Isa> condition, Real* to, Pack<Real, Isa> value) noexcept {
  if constexpr (Isa::bytes == 64 && sizeof(Real) == 8) {
    _mm512_mask_storeu_pd(to, condition.bits, value.lanes);
  } else if constexpr (Isa::bytes == 64) {
    _mm512_mask_storeu_ps(to, condition.bits, value.lanes);
  } else {
    // In the common case all lanes are written, and none need be read.
    if (any(!condition)) value = select(condition, value, load(to, value));
    *reinterpret_cast<typename Registers<Real, Isa>::Unaligned*>(to) = value.lanes;
  }
}

/// A mask from bytes that are 0 or −1, the lowest ones.
template <class Real, class Isa>
[[nodiscard]] Mask<Real, Isa> widen(__m128i bytes) noexcept {
  using Bits = typename Mask<Real, Isa>::Bits;
  constexpr bool is_double = sizeof(Real) == 8;
  if constexpr (Isa::bytes == 64) {
    return {(Bits)_mm_movepi8_mask(bytes)};
  } else if constexpr (Isa::bytes == 32) {
    if constexpr (is_double) {
      return {(Bits)_mm256_cvtepi8_epi64(bytes)};
    } else {
      return {(Bits)_mm256_cvtepi8_epi32(bytes)};
    }
  } else {
    bytes = _mm_unpacklo_epi8(bytes, bytes);
    bytes = _mm_unpacklo_epi16(bytes, bytes);
    return {(Bits)(is_double ? _mm_unpacklo_epi32(bytes, bytes) : bytes)};
  }
}
/// The inverse.
template <class Real, class Isa>
[[nodiscard]] __m128i narrow(Mask<Real, Isa> mask) noexcept {
  if constexpr (Isa::bytes == 64) {
    return _mm_movm_epi8(mask.bits);
  } else {
    __m128i low;
    __m128i high;
    if constexpr (Isa::bytes == 32) {
      low = _mm256_castsi256_si128((__m256i)mask.bits);
      high = _mm256_extracti128_si256((__m256i)mask.bits, 1);
    } else {
      low = high = (__m128i)mask.bits;
    }
    if constexpr (sizeof(Real) == 8) low = high = (__m128i)_mm_shuffle_ps((__m128)low, (__m128)high, _MM_SHUFFLE(2, 0, 2, 0));
    low = _mm_packs_epi32(low, high);
    return _mm_packs_epi16(low, low);
  }
}

/// States of lanes: an enumeration of one byte, one for each lane.
template <class Real, class Isa, class State>
[[nodiscard]] __m128i load_states(const State* states) noexcept {
  constexpr std::size_t count = Pack<Real, Isa>::size;
  if constexpr (count == 16) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(states));
  } else {
    std::conditional_t<count == 8, std::int64_t, std::conditional_t<count == 4, std::int32_t, std::int16_t>> word;
    __builtin_memcpy(&word, states, count);
    return _mm_cvtsi64_si128(word);
  }
}
template <class Real, class Isa, class State>
[[nodiscard]] Mask<Real, Isa> has_state(const State* states, State wanted, Pack<Real, Isa>) noexcept {
  return widen<Real, Isa>(_mm_cmpeq_epi8(load_states<Real, Isa>(states), _mm_set1_epi8(static_cast<char>(wanted))));
}
/// Where `where` holds: states = !first ? values[0] : !second ? values[1] : values[2].
template <class Real, class Isa, class State>
void set_states_where(Mask<Real, Isa> where, State* states, Mask<Real, Isa> first, Mask<Real, Isa> second,
                      const std::array<State, 3>& values, Pack<Real, Isa>) noexcept {
  const auto choose = [](Mask<Real, Isa> mask, __m128i yes, __m128i no) {
    const __m128i bits = narrow(mask);
    return _mm_or_si128(_mm_and_si128(bits, yes), _mm_andnot_si128(bits, no));
  };
  const auto all = [&](std::size_t i) { return _mm_set1_epi8(static_cast<char>(values[i])); };
  __m128i bytes = choose(first, choose(second, all(2), all(1)), all(0));
  if (any(!where)) bytes = choose(where, bytes, load_states<Real, Isa>(states));
  __builtin_memcpy(states, &bytes, Pack<Real, Isa>::size);
}

/// The lanes of a pack as an array, for functions that have no form for packs.
template <class Real, class Isa>
using Lanes = std::array<Real, Pack<Real, Isa>::size>;

template <class Real, class Isa>
[[nodiscard]] Lanes<Real, Isa> lanes_of(Pack<Real, Isa> pack) noexcept {
  Lanes<Real, Isa> result;
  __builtin_memcpy(&result, &pack.lanes, sizeof result);
  return result;
}
template <class Isa, class Real, std::size_t size>
[[nodiscard]] Pack<Real, Isa> pack_of(const std::array<Real, size>& lanes) noexcept {
  Pack<Real, Isa> result;
  __builtin_memcpy(&result.lanes, &lanes, sizeof result.lanes);
  return result;
}

}  // namespace limitcurve::godobject::kernel
