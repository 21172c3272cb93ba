// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace limitcurve {

/// A place in a function that is tabulated piece by piece: which piece, and how far from its middle.
template <class Real>
struct PiecePlace {
  std::size_t piece;
  Real offset;
};

/// Whether there are polynomials for a type's precision; else the closed forms do without.
template <class Real>
inline constexpr bool has_polynomials = std::is_same_v<Real, double> || std::is_same_v<Real, float>;

namespace detail {
template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == sizeof(float), std::uint32_t, std::uint64_t>;

/// A scalar's arithmetic lane by lane, on any target. GCC heeds the attribute on a member type, not on a template's argument.
template <class Real, std::size_t lanes>
struct Lanes {
  typedef Real type __attribute__((vector_size(lanes * sizeof(Real))));
};
template <class Real>
struct Lanes<Real, 1> {
  using type = Real;
};
}  // namespace detail

/// x ∈ [0, 1] among `pieces` of equal width, in units of a piece. Without a branch, and safe for any x: a NaN stays one.
template <unsigned pieces, class Real>
PiecePlace<Real> place_in_equal_pieces(Real x) noexcept {
  static_assert(pieces % 2 == 1, "x = 1 is half way between two integers, of which the even one is taken: the last piece");
  using Bits = detail::BitsOf<Real>;
  // At this size the last bit of a number is 1: the addition rounds to an integer, which its last bits hold.
  constexpr Real units = sizeof(Real) == sizeof(float) ? Real(3U << 22U) : Real(3ULL << 51U);
  const Real from_first = x * Real(pieces) - Real(0.5);
  const Real rounded = from_first + units;
  const Bits found = std::bit_cast<Bits>(rounded) - std::bit_cast<Bits>(units);
  return {static_cast<std::size_t>(std::min<Bits>(found, pieces - 1)), from_first - (rounded - units)};
}

/// x ∈ [2^−octaves, 1] among four pieces an octave, which the leading bits of x name; in units of 1. Without a branch, and safe
/// for any x: a NaN stays one.
template <unsigned octaves, class Real>
PiecePlace<Real> place_in_octaves(Real x) noexcept {
  using Bits = detail::BitsOf<Real>;
  constexpr unsigned quarter_bit = sizeof(Real) == sizeof(float) ? 21 : 50;
  constexpr Bits half = Bits(1) << (quarter_bit - 1);
  constexpr Bits first = std::bit_cast<Bits>(Real(1) / Real(1U << octaves)) >> quarter_bit;
  // 1 itself would begin another octave.
  constexpr Real below_one = 1 - std::numeric_limits<Real>::epsilon() / 2;
  const Bits bits = std::bit_cast<Bits>(x > below_one ? below_one : x);
  const Real middle = std::bit_cast<Real>((bits & ~(2 * half - 1)) | half);
  return {static_cast<std::size_t>(std::min<Bits>((bits >> quarter_bit) - first, 4 * octaves - 1)), x - middle};
}

namespace detail {
/// Σ c_{first+k} x^k, k < count: neighbouring terms are joined, then their pairs and so on (Estrin's scheme).
template <std::size_t first, std::size_t count, std::size_t lanes, class Real, std::size_t steps>
[[gnu::always_inline]] inline typename Lanes<Real, lanes>::type sum_of(const Real* coefficients,
                                                                       const std::array<Real, steps>& powers) noexcept {
  if constexpr (count == 1) {
    typename Lanes<Real, lanes>::type loaded;
    std::memcpy(&loaded, coefficients + first * lanes, sizeof loaded);
    return loaded;
  } else {
    constexpr std::size_t half = std::bit_floor(count - 1);
    return sum_of<first, half, lanes>(coefficients, powers) +
           sum_of<first + half, count - half, lanes>(coefficients, powers) * powers[std::bit_width(half) - 1];
  }
}
}  // namespace detail

/// `lanes` polynomials of `terms` terms at x: their coefficients side by side, lowest power first, so that one instruction serves them
/// all; in an order of operations that lets them overlap.
template <std::size_t terms, std::size_t lanes, class Real>
[[gnu::always_inline]] inline std::array<Real, lanes> polynomial(const Real* coefficients, Real x) noexcept {
  static_assert(lanes <= 2, "wider than every target's vectors");
  std::array<Real, std::bit_width(terms - 1)> powers;  // x, x², x⁴, …
  powers[0] = x;
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * powers[i - 1];
  const auto sum = detail::sum_of<0, terms, lanes>(coefficients, powers);
  static_assert(sizeof sum == lanes * sizeof(Real));
  std::array<Real, lanes> result;
  std::memcpy(result.data(), &sum, sizeof sum);
  return result;
}

/// `lanes` functions, each by a polynomial of `terms` terms on every one of `pieces`.
template <class Real, std::size_t pieces, std::size_t terms, std::size_t lanes>
class PiecewisePolynomials {
 public:
  /// Per piece and power, lowest first, the lanes' coefficients.
  constexpr explicit PiecewisePolynomials(const std::array<double, pieces * terms * lanes>& coefficients) noexcept {
    for (std::size_t i = 0; i < coefficients.size(); ++i) coefficients_[i] = static_cast<Real>(coefficients[i]);
  }

  [[nodiscard, gnu::always_inline]] std::array<Real, lanes> at(PiecePlace<Real> place) const noexcept {
    return polynomial<terms, lanes>(coefficients_.data() + place.piece * (terms * lanes), place.offset);
  }

 private:
  alignas(2 * sizeof(Real)) std::array<Real, pieces * terms * lanes> coefficients_{};
};

}  // namespace limitcurve
