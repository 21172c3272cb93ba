// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace limitcurve::table {

/// No cell is narrower: its polynomial's coefficients stay finite.
template <class Real>
inline constexpr double narrowest_cell = sizeof(Real) == sizeof(float) ? 0x1p-23 : 1e-30;

/// p and d of a table's buckets (TablePieces): 2^p an octave, counted in min(x, 1 − x) + 2^−d.
struct Buckets {
  int index_bits = 3;
  int octaves = 1;

  static constexpr int least_bits = 3;
  static constexpr int most_bits = 11;

  /// In each of the four runs.
  [[nodiscard]] std::size_t per_run() const noexcept;
  /// Where bucket i of a run begins, as the distance from its end of [0, 1]; exact.
  [[nodiscard]] double distance(std::size_t i) const noexcept;
  /// The places on a side where one bucket ends and the next begins, in order from 0 to 1; exact.
  [[nodiscard]] std::vector<double> edges() const;
};

}  // namespace limitcurve::table
