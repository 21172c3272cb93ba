// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/godobject.hpp"
#include "tests/soak/motion.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <string>

namespace limitcurve::soak {

/// What must hold after every step, and how near the wrench came to the limit.
struct StepCheck {
  std::string fault;     ///< what does not hold; empty if all does
  double excess = 0.0;   ///< gauge of the wrench that the user feels − 1, where it is above, in units of 2⁻⁵²
  bool counted = false;  ///< whether the gauge was taken
  godobject::ContactState state = godobject::ContactState::free;
};

/// How far the boundary reaches along `normal`, which it has at `wrench`.
template <class Boundary>
long double support(const Boundary& boundary, UnitWrench wrench, SlipTwist normal) {
  long double force = wrench.force;
  long double moment = wrench.moment;
  if constexpr (std::same_as<Boundary, ExactCurve>) {
    // By the law's own long double, so that the rounding of what is checked is not in what it is checked against.
    if (const auto exact = boundary.law().closed(static_cast<long double>(normal.cor()))) {
      force = exact->force;
      moment = exact->moment;
    }
  }
  return normal.slide * force + normal.spin * moment;
}

/// The gauge in the limit that may act, less 1, in units of 2⁻⁵²; against the supporting line where the boundary meets the ray of the
/// wrench, in long double, so that a gauge's own rounding does not blur it.
template <class Finger>
double excess_over_limit(const Finger& finger) {
  const godobject::FingerOutput& output = finger.output();
  const godobject::ContactLaw& law = finger.friction().law();
  const auto scale = output.state == godobject::ContactState::slip ? law.dynamic_scale(output.load) : law.static_scale(output.load);
  const long double force_x = output.force.x();
  const long double force_y = output.force.y();
  const long double force_z = output.force.z();
  const long double force = std::sqrt(force_x * force_x + force_y * force_y + force_z * force_z) / scale.force;
  const long double moment = std::fabs(static_cast<long double>(output.moment)) / (static_cast<long double>(scale.force) * scale.radius);
  if (!(force > 0.0L || moment > 0.0L)) return -1.0;
  // Only the direction counts: squares of what is small would vanish.
  const long double larger = std::max(force, moment);
  const auto& boundary = finger.friction().boundary();
  const auto [wrench, normal] = boundary.along({static_cast<double>(force / larger), static_cast<double>(moment / larger)});
  const long double reach = support(boundary, wrench, normal);
  const long double drawn = normal.slide * force + normal.spin * moment;
  return static_cast<double>((drawn - reach) / reach / std::numeric_limits<double>::epsilon());
}

/// Checks the step that `finger` just made on `sample` from the state `last`.
template <class Finger>
StepCheck check_step(const Finger& finger, const godobject::FingerState& last, const Sample& sample) {
  const godobject::FingerOutput& before = last.output;
  using godobject::ContactState;
  const godobject::FingerOutput& output = finger.output();
  StepCheck result;
  result.state = output.state;
  const auto fails = [&](const char* what) {
    if (result.fault.empty()) result.fault = what;
  };
  const double sum = output.proxy.sum() + output.force.sum() + output.angle + output.depth + output.load + output.moment + output.slip_work;
  if (!(sum - sum == 0.0)) fails("an output is not finite");
  if (!(output.slip_work >= 0.0)) fails("negative slip work");
  if (!(output.load >= 0.0)) fails("a load that pulls");
  const double squares = sample.contact.point.squaredNorm() + sample.contact.depth * sample.contact.depth + sample.twist * sample.twist;
  const bool usable = squares <= 1e12 && std::fabs(sample.contact.normal.squaredNorm() - 1.0) <= 1e-6;
  if (!usable && output.state != ContactState::invalid) fails("unusable input is used");
  if (output.state == ContactState::invalid) {
    if (output.proxy != before.proxy || output.angle != before.angle) fails("invalid input moves the proxy");
    if (!(output.force.norm() <= before.force.norm() && std::fabs(output.moment) <= std::fabs(before.moment)))
      fails("invalid input adds friction");
    return result;
  }
  if ((output.cor >= 0.0) != (output.state == ContactState::slip)) fails("a centre of rotation without slip, or the reverse");
  if (output.state == ContactState::free) {
    if (!output.force.isZero(0.0) || output.moment != 0.0 || output.load != 0.0) fails("friction in free space");
    return result;
  }
  const bool dampers = finger.friction().law().damping() > 0.0 || finger.friction().law().twist_damping() > 0.0;
  const bool rested = before.state == ContactState::stick || before.state == ContactState::slip;
  if (output.state == ContactState::stick && rested && output.proxy != before.proxy) fails("a proxy that sticks moves");
  if (output.state == ContactState::slip && rested && sample.contact.normal == last.normal && !dampers) {
    // The wrench on the finger times the way of the proxy along the surface, taken anew; but for the rounding of where the proxy is.
    const Eigen::Vector3d way = before.proxy - output.proxy;
    const Eigen::Vector3d along = way - sample.contact.normal * sample.contact.normal.dot(way);
    const double work = output.force.dot(along) + output.moment * (before.angle - output.angle);
    const double rounding = output.force.norm() * (output.proxy.norm() + before.proxy.norm()) +
                            std::fabs(output.moment) * (std::fabs(output.angle) + std::fabs(before.angle) + std::fabs(sample.twist));
    if (!(work >= -4.0 * std::numeric_limits<double>::epsilon() * rounding - 1e-300)) fails("a slip that gains energy");
  }
  constexpr double least = godobject::ContactLaw::least_unit;
  const auto scale = finger.friction().law().static_scale(output.load);
  if (scale.force <= least && !(output.force.isZero(0.0) && output.moment == 0.0)) fails("a wrench without friction");
  if (scale.force > least && scale.force * scale.radius > least) {
    result.excess = excess_over_limit(finger);
    result.counted = true;
  }
  return result;
}

}  // namespace limitcurve::soak
