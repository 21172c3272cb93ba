// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/curve_view.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace limitcurve::table {

/// The smallest width of a cell: coefficients of its polynomial stay finite.
template <class Real>
inline constexpr double narrowest_cell = sizeof(Real) == sizeof(float) ? 0x1p-23 : 1e-30;

/// Numbers p and d of a table's buckets (TableView): 2^p buckets in each octave of 1 − x + 2^−d.
struct Buckets {
  int index_bits = 3;
  int octaves = 1;

  static constexpr int least_bits = 3;
  static constexpr int most_bits = 11;

  /// Number of buckets of a side.
  [[nodiscard]] std::size_t per_side() const noexcept;
  /// The x at which bucket i ends, counted from the rim; it begins at edge(i + 1). Exact. Negative beyond x = 0.
  [[nodiscard]] double edge(std::size_t i) const noexcept;
  /// The edges of the buckets of one side, in order from 0 to 1; exact.
  [[nodiscard]] std::vector<double> edges() const;
};

/// What a look-up in so many cells may read.
template <class Real>
[[nodiscard]] std::size_t bytes_of(std::size_t cells, int degree, const Buckets& buckets) noexcept {
  return cells * static_cast<std::size_t>(TableView<Real>::pairs_per_cell(degree)) * 2 * sizeof(Real) +
         2 * buckets.per_side() * sizeof(std::uint16_t);
}

}  // namespace limitcurve::table
