// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact_arrays.hpp"

#include <cstddef>
#include <span>
#include <utility>

namespace limitcurve::godobject::bench {

/// Contacts as arrays of doubles or floats. Their fingers go to and fro, farther than the springs can be drawn, so that all of them
/// slip in every step; and nothing but the step need be in the time, for to and fro is an exchange of arrays.
template <class Real>
class Contacts {
 public:
  Contacts(std::size_t count, double depth) : there_(count), back_(count), batch_(there_.batch()), angle_back_(back_.angle()) {
    for (std::size_t i = 0; i < count; ++i) {
      there_.x()[i] = Real(0.004);
      there_.depth()[i] = static_cast<Real>(depth);
      // Not all alike.
      there_.angle()[i] = Real(0.4) + Real(1e-3) * static_cast<Real>(i % 64);
      back_.angle()[i] = -there_.angle()[i];
    }
  }
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;

  [[nodiscard]] const BasicContactBatch<Real>& batch() const { return batch_; }

  /// Touches down, and slips the first times, which takes twice as long: of the largest batches there is time for few steps.
  template <class Friction>
  void settle(const Friction& friction) {
    constexpr int turns = 12;
    for (int turn = 0; turn < turns; ++turn) {
      turn_round();
      step(friction, batch_);
    }
  }

  void turn_round() {
    std::swap(batch_.x, batch_.y);
    std::swap(batch_.angle, angle_back_);
  }

 private:
  BasicContactArrays<Real> there_;
  BasicContactArrays<Real> back_;  // of which only the angles are used
  BasicContactBatch<Real> batch_;
  std::span<const Real> angle_back_;
};

}  // namespace limitcurve::godobject::bench
