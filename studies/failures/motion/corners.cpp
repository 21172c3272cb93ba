// SPDX-License-Identifier: MIT
// Entry "projection": curves with corners.
#include "../failures.hpp"
#include "../random.hpp"
#include "godobject/finger_curve.hpp"
#include "godobject/friction.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace limitcurve::stability {

namespace {

using godobject::FingerCurve;
using Trial = godobject::UnitTrial<double>;

/// A search for smooth curves: finds the twist along which the springs slip to the wrench of that twist.
UnitWrench by_search(const Box& box, const Trial& trial) {
  UnitWrench wrench{};
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 50; ++i) {
    const double u = 0.5 * (low + high);
    wrench = box.wrench(SlipTwist::of_spin_fraction(u));
    const double off = u * (trial.force - wrench.force) - (1.0 - u) * trial.compliance_ratio * (trial.moment - wrench.moment);
    (off > 0.0 ? high : low) = u;
  }
  return wrench;
}

UnitWrench by_us(const Box& box, const Trial& trial) {
  const FingerCurve curve(box);
  godobject::FrictionMemory<double> memory;
  const auto kept = godobject::apply_friction(curve.view(), godobject::Projection::closest_point,
                                              {{1.0, 1.0}, {1.0, 1.0}, trial.compliance_ratio}, {trial.force, trial.moment}, memory);
  return {trial.force * kept.force_fraction, trial.moment * kept.moment_fraction};
}

/// The closest point of the box, by shrinking an interval of each face to two thirds until it is rounding; in long double, because the
/// error is its square root.
UnitWrench by_thirds(const Box& box, const Trial& trial) {
  UnitWrench best{};
  long double least = HUGE_VALL;
  const auto& corners = box.vertices();
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const auto force = [&](long double t) { return corners[i].force + t * (corners[i + 1].force - corners[i].force); };
    const auto moment = [&](long double t) { return corners[i].moment + t * (corners[i + 1].moment - corners[i].moment); };
    const auto distance = [&](long double t) {
      const long double over_force = trial.force - force(t);
      const long double over_moment = trial.moment - moment(t);
      return over_force * over_force + trial.compliance_ratio * over_moment * over_moment;
    };
    long double low = 0.0L;
    long double high = 1.0L;
    for (int j = 0; j < 200; ++j) {
      const long double third = (high - low) / 3.0L;
      if (distance(low + third) < distance(high - third)) {
        high -= third;
      } else {
        low += third;
      }
    }
    if (distance(low) < least) {
      least = distance(low);
      best = {static_cast<double>(force(low)), static_cast<double>(moment(low))};
    }
  }
  return best;
}

struct CornerErrors {
  double distance = 0.0;  // of the wrench from the closest point
  double work = 0.0;      // the least slip work, in units of the limits
};

/// Results of the search and of ours.
std::array<CornerErrors, 2> corner_errors(const Box& box) {
  std::array<CornerErrors, 2> worst;
  const double m0 = box.moment_ratio();
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const double ratio = random.logarithmic(0.1, 10.0);
    const double force = random.uniform(0.0, 3.0);
    const Trial trial{force, random.uniform(0.0, 3.0) * m0, ratio, 1.0};
    if (!(box.gauge({trial.force, trial.moment}) > 1.0 + 1e-6)) continue;
    const UnitWrench truth = by_thirds(box, trial);
    const std::array found{by_search(box, trial), by_us(box, trial)};
    for (std::size_t j = 0; j < found.size(); ++j) {
      // The search by thirds is exact to 1e-8.
      const double distance = std::hypot(found[j].force - truth.force, (found[j].moment - truth.moment) / m0);
      if (distance > 1e-8) worst[j].distance = std::max(worst[j].distance, distance);
      worst[j].work = std::min(
          worst[j].work, found[j].force * (trial.force - found[j].force) + ratio * found[j].moment * (trial.moment - found[j].moment));
    }
  }
  return worst;
}

}  // namespace

Hazard corners() {
  const Box of_hertz = box(1.0, hertz()->moment_ratio());
  const auto [search, ours] = corner_errors(of_hertz);
  const std::string hazard = "corners and faces";
  const std::string method = "search for the wrench with the given normal, box";
  return {{{hazard, method, "distance from the closest point, in the normalised plane", search.distance, ours.distance},
           {hazard, method, "least slip work, in (μP)²/k_l (must be ≥ 0)", search.work, ours.work}},
          {}};
}

}  // namespace limitcurve::stability
