// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace limitcurve::godobject::bench {

/// Contacts as arrays of doubles or floats. Their fingers go to and fro, farther than the springs can be drawn, so that all of them
/// slip in every step; and nothing but the step need be in the time, for to and fro is an exchange of arrays.
template <class Real, class Batch>
class Contacts {
 public:
  Contacts(std::size_t count, double depth)
      : x_(count, Real(0.004)),
        y_(count),
        angle_(count),
        angle_back_(count),
        depth_(count, static_cast<Real>(depth)),
        proxy_x_(count),
        proxy_y_(count),
        proxy_angle_(count),
        start_(count, Real(-1)),
        trend_(count),
        force_x_(count),
        force_y_(count),
        moment_(count),
        batch_{x_, y_, angle_, depth_, proxy_x_, proxy_y_, proxy_angle_, start_, trend_, force_x_, force_y_, moment_},
        back_(angle_back_) {
    // Not all alike.
    for (std::size_t i = 0; i < count; ++i) {
      angle_[i] = Real(0.4) + Real(1e-3) * static_cast<Real>(i % 64);
      angle_back_[i] = -angle_[i];
    }
  }
  Contacts(const Contacts&) = delete;
  Contacts& operator=(const Contacts&) = delete;

  [[nodiscard]] const Batch& batch() const { return batch_; }

  void turn_round() {
    std::swap(batch_.x, batch_.y);
    std::swap(batch_.angle, back_);
  }

 private:
  std::vector<Real> x_, y_, angle_, angle_back_, depth_, proxy_x_, proxy_y_, proxy_angle_, start_, trend_, force_x_, force_y_, moment_;
  Batch batch_;
  decltype(Batch::angle) back_;
};

}  // namespace limitcurve::godobject::bench
