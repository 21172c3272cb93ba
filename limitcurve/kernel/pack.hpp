// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/arithmetic.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

/// Packs of numbers, one vector register each, under the names of single numbers (limitcurve/arithmetic.hpp,
/// batch/step.hpp). A template on Number then computes as many results as a pack has lanes, with the same bits. Here by
/// the vector extensions of GCC and Clang, for any width; pack_x86.hpp has overloads for what x86-64 has instructions
/// of its own.
///
/// The instruction set is part of every type's name: sources that are compiled for different processors share no
/// function that the linker could take from the wrong one.
namespace limitcurve::kernel {

/// Instruction sets. The baseline is what every processor has: SSE2 on x86-64, NEON on AArch64.
struct Baseline {
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

/// The result of comparing packs: all bits of a lane, or none.
template <class Real, class Isa>
struct Mask {
  using Numbers = typename Registers<Real, Isa>::Numbers;
  using Bits = typename Registers<Real, Isa>::Integers;
  Bits bits;

  static Mask less(Numbers a, Numbers b) noexcept { return {a < b}; }
  static Mask not_greater(Numbers a, Numbers b) noexcept { return {a <= b}; }
  static Mask different(Numbers a, Numbers b) noexcept { return {a != b}; }
  friend Mask operator&&(Mask a, Mask b) noexcept { return {a.bits & b.bits}; }
  friend Mask operator||(Mask a, Mask b) noexcept { return {a.bits | b.bits}; }
  friend Mask operator!(Mask a) noexcept { return {~a.bits}; }
};

/// Integers, one for each lane.
template <class Real, class Isa>
struct Index {
  using Integers = typename Registers<Real, Isa>::Integers;
  Integers lanes{};

  Index() noexcept = default;
  Index(int all) noexcept
      : lanes(typename Registers<Real, Isa>::Integer{all} - Integers{}) {}  // NOLINT: meant to convert
  explicit Index(Integers of_lanes) noexcept : lanes(of_lanes) {}

