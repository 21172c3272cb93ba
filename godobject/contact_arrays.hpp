// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_batch.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace limitcurve::godobject {

/// The arrays of a batch, allocated: contacts at the origin, free.
template <class Real>
class BasicContactArrays {
 public:
  /// Throws std::bad_alloc or std::length_error.
  explicit BasicContactArrays(std::size_t count) : count_(count), stride_((count + page - 1) / page * page + shift), states_(count) {
    numbers_.resize(stride_ * arrays);
  }

  [[nodiscard]] std::size_t size() const noexcept { return count_; }

  /// What a step is to be given, to write to: units as in BasicContactBatch.
  [[nodiscard]] std::span<Real> x() noexcept { return array(0); }
  [[nodiscard]] std::span<Real> y() noexcept { return array(1); }
  [[nodiscard]] std::span<Real> angle() noexcept { return array(2); }
  [[nodiscard]] std::span<Real> depth() noexcept { return array(3); }

  /// For `BasicBatch::step`, as long as these arrays live.
  [[nodiscard]] BasicContactBatch<Real> batch() noexcept {
    return {array(0), array(1), array(2), array(3), array(4),  array(5), array(6),
            states_,  array(7), array(8), array(9), array(10), array(11)};
  }

 private:
  static constexpr std::size_t arrays = 12;
  // Arrays whole pages apart would share lines of the cache: each begins a little farther.
  static constexpr std::size_t page = 4096 / sizeof(Real);
  static constexpr std::size_t shift = 320 / sizeof(Real);

  [[nodiscard]] std::span<Real> array(std::size_t i) noexcept { return {numbers_.data() + i * stride_, count_}; }

  std::size_t count_;
  std::size_t stride_;
  std::vector<Real> numbers_;
  std::vector<ContactState> states_;
};

using ContactArrays = BasicContactArrays<double>;
using FloatContactArrays = BasicContactArrays<float>;

}  // namespace limitcurve::godobject
