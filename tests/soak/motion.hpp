// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/godobject.hpp"
#include "tests/soak/random_bits.hpp"

#include <limits>

namespace limitcurve::soak {

/// A finger of random parameters: mostly ones that a finger might have, now and then at the ends of what is accepted.
/// `plain` leaves out what needs a power: the radius does not depend on the load.
inline godobject::FingerParameters any_finger(RandomBits& random, bool plain) {
  godobject::FingerParameters result;
  const bool extreme = random.one_in(8);
  result.mu = extreme ? (random.one_in(4) ? 0.0 : random.scale(-49, 48)) : random.uniform(0.05, 1.5);
  if (random.one_in(3)) result.mu_dynamic = result.mu * (random.one_in(4) ? 1.0 - std::ldexp(1.0, -52) : random.unit());
  if (!plain) {
    result.radius_law = random.one_in(2) ? RadiusLaw::power(0.00207, random.uniform(0.01, 1.0)) : RadiusLaw::hertz(0.008, 2e5);
  } else if (random.one_in(3) && result.mu > 0.0) {
    result.mu_r = extreme ? random.scale(-49, 48) : random.scale(-12, -5);
    if (random.one_in(8)) result.mu_r = 0.0;
  } else {
    result.radius_law = RadiusLaw::constant(extreme ? random.scale(-49, 48) : random.uniform(0.001, 0.02));
  }
  result.stiffness = extreme ? random.scale(-49, 48) : random.scale(4, 14);
  result.twist_stiffness = extreme ? random.scale(-49, 48) : random.scale(-20, 2);
  if (random.one_in(3)) {
    result.damping = random.scale(-10, 4);
    result.twist_damping = random.scale(-24, -6);
  }
  // Most jumps are accepted: jumps are the hard cases.
  result.max_displacement = random.one_in(4) ? random.scale(-12, 0) : std::numeric_limits<double>::infinity();
  if (random.one_in(4)) result.fault_decay = random.unit();
  return result;
}

/// What is handed to one step.
struct Sample {
  godobject::Contact contact;
  double twist = 0.0;
  double time_step = 0.0;
};

/// A finger that wanders over a surface: drifts, trembles, rests, lifts off, falls out of its load, jumps, turns past ±π, and
/// sends NaN.
class Motion {
 public:
  explicit Motion(RandomBits& random) {
    stride_ = random.scale(-40, -7);
    turn_ = random.scale(-40, 1);
    drift_ = random.one_in(2) ? random.uniform(-1.0, 1.0) : 0.0;
    turn_drift_ = random.one_in(2) ? random.uniform(-1.0, 1.0) : 0.0;
    depth_ = random.scale(-14, -6);
    wraps_ = random.one_in(4);
    tilts_ = random.one_in(3);
    faults_ = random.one_in(4) ? 50 : 100000;
    time_step_ = random.one_in(8) ? random.scale(-40, 0) : 0.001;
    if (random.one_in(4)) sample_.contact.point = Eigen::Vector3d::Constant(random.scale(-10, 16));
    if (random.one_in(4)) sample_.contact.normal = Eigen::Vector3d{random.uniform(-1, 1), random.uniform(-1, 1), 1.5}.normalized();
  }

  /// The next sample. About one in eight is the one before it.
  const Sample& next(RandomBits& random) {
    if (faulty_) sample_ = before_fault_;
    faulty_ = random.one_in(faults_);
    if (faulty_) {
      before_fault_ = sample_;
      spoil(random);
      return sample_;
    }
    const int kind = random.below(64);
    if (kind < 8) return sample_;
    godobject::Contact& contact = sample_.contact;
    const double leap = kind == 8 ? 1000.0 : 1.0;
    for (Eigen::Index i = 0; i < 2; ++i) contact.point[i] += leap * stride_ * (random.uniform(-1.0, 1.0) + drift_);
    sample_.twist += leap * turn_ * (random.uniform(-1.0, 1.0) + turn_drift_);
    if (std::fabs(sample_.twist) > 1e5) sample_.twist = 0.0;
    if (wraps_) sample_.twist -= 6.283185307179586 * std::floor(sample_.twist / 6.283185307179586 + 0.5);
    if (contact.point.cwiseAbs().maxCoeff() > 5e5) contact.point.setZero();
    if (tilts_) {
      contact.normal.x() += 0.01 * random.uniform(-1.0, 1.0);
      contact.normal.y() += 0.01 * random.uniform(-1.0, 1.0);
      contact.normal.normalize();
    }
    if (kind < 48) contact.depth = depth_ * random.uniform(0.8, 1.2);
    if (kind == 61) contact.depth = -depth_ * random.unit();
    if (kind == 62) contact.depth = depth_ * std::ldexp(1.0, -random.below(1080));  // nearly out of its load, or wholly
    if (kind == 63) contact.depth = depth_ * std::ldexp(1.0, random.below(8));
    sample_.time_step = random.one_in(16) ? random.scale(-40, 0) : time_step_;
    return sample_;
  }

 private:
  void spoil(RandomBits& random) {
    double* const place[] = {&sample_.contact.point[0],
                             &sample_.contact.point[1],
                             &sample_.contact.point[2],
                             &sample_.contact.normal[0],
                             &sample_.contact.depth,
                             &sample_.contact.normal[2],
                             &sample_.twist,
                             &sample_.time_step};
    *place[random.below(8)] = random.any();
  }

  Sample sample_;
  Sample before_fault_;
  double stride_;
  double turn_;
  double drift_;
  double turn_drift_;
  double depth_;
  double time_step_;
  int faults_;
  bool wraps_;
  bool tilts_;
  bool faulty_ = false;
};

}  // namespace limitcurve::soak
