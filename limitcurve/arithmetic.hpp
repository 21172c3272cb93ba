// SPDX-License-Identifier: MIT
#pragma once

// Internal: installed because other headers need it; it may change in every version.

#include "version.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

// The linker keeps one copy of a template for all files. A copy from a user's file could replace the library's, with
// other roundings
// (-march=native) or without NaN and infinity (-ffast-math). So the library's copies of templates built on this file
// are in a namespace of their own, and so are those of a file with -ffast-math.
#if defined(LIMITCURVE_LIBRARY)
#define LIMITCURVE_COPIES library
#elif defined(__FAST_MATH__)
#define LIMITCURVE_COPIES fast_math
#endif

/// Arithmetic of a single number, under the names that packs of numbers use. Table look-up and friction are templates
/// written with these names; they serve a single finger (`double`) and a batch (packs, kernel/).
namespace limitcurve::arithmetic {

/// `yes` if the condition holds, else `no`.
template <class Value>
[[nodiscard]] constexpr Value select(bool condition, Value yes, Value no) noexcept {
  return condition ? yes : no;
}
/// values[0], or values[1] if the condition holds, as an Index. Without a branch, because one on the side of the rim
/// would often be mispredicted.
template <std::integral Index>
[[nodiscard]] constexpr Index one_of(const std::array<int, 2>& values, bool condition, Index /*type*/) noexcept {
  return values[static_cast<std::size_t>(condition)];
}

/// Whether the condition holds in any lane of a pack. A single number is one lane.
[[nodiscard]] constexpr bool any(bool condition) noexcept {
  return condition;
}

/// The smaller of two numbers; `a` if `b` is NaN. (`min` is a macro on Windows.)
template <std::floating_point Real>
[[nodiscard]] constexpr Real smaller(Real a, Real b) noexcept {
  return b < a ? b : a;
}
/// The larger of two numbers; `a` if `b` is NaN.
template <std::floating_point Real>
[[nodiscard]] constexpr Real larger(Real a, Real b) noexcept {
  return a < b ? b : a;
}
template <std::floating_point Real>
[[nodiscard]] inline Real abs(Real a) noexcept {
  return std::fabs(a);
}
template <std::floating_point Real>
[[nodiscard]] inline Real sqrt(Real a) noexcept {
  return std::sqrt(a);
}

/// Sign, exponent and leading mantissa bits of a number, as an integer: its bits without the last `dropped` ones.
[[nodiscard]] constexpr std::int64_t leading_bits(double a, int dropped) noexcept {
  return std::bit_cast<std::int64_t>(a) >> dropped;
}
[[nodiscard]] constexpr std::int32_t leading_bits(float a, int dropped) noexcept {
  return std::bit_cast<std::int32_t>(a) >> dropped;
}

/// array[i]. An entry of an array of small integers is converted to the type of the index.
template <std::floating_point Real, std::integral Index>
[[nodiscard]] constexpr Real gather(const Real* array, Index i) noexcept {
  return array[i];
}
template <std::integral Index>
[[nodiscard]] constexpr Index gather(const std::uint16_t* array, Index i) noexcept {
  return static_cast<Index>(array[i]);
}

/// The larger of an index and 0.
template <std::integral Index>
[[nodiscard]] constexpr Index not_negative(Index i) noexcept {
  return i & ~(i >> (8 * sizeof(Index) - 1));
}

/// Two numbers that one instruction serves, where the compiler has such types. Loaded from memory of their alignment.
#ifdef __GNUC__
template <class Real>
struct PairOf {
  typedef Real Type __attribute__((vector_size(2 * sizeof(Real))));
};
template <class Real>
using Pair = typename PairOf<Real>::Type;
template <class Real>
[[nodiscard]] inline Pair<Real> load_pair(const Real* from) noexcept {
  Pair<Real> result;
  __builtin_memcpy(&result, __builtin_assume_aligned(from, sizeof result), sizeof result);
  return result;
}
#else
template <class Real>
struct Pair {
  Real numbers[2];

  [[nodiscard]] constexpr Real operator[](int i) const noexcept { return numbers[i]; }
  friend constexpr Pair operator*(Pair a, Real b) noexcept { return {a[0] * b, a[1] * b}; }
  friend constexpr Pair operator+(Pair a, Pair b) noexcept { return {a[0] + b[0], a[1] + b[1]}; }
};
template <class Real>
[[nodiscard]] constexpr Pair<Real> load_pair(const Real* from) noexcept {
  return {from[0], from[1]};
}
#endif

}  // namespace limitcurve::arithmetic
