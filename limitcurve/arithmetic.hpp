// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

// Files that are compiled with -ffast-math have copies of their own of what is built on this, in a namespace `fast_math`: the linker keeps one
// copy of a template for all files, and theirs would do for the library's, too, without NaN, infinity and the order of sums.

/// The arithmetic of one number under the names that packs of numbers use too. Look-ups and friction are templates that are written with
/// these names once, and serve a single finger (`double`) as well as a batch (packs, godobject/kernel).
namespace limitcurve::arithmetic {

/// `yes` where the condition holds, else `no`.
template <class Value>
[[nodiscard]] constexpr Value select(bool condition, Value yes, Value no) noexcept {
  return condition ? yes : no;
}
/// Indices by arithmetic: compilers make a branch of the above, and on which side of the rim a twist lies no predictor knows.
template <std::integral Index>
[[nodiscard]] constexpr Index select(bool condition, Index yes, Index no) noexcept {
  return no + (yes - no) * static_cast<Index>(condition);
}

/// Whether the condition holds in any lane. One number is one lane.
[[nodiscard]] constexpr bool any(bool condition) noexcept {
  return condition;
}

/// The smaller (not `min`, which is a macro of Windows); `a` where `b` is not a number.
template <std::floating_point Real>
[[nodiscard]] constexpr Real smaller(Real a, Real b) noexcept {
  return b < a ? b : a;
}
/// The larger; `a` where `b` is not a number.
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

/// Sign, exponent and leading mantissa bits of a number as an integer: its bits without the last `dropped` ones.
[[nodiscard]] constexpr std::int64_t leading_bits(double a, int dropped) noexcept {
  return std::bit_cast<std::int64_t>(a) >> dropped;
}
[[nodiscard]] constexpr std::int32_t leading_bits(float a, int dropped) noexcept {
  return std::bit_cast<std::int32_t>(a) >> dropped;
}

/// The entry of an array; an entry of small integers comes as an index.
template <std::floating_point Real, std::integral Index>
[[nodiscard]] constexpr Real gather(const Real* array, Index i) noexcept {
  return array[i];
}
template <std::integral Index>
[[nodiscard]] constexpr Index gather(const std::uint16_t* array, Index i) noexcept {
  return static_cast<Index>(array[i]);
}

}  // namespace limitcurve::arithmetic
