// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/contact.hpp"
#include "tests/fuzz/any_finger.hpp"

#include <cmath>
#include <cstdint>

namespace limitcurve::fuzz {

/// What is handed to one step.
struct Sample {
  godobject::Contact contact;
  double twist = 0.0;
  double time_step = 0.0;
};

/// The samples that an input stands for: any numbers at all, or a finger that wanders over a surface: drifts, trembles,
/// rests, lifts off, falls out of its load, jumps, turns past ±π, and now and then has any numbers.
class Motion {
 public:
  explicit Motion(Bytes& bytes) : bytes_(bytes), kind_(bytes.take<std::uint8_t>()) {
    if (is_arbitrary()) return;
    stride_ = scale(0.01, 34);
    turn_ = scale(3.0, 42);
    depth_ = scale(0.03, 9);
    if (has(3)) drift_ = fraction();
    if (has(4)) time_step_ = scale(1.0, 41);
    if (has(5)) last_.contact.point.setConstant(scale(1e5, 27));
    if (has(6)) last_.contact.normal = Eigen::Vector3d{fraction(), fraction(), 1.5}.normalized();
  }

  Sample next() {
    const auto kind = bytes_.take<std::uint8_t>();
    if (is_arbitrary() || kind == 255) return arbitrary(is_arbitrary() ? kind : bytes_.take<std::uint8_t>());
    godobject::Contact& contact = last_.contact;
    if (kind % 8 == 0) return last_;
    const double leap = kind == 254 ? 1000.0 : 1.0;
    for (Eigen::Index i = 0; i < 2; ++i) contact.point[i] += leap * stride_ * (fraction() + drift_);
    last_.twist += leap * turn_ * (fraction() + drift_);
    if (std::fabs(last_.twist) > 1e5) last_.twist = 0.0;
    if (has(7)) last_.twist = std::remainder(last_.twist, 6.283185307179586);
    if (contact.point.cwiseAbs().maxCoeff() > 5e5) contact.point.setZero();
    if (has(6)) contact.normal = (contact.normal + 0.01 * Eigen::Vector3d{fraction(), fraction(), 0.0}).normalized();
    if (kind < 192) contact.depth = depth_ * (1.0 + 0.2 * fraction());
    if (kind == 253) contact.depth = -depth_ * std::fabs(fraction());
    if (kind == 252)
      contact.depth = std::ldexp(depth_, -5 * bytes_.take<std::uint8_t>());  // nearly out of its load, or wholly
    if (kind == 251) contact.depth = std::ldexp(depth_, bytes_.take<std::uint8_t>() % 8);
    last_.time_step = kind % 16 == 1 ? scale(1.0, 41) : time_step_;
    return last_;
  }

 private:
  [[nodiscard]] bool has(unsigned bit) const { return ((kind_ >> bit) & 1U) != 0; }
  [[nodiscard]] bool is_arbitrary() const { return kind_ % 8 == 0; }
  /// In [−1, 1).
  double fraction() { return any_double(bytes_, false, 1.0); }
  /// `most`, halved less than `halvings` times.
  double scale(double most, int halvings) { return std::ldexp(most, -(bytes_.take<std::uint8_t>() % halvings)); }

  Sample arbitrary(unsigned flags) {
    const auto raw = [&](unsigned bit) { return ((flags >> bit) & 1U) != 0; };
    Sample result;
    godobject::Contact& contact = result.contact;
    for (Eigen::Index i = 0; i < 2; ++i) contact.point[i] = any_double(bytes_, raw(0), 0.02);
    if (raw(1)) contact.point.z() = any_double(bytes_, raw(0), 0.02);
    contact.depth = any_double(bytes_, raw(2), 0.004);
    if (raw(3)) {
      for (Eigen::Index i = 0; i < 3; ++i) contact.normal[i] = any_double(bytes_, raw(4), 1.0);
      // As handed over, or made a unit normal.
      if (raw(5)) contact.normal.normalize();
    }
    result.twist = any_double(bytes_, raw(6), 4.0);
    if (raw(7)) result.time_step = any_double(bytes_, raw(6), 0.01);
    return result;
  }

  Bytes& bytes_;
  unsigned kind_;
  double stride_ = 0.0;
  double turn_ = 0.0;
  double depth_ = 0.0;
  double drift_ = 0.0;
  double time_step_ = 0.001;
  Sample last_;
};

}  // namespace limitcurve::fuzz
