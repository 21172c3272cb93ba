// SPDX-License-Identifier: MIT
#pragma once

#include "../arithmetic.hpp"
#include "contact_friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve {

namespace detail {
#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif
/// `load_to_hold` of a contact whose radius law is known and whose numbers are in range.
///
/// The load is the root of ln gauge(F/μP, M/μPa(P)) = 0 in ln P. The slope is −(1 + γω), where γ is the exponent of the
/// radius law and ω, from the curve's normal, is the fraction of the dissipated power that rotation takes. Newton's
/// method stays inside a bracket, which reaches from the larger of the loads that hold F alone and M alone to, because
/// the curve is convex, their sum.
template <class Curve>
double load_to_hold(const Curve& curve, const RadiusLaw& radius_law, double mu, double force, double moment) {
  constexpr int search_limit = 60;
  constexpr double tolerance = 1e-14;
  force = std::fabs(force);
  moment = std::fabs(moment);
  const double sum = force + moment;
  if (!(sum > 0.0)) return sum;
  if (mu == 0.0 || std::isinf(sum)) return std::numeric_limits<double>::infinity();
  const double scaled_force = force / mu;
  const double scaled_moment = moment / mu;
  if (!radius_law.depends_on_load()) return curve.gauge({scaled_force, scaled_moment / radius_law.radius(1.0)});
  const double force_alone = scaled_force / curve.wrench({1.0, 0.0}).force;
  const double moment_alone = radius_law.load_of_product(scaled_moment / curve.wrench({0.0, 1.0}).moment);
  double low = (std::max)(force_alone, moment_alone);
  double high = force_alone + moment_alone;
  if (force == 0.0 || moment == 0.0 || std::isinf(high)) return high;
  // Where the radius falls with the load the sum of the two loads need not hold. A load that carries twice the force
  // alone and twice the moment alone does.
  if (radius_law.may_fall())
    high = (std::max)(
        high, radius_law.load_of_product(scaled_moment / curve.wrench({0.0, 1.0}).moment * 2.0) + 2.0 * force_alone);
  double load = low;
  for (int i = 0; i < search_limit; ++i) {
    const UnitWrench wrench{scaled_force / load, scaled_moment / (load * radius_law.radius(load))};
    const double gamma = radius_law.exponent(load);
    const auto [on_curve, normal] = curve.along(wrench);
    const double gauge = gauge_from(wrench, on_curve);
    (gauge > 1.0 ? low : high) = load;
    const double slide_power = normal.slide * on_curve.force;
    const double spin_power = normal.spin * on_curve.moment;
    const double fraction = spin_power / (slide_power + spin_power);
    double next = load * std::pow(gauge, 1.0 / (1.0 + gamma * fraction));
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::fabs(next - load);
    load = next;
    if (step <= tolerance * load) break;
  }
  return load;
}
#ifdef LIMITCURVE_COPIES
}
#endif
}  // namespace detail

#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {
#endif

/// How hard you must grip: returns the smallest load [N] under which the contact carries a force [N] and a moment [N·m]
/// without slip. Ignores signs. Returns 0 if both are zero; ∞ if there is no friction, if μ_r is 0 but the moment is
/// not, or if no finite load holds; NaN for NaN. The relative error is at most 1e-12 plus that of the curve; for a
/// measured pressure, add `hold_error`. Cost: one call of `gauge` for a constant radius, else 3 to 6 calls of `along`,
/// at most 60. Throws like `ContactFriction::radius`.
template <class Curve>
double load_to_hold(const Curve& curve, const ContactFriction& contact, double force, double moment) {
  const RadiusLaw radius_law = detail::radius_law_of(curve, contact);
  if (contact.mu_r == 0.0 && std::fabs(moment) > 0.0 && !std::isnan(force))
    return std::numeric_limits<double>::infinity();
  return detail::load_to_hold(curve, radius_law, contact.mu, force, moment);
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

}  // namespace limitcurve
