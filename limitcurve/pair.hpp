// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace limitcurve {

/// Two numbers side by side: one instruction does the arithmetic of two, with the bits that each alone would have. GCC's and
/// Clang's extension.
using Pair = double __attribute__((vector_size(16)));

/// Numbers twice, read from memory: GCC builds one that it knows from half of it, which takes an instruction more and a register.
struct Paired {
  Pair half;
  Pair one;
  Pair three;
  Pair whole;  ///< so large that the last bits of a sum with it are the other's nearest whole number
  Pair sign;   ///< −0
};
extern const Paired paired;

/// The same place, as one that a compiler knows nothing of: it reads anew what is there. GCC would move a number that it has read to compare its
/// bits to where it is computed with, which takes longer.
template <class Value>
[[gnu::always_inline]] inline const Value& anew(const Value& place) noexcept {
  const Value* address = &place;
  asm("" : "+r"(address));
  return *address;
}

/// Element by element; NaN of what is negative. std::sqrt does the same, but GCC asks each element for its sign, for errno's sake.
[[gnu::always_inline]] inline Pair square_roots(Pair of) noexcept {
#if defined(__SSE2__)
  return _mm_sqrt_pd(of);
#else
  return Pair{std::sqrt(of[0]), std::sqrt(of[1])};
#endif
}

/// Element by element; where one is not a number the second.
[[gnu::always_inline]] inline Pair lesser(Pair one, Pair other) noexcept {
#if defined(__SSE2__)
  return _mm_min_pd(one, other);
#else
  return Pair{one[0] < other[0] ? one[0] : other[0], one[1] < other[1] ? one[1] : other[1]};
#endif
}

/// Likewise.
[[gnu::always_inline]] inline Pair greater(Pair one, Pair other) noexcept {
#if defined(__SSE2__)
  return _mm_max_pd(one, other);
#else
  return Pair{one[0] > other[0] ? one[0] : other[0], one[1] > other[1] ? one[1] : other[1]};
#endif
}

/// Whether the magnitudes of one, element by element, are at most those of two, and those of three at most those of four; not of what is not a
/// number.
[[gnu::always_inline]] inline bool are_within(Pair one, Pair two, Pair three, Pair four) noexcept {
#if defined(__SSE2__)
  const Pair sign = paired.sign;
  return _mm_movemask_pd(_mm_and_pd(_mm_cmple_pd(_mm_andnot_pd(sign, one), two), _mm_cmple_pd(_mm_andnot_pd(sign, three), four))) == 3;
#else
  return std::fabs(one[0]) <= two[0] && std::fabs(one[1]) <= two[1] && std::fabs(three[0]) <= four[0] && std::fabs(three[1]) <= four[1];
#endif
}

/// What comparing two pairs gives.
using PairMask = decltype(Pair{} < Pair{});

/// Whether one and two are the same numbers, element by element, and three and four are.
[[gnu::always_inline]] inline bool same(Pair one, Pair two, Pair three, Pair four) noexcept {
#if defined(__SSE2__)
  return _mm_movemask_pd(_mm_or_pd(_mm_cmpneq_pd(one, two), _mm_cmpneq_pd(three, four))) == 0;
#else
  return one[0] == two[0] && one[1] == two[1] && three[0] == four[0] && three[1] == four[1];
#endif
}

}  // namespace limitcurve
