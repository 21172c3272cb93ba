// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace limitcurve::table {

/// The smallest width of a cell: coefficients of its polynomial stay finite.
template <class Real>
inline constexpr double narrowest_cell = sizeof(Real) == sizeof(float) ? 0x1p-23 : 1e-30;

/// Numbers p and d of a table's buckets (TablePieces): 2^p buckets in each octave of min(x, 1 − x) + 2^−d.
struct Buckets {
  int index_bits = 3;
  int octaves = 1;

  static constexpr int least_bits = 3;
  static constexpr int most_bits = 11;

  /// Number of buckets in each of the four runs.
  [[nodiscard]] std::size_t per_run() const noexcept;
  /// Distance of the beginning of bucket i from the run's end of [0, 1]; exact.
  [[nodiscard]] double distance(std::size_t i) const noexcept;
  /// The edges of the buckets of one side, in order from 0 to 1; exact.
  [[nodiscard]] std::vector<double> edges() const;
};

}  // namespace limitcurve::table
