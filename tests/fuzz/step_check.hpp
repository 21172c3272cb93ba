// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/godobject.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace limitcurve::test {

/// What must hold after every step, and how near the wrench came to the limit.
struct StepCheck {
  std::string_view fault;  ///< what does not hold; empty if all does
  double excess = -1.0;    ///< gauge of the rendered wrench − 1
};

inline constexpr double most_excess = 1.01e-12;  ///< the onset of slip, and rounding of the gauge

inline godobject::FrictionLimits<double> limits_of(const godobject::SoftFinger& finger) {
  const auto moment_max = finger.curve() ? std::optional(finger.curve()->moment_max()) : std::nullopt;
  return godobject::ContactLimits(finger.parameters(), moment_max).at<double>(finger.state().limit_load, 1.0);
}

/// Checks the step that `finger` just made from the state `last`.
inline StepCheck check_step(const godobject::SoftFinger& finger, const godobject::FingerState& last) {
  using Eigen::Vector3d;
  using godobject::ContactState;
  const godobject::FingerOutput output = finger.output();
  const godobject::FingerSample& sample = finger.state().sample;
  const Vector3d last_proxy = last.output.proxy;
  StepCheck result;
  const auto fails = [&](std::string_view what) {
    if (result.fault.empty()) result.fault = what;
  };
  const double sum = output.proxy.sum() + output.force.sum() + output.angle + output.depth + output.load +
                     output.moment + output.slip_work;
  if (!(sum - sum == 0.0)) fails("an output is not finite");
  if (!output.converged) return result;
  if (!(output.slip_work >= 0.0)) fails("negative slip work");
  if (!(output.load >= 0.0)) fails("a load that pulls");
  if (output.state == ContactState::invalid) {
    if (output.proxy != last_proxy || output.angle != last.output.angle) fails("invalid input moves the proxy");
    if (!(output.force.norm() <= last.output.force.norm() && std::fabs(output.moment) <= std::fabs(last.output.moment)))
      fails("invalid input adds friction");
    return result;
  }
  if ((output.cor >= 0.0) != (output.state == ContactState::slip))
    fails("a centre of rotation without slip, or the reverse");
  if (output.state == ContactState::free) {
    if (!output.force.isZero(0.0) || output.moment != 0.0 || output.load != 0.0) fails("friction in free space");
    return result;
  }
  const godobject::FrictionLimits<double> limits = limits_of(finger);
  const bool dampers = finger.parameters().damping > 0.0 || finger.parameters().twist_damping > 0.0;
  const bool rested = last.output.state == ContactState::stick || last.output.state == ContactState::slip;
  if (output.state == ContactState::stick && rested &&
      (output.proxy != last_proxy || (limits.has_torsion && output.angle != last.output.angle)))
    fails("a proxy that sticks moves");
  if (output.state == ContactState::slip && rested && sample.normal == last.sample.normal && !dampers) {
    // The wrench on the finger times the displacement of the proxy along the surface, computed here; up to the rounding
    // of the proxy's position.
    const Vector3d way = last_proxy - output.proxy;
    const Vector3d along = way - sample.normal * sample.normal.dot(way);
    const double work = output.force.dot(along) + output.moment * (last.output.angle - output.angle);
    const double rounding =
        output.force.norm() * (output.proxy.norm() + last_proxy.norm()) +
        std::fabs(output.moment) * (std::fabs(output.angle) + std::fabs(last.output.angle) + std::fabs(sample.angle));
    if (!(work >= -4.0 * std::numeric_limits<double>::epsilon() * rounding - 1e-300)) fails("a slip that gains energy");
  }
  if (!finger.curve()) return result;
  // On the box the force and the moment have a slip state each.
  const bool slips = output.state == ContactState::slip;
  const godobject::FrictionMemory<double>& memory = finger.state().friction;
  const bool is_box = finger.curve()->is_box();
  const godobject::FrictionLimit<double>& limit = slips && memory.force_slides ? limits.sliding : limits.sticking;
  const godobject::FrictionLimit<double>& of_moment =
      slips && (is_box ? memory.moment_slides : memory.force_slides) ? limits.sliding : limits.sticking;
  const double moment_unit = of_moment.force * of_moment.radius;
  // Such a small limit counts as no friction: a trial above 1e60 times its limit is treated as that, and no trial here
  // is above 1e21.
  constexpr double least = 1e-38;
  const double force = output.force.norm();
  const double moment = std::fabs(output.moment);
  if (limits.has_torsion ? limit.force > least && moment_unit > least : limit.force > least) {
    result.excess = (limits.has_torsion ? finger.curve()->gauge({force / limit.force, moment / moment_unit})
                                        : force / (limit.force * finger.curve()->force_max())) -
                    1.0;
    // Also true of NaN.
    if (!(result.excess <= most_excess)) fails("a wrench outside its limit");
  } else if (!(force <= 2.0 * (least + limit.force) && moment <= 2.0 * (least + moment_unit))) {
    fails("a wrench without friction");
  }
  if (!limits.has_torsion && output.moment != 0.0) fails("a moment without torsional friction");
  return result;
}

}  // namespace limitcurve::test
