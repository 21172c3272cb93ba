// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace limitcurve::stability {

/// Random numbers that are the same in every run, with every compiler and library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// In [0, 1).
  double share() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * share(); }
  /// Evenly in the logarithm.
  double logarithmic(double low, double high) { return low * std::pow(high / low, share()); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace limitcurve::stability