  friend Index operator+(Index a, Index b) noexcept { return Index(a.lanes + b.lanes); }
  friend Index operator-(Index a, Index b) noexcept { return Index(a.lanes - b.lanes); }
  friend Index operator*(Index a, Index b) noexcept { return Index(a.lanes * b.lanes); }
};

template <class Real, class Isa>
struct Pack {
  using Numbers = typename Registers<Real, Isa>::Numbers;
  using Truth = Mask<Real, Isa>;
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
  friend Truth operator<(Pack a, Pack b) noexcept { return Truth::less(a.lanes, b.lanes); }
  friend Truth operator>(Pack a, Pack b) noexcept { return Truth::less(b.lanes, a.lanes); }
  friend Truth operator<=(Pack a, Pack b) noexcept { return Truth::not_greater(a.lanes, b.lanes); }
  friend Truth operator>=(Pack a, Pack b) noexcept { return Truth::not_greater(b.lanes, a.lanes); }
  friend Truth operator!=(Pack a, Pack b) noexcept { return Truth::different(a.lanes, b.lanes); }
};

// Not by `?:` of vectors, which compilers split if the processor cannot compare integers of that width.
template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> select(Mask<Real, Isa> condition, Index<Real, Isa> yes, Index<Real, Isa> no) noexcept {
  return Index<Real, Isa>((condition.bits & yes.lanes) | (~condition.bits & no.lanes));
}
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> select(Mask<Real, Isa> condition, Pack<Real, Isa> yes, Pack<Real, Isa> no) noexcept {
  using Bits = Index<Real, Isa>;
  using Integers = typename Bits::Integers;
  return Pack<Real, Isa>(
      (typename Pack<Real, Isa>::Numbers)select(condition, Bits((Integers)yes.lanes), Bits((Integers)no.lanes)).lanes);
}
template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> one_of(const std::array<int, 2>& values, Mask<Real, Isa> condition,
                                      Index<Real, Isa> /*type*/) noexcept {
  return select(condition, Index<Real, Isa>(values[1]), Index<Real, Isa>(values[0]));
}
template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> not_negative(Index<Real, Isa> i) noexcept {
  return Index<Real, Isa>(i.lanes & ~(i.lanes >> (8 * sizeof(Real) - 1)));
}

template <class Real, class Isa>
[[nodiscard]] bool any(Mask<Real, Isa> condition) noexcept {
  const auto words = (typename Registers<double, Isa>::Integers)condition.bits;
  std::int64_t found = 0;
  for (std::size_t i = 0; i < Isa::bytes / 8; ++i) found |= words[i];
  return found != 0;
}

// `a` if one is NaN.
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> smaller(Pack<Real, Isa> a, Pack<Real, Isa> b) noexcept {
  return Pack<Real, Isa>(b.lanes < a.lanes ? b.lanes : a.lanes);
}
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> larger(Pack<Real, Isa> a, Pack<Real, Isa> b) noexcept {
  return Pack<Real, Isa>(b.lanes > a.lanes ? b.lanes : a.lanes);
}
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> abs(Pack<Real, Isa> a) noexcept {
  using Integers = typename Registers<Real, Isa>::Integers;
  const auto sign = (Integers)Pack<Real, Isa>(Real(-0.0)).lanes;
  return Pack<Real, Isa>((typename Pack<Real, Isa>::Numbers)((Integers)a.lanes & ~sign));
}
template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> sqrt(Pack<Real, Isa> a) noexcept {
  // Compilers make one instruction of it.
  for (std::size_t lane = 0; lane < a.size; ++lane) a.lanes[lane] = arithmetic::sqrt(a.lanes[lane]);
  return a;
}

template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> leading_bits(Pack<Real, Isa> a, int dropped) noexcept {
  return Index<Real, Isa>((typename Index<Real, Isa>::Integers)a.lanes >> dropped);
}

template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> gather(const Real* array, Index<Real, Isa> at) noexcept {
  Pack<Real, Isa> result;
  for (std::size_t lane = 0; lane < result.size; ++lane) result.lanes[lane] = array[at.lanes[lane]];
  return result;
}
/// The array must have an even length and the alignment of a 32-bit word, because some processors gather no smaller
/// words.
template <class Real, class Isa>
[[nodiscard]] Index<Real, Isa> gather(const std::uint16_t* array, Index<Real, Isa> at) noexcept {
  for (std::size_t lane = 0; lane < Pack<Real, Isa>::size; ++lane) at.lanes[lane] = array[at.lanes[lane]];
  return at;
}

template <class Real, class Isa>
[[nodiscard]] Pack<Real, Isa> load(const Real* from, Pack<Real, Isa> result) noexcept {
  result.lanes = *reinterpret_cast<const typename Registers<Real, Isa>::Unaligned*>(from);
  return result;
}
template <class Real, class Isa>
void store_where(Mask<Real, Isa> condition, Real* to, Pack<Real, Isa> value) noexcept {
  // In the common case all lanes are written, and none need be read.
  if (any(!condition)) value = select(condition, value, load(to, value));
  *reinterpret_cast<typename Registers<Real, Isa>::Unaligned*>(to) = value.lanes;
}

/// States of lanes: an enumeration of one byte, one for each lane.
template <class Real, class Isa, class State>
[[nodiscard]] Mask<Real, Isa> has_state(const State* states, State wanted, Pack<Real, Isa>) noexcept {
  // Every 32 bits of a pack have the states of four lanes, and compare that of their own.
  constexpr std::size_t lanes = Pack<Real, Isa>::size;
  Index<float, Isa> found;
  Index<float, Isa> expected;
  for (std::size_t begin = 0; begin < lanes; begin += 4) {
    std::int32_t four = 0;
    __builtin_memcpy(&four, states + begin, lanes < 4 ? lanes : 4);
    Index<float, Isa> own;
    for (std::size_t i = 0; i < Isa::bytes / 4; ++i) {
      if (const std::size_t lane = 4 * i / sizeof(Real); lane / 4 == begin / 4) own.lanes[i] = 0xFF << 8 * (lane % 4);
    }
    found.lanes |= Index<float, Isa>(four).lanes & own.lanes;
    expected.lanes |= Index<float, Isa>(0x01010101 * static_cast<int>(wanted)).lanes & own.lanes;
  }
  return {(typename Mask<Real, Isa>::Bits)(found.lanes == expected.lanes)};
}
template <class Real, class Isa, class State>
void store_states(Index<Real, Isa> lanes, State* states) noexcept {
  for (std::size_t lane = 0; lane < Pack<Real, Isa>::size; ++lane) states[lane] = static_cast<State>(lanes.lanes[lane]);
}
/// Where `where` holds: states = !first ? values[0] : !second ? values[1] : values[2].
template <class Real, class Isa, class State>
void set_states_where(Mask<Real, Isa> where, State* states, Mask<Real, Isa> first, Mask<Real, Isa> second,
                      const std::array<State, 3>& values, Pack<Real, Isa>) noexcept {
  using Lanes = Index<Real, Isa>;
  const auto all = [&](std::size_t i) { return Lanes(static_cast<int>(values[i])); };
  Lanes lanes = select(first, select(second, all(2), all(1)), all(0));
  if (any(!where)) {
    Lanes before;
    for (std::size_t lane = 0; lane < Pack<Real, Isa>::size; ++lane)
      before.lanes[lane] = static_cast<int>(states[lane]);
    lanes = select(where, lanes, before);
  }
  store_states(lanes, states);
}

/// A cell of a table for each lane, under the names of that of a single number (limitcurve/curve_view.hpp).
template <class Real, class Isa>
struct LoadedCell {
  Index<Real, Isa> at;
  const Real* array;
  Mask<Real, Isa> outside;

  [[nodiscard]] Pack<Real, Isa> origin() const noexcept { return gather(array, at); }
  [[nodiscard]] Pack<Real, Isa> force(int i) const noexcept { return gather(array + 2 * i + 2, at); }
  [[nodiscard]] Pack<Real, Isa> moment(int i) const noexcept { return gather(array + 2 * i + 3, at); }
  [[nodiscard]] Pack<Real, Isa> leading(int i) const noexcept {
    return gather(array + 2 * i + 2, at + one_of({0, 1}, outside, at));
  }
  [[nodiscard]] Pack<Real, Isa> trailing(int i) const noexcept {
    return gather(array + 2 * i + 2, at + one_of({1, 0}, outside, at));
  }
};
template <class Real, class Isa>
[[nodiscard]] LoadedCell<Real, Isa> load_cell(const Real* array, Index<Real, Isa> at,
                                              Mask<Real, Isa> outside) noexcept {
  return {at, array, outside};
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

}  // namespace limitcurve::kernel
