// SPDX-License-Identifier: MIT
#include "godobject/projection.hpp"

#include <cmath>
#include <limits>

namespace limitcurve::godobject {

template <class Real>
Projected<Real> project_along_c_curve(const CurveView<Real>& curve, const UnitTrial<Real>& trial, Real last,
                                      const RadiusLaw& radius_law, Real load) noexcept {
  const double gauge_at_load = static_cast<double>(gauge(curve, trial.force, trial.moment, last));
  if (gauge_at_load <= static_cast<double>(trial.slip_from)) return {};
  const auto at = static_cast<double>(load);
  // ln gauge falls by 1 to 2 for each unit of ln λ, which gives a lower bound of the root. There is one root, because
  // P·a(P) grows with P.
  double low = 0.5 * std::log(gauge_at_load);
  double high = std::numeric_limits<double>::infinity();
  double log_load = std::log(gauge_at_load) / (1.0 + radius_law.exponent(at));
  double growth = 1.0;
  CurvePoint<Real> foot{};
  for (int step = 1; step <= max_search_steps; ++step) {
    const double ratio = std::exp(log_load);
    growth = radius_law.growth(ratio, at);
    Real factor{};
    foot = point_on_ray(curve, static_cast<Real>(static_cast<double>(trial.force) / ratio),
                        static_cast<Real>(static_cast<double>(trial.moment) / (ratio * growth)), last, factor);
    last = foot.parameter;
    const double excess = std::log(static_cast<double>(factor));
    (excess > 0.0 ? low : high) = log_load;
    // The slope of ln gauge depends on the fraction of the power that rotation takes.
    const auto slide_power = static_cast<double>(foot.slide * foot.force);
    const auto spin_power = static_cast<double>(foot.spin * foot.moment);
    const double newton =
        excess * (slide_power + spin_power) / (slide_power + (1.0 + radius_law.exponent(ratio * at)) * spin_power);
    if (std::fabs(newton) <= 1e-14) break;
    double next = log_load + newton;
    if (!(next > low && next < high))
      next = high < std::numeric_limits<double>::infinity() ? 0.5 * (low + high) : low + 1.0;
    log_load = next;
  }
  // c = s·a(λP) stays; a(P) is smaller by the factor `growth`. At the ends of the curve c/a is 0 or ∞ for both.
  CurvePoint<Real> result = foot;
  if (foot.slide > Real(0) && foot.spin > Real(0)) {
    const auto s = static_cast<Real>(static_cast<double>(foot.slide / foot.spin) * growth);
    const bool outside = s > Real(1);
    const Real x = outside ? Real(1) / s : s;
    const auto [force, moment] = curve.jet(outside, x).wrench(outside);
    result.force = force;
    result.moment = moment;
  }
  if (result.force > trial.force) {
    // The force stays and the moment alone slips: the closest point where a change of the force costs all, which joins
    // the c-curve without a jump.
    UnitTrial<Real> held = trial;
    held.compliance_ratio = sizeof(Real) == sizeof(double) ? Real(1e-100) : Real(1e-18);
    const Projected<Real> closest = project_on_to_closest_point(curve, held, foot.parameter);
    result = {trial.force, std::fmin(closest.moment_fraction, Real(1)) * trial.moment, Real(0), Real(1),
              foot.parameter};
  }
  if (result.moment > trial.moment) result = foot;
  return {true,
          result.force / trial.force,
          result.moment / trial.moment,
          std::fmax(trial.force - result.force, Real(0)),
          std::fmax(trial.compliance_ratio * (trial.moment - result.moment), Real(0)),
          foot.parameter};
}

template Projected<double> project_along_c_curve(const CurveView<double>&, const UnitTrial<double>&, double,
                                                 const RadiusLaw&, double) noexcept;
template Projected<float> project_along_c_curve(const CurveView<float>&, const UnitTrial<float>&, float,
                                                const RadiusLaw&, float) noexcept;

}  // namespace limitcurve::godobject
