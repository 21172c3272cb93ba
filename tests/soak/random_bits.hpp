// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace limitcurve::soak {

/// Random numbers that are the same on every machine: xoshiro256++ (Blackman and Vigna, public domain), seeded by SplitMix64,
/// and draws that need no function of a mathematical library but ldexp, which does not round.
class RandomBits {
 public:
  explicit RandomBits(std::uint64_t seed) {
    for (std::uint64_t& word : state_) {
      seed += 0x9e3779b97f4a7c15U;
      std::uint64_t mixed = (seed ^ (seed >> 30U)) * 0xbf58476d1ce4e5b9U;
      mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
      word = mixed ^ (mixed >> 31U);
    }
  }

  std::uint64_t bits() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t carried = state_[1] << 17U;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= carried;
    state_[3] = std::rotl(state_[3], 45);
    return result;
  }
  /// One of 0 … count − 1.
  int below(int count) { return static_cast<int>((bits() >> 32U) * static_cast<std::uint64_t>(count) >> 32U); }
  bool one_in(int count) { return below(count) == 0; }
  /// Evenly in [0, 1).
  double unit() { return std::ldexp(static_cast<double>(bits() >> 11U), -53); }
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// 2^e·[1, 2), e evenly from `least` to `most`.
  double scale(int least, int most) {
    // One after the other: compilers evaluate arguments in orders of their own.
    const double mantissa = 1.0 + unit();
    return std::ldexp(mantissa, least + below(most - least + 1));
  }
  /// Any bits at all: subnormal, infinite, NaN.
  double any() { return std::bit_cast<double>(bits()); }

 private:
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace limitcurve::soak
