// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/float_batch.hpp"
#include "godobject/internal/clones.hpp"

#include <cmath>
#include <cstddef>

// What the loops over floats share. Selections instead of branches, non-short-circuit, and all that is read first: so they are
// vectorised. No operations are fused: the same bits on every machine, in a vector as alone. Restrict counts on parameters only.
namespace limitcurve::godobject::detail {

/// A trial is beyond the limit when it is so by more than this share, some roundings of a float …
inline constexpr float float_slip_guard = 0x1p-20F;
/// … and by more than the proxy's position is rounded by.
inline constexpr float resolution = static_cast<float>(float_resolution);

/// Towards the finger, never past it nor away from it, whatever is rounded.
[[gnu::always_inline]] inline float shrunk(float from, float to, float pull, float share) noexcept {
  const float there = to + pull * share;
  const float low = from < to ? from : to;
  const float high = from < to ? to : from;
  const float not_below = there < low ? low : there;
  return not_below > high ? high : not_below;
}

/// 1 if no input is beyond all bounds, or NaN.
int all_usable(std::size_t count, const float* x, const float* y, const float* angle, const float* depth) noexcept;

/// Hands the contacts to `body` by blocks of a size, without those whose input is not usable.
template <class Body>
void for_each_block(const FloatContactBatch& batch, std::size_t size, Body&& body) noexcept {
  const auto usable = [](const FloatContactBatch& part) {
    return all_usable(part.size(), part.x.data(), part.y.data(), part.angle.data(), part.depth.data()) != 0;
  };
  const std::size_t count = batch.size();
  for (std::size_t from = 0; from < count; from += size) {
    const FloatContactBatch block = batch.part(from, std::min(size, count - from));
    if (usable(block)) {
      body(block);
      continue;
    }
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (usable(block.part(i, 1))) body(block.part(i, 1));
    }
  }
}

}  // namespace limitcurve::godobject::detail
