// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_batch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// The arrays of a batch, in one piece of memory, where a step is fastest: each begins on a cache line, and at a place of its own within
/// a page. Processors tell loads from earlier stores by the place within 4 KiB first: of arrays that were allocated one after the
/// other a load may wait for the store before it. The results do not depend on it.
template <class Real>
class BasicContactArrays {
 public:
  /// Contacts at the origin, free. Takes the arrays and less than 5 KiB more for each. Throws std::bad_alloc or std::length_error.
  explicit BasicContactArrays(std::size_t count)
      : count_(count),
        lines_apart_((count * sizeof(Real) + page - 1) / page * (page / sizeof(Line)) + apart),
        memory_(arrays * lines_apart_) {
    std::ranges::fill(array(7), Real(-2));
  }

  [[nodiscard]] std::size_t size() const noexcept { return count_; }

  /// What a step is to be given, to write to: units as in BasicContactBatch.
  [[nodiscard]] std::span<Real> x() noexcept { return array(0); }
  [[nodiscard]] std::span<Real> y() noexcept { return array(1); }
  [[nodiscard]] std::span<Real> angle() noexcept { return array(2); }
  [[nodiscard]] std::span<Real> depth() noexcept { return array(3); }

  /// All arrays, in the order of BasicContactBatch.
  [[nodiscard]] std::array<std::span<Real>, 12> spans() noexcept {
    return {array(0), array(1), array(2), array(3), array(4), array(5), array(6), array(7), array(8), array(9), array(10), array(11)};
  }

  /// For `step`, as long as these arrays live.
  [[nodiscard]] BasicContactBatch<Real> batch() noexcept {
    return {array(0), array(1), array(2), array(3), array(4), array(5), array(6), array(7), array(8), array(9), array(10), array(11)};
  }

 private:
  static constexpr std::size_t arrays = 12;
  static constexpr std::size_t page = 4096;
  static constexpr std::size_t apart = 5;  // lines: twelve arrays are spread over a page's 64
  /// Of a cache.
  struct alignas(64) Line {
    std::array<Real, 64 / sizeof(Real)> values{};
  };

  [[nodiscard]] std::span<Real> array(std::size_t i) noexcept {
    return {reinterpret_cast<Real*>(memory_.data() + i * lines_apart_), count_};
  }

  std::size_t count_;
  std::size_t lines_apart_;
  std::vector<Line> memory_;
};

using ContactArrays = BasicContactArrays<double>;
using FloatContactArrays = BasicContactArrays<float>;

}  // namespace limitcurve::godobject
