// SPDX-License-Identifier: MIT
#pragma once

// Internal but for the enumeration Projection: it may change in every version.

#include "../limitcurve/contact/radius_law.hpp"
#include "../limitcurve/curve_view.hpp"

#include <array>
#include <string_view>

namespace limitcurve::godobject {

/// How a trial wrench outside the limit curve is projected on to it.
enum class Projection {
  radial,   ///< eq. (23): force and moment are multiplied by the same factor
  c_curve,  ///< Fig. 5: along the curve of constant centre of rotation to the current load; radial if a does not depend
            ///< on P
  closest_point  ///< maximum dissipation: the slip is normal to the limit curve; on the box the paper's §3.1
};

/// In the order of Projection, in every language.
inline constexpr std::array<std::string_view, 3> projection_names{"radial", "c-curve", "closest-point"};

/// A contact slips if its trial exceeds the limit curve by this factor. A smaller excess may be rounding of the proxy
/// that the last step put on the curve.
template <class Real>
inline constexpr Real slip_onset = Real(1) + Real(1e-12);
template <>
inline constexpr float slip_onset<float> = 1.0F + 0x1p-18F;

/// The trial wrench in units of the limit (eqs. 7, 21): f̂ = k_l r/(μP), m̂ = k_r ρ/(μPa), both ≥ 0.
template <class Number>
struct UnitTrial {
  Number force;
  Number moment;
  Number compliance_ratio;  ///< χ = a² k_l/k_r > 0: a change of m costs χ times the energy of the same change of f
  Number slip_from;         ///< the contact slips if the trial exceeds the limit curve by this factor; ≥ slip_onset
};

/// The trial divided by its limit: 0 for no trial, 1 on the limit. Without torsion only the force is limited.
template <class Real, class Number>
[[nodiscard]] Number fraction_of_limit(const CurveView<Real>& curve, bool has_torsion, const UnitTrial<Number>& trial,
                                       Number last) noexcept {
  return has_torsion ? gauge(curve, trial.force, trial.moment, last) : trial.force * Number(curve.inverse_force_max);
}

/// A trial projected on to the limit curve.
template <class Number>
struct Projected {
  decltype(Number{} < Number{})
      exceeds;             ///< the trial exceeds the curve by more than the factor slip_from; if not, ignore the rest
  Number force_fraction;   ///< f/f̂; any number if f̂ = 0
  Number moment_fraction;  ///< m/m̂
  Number slide;            ///< the slip's direction |v| : a|ω|, both ≥ 0
  Number spin;
  Number parameter;  ///< curve parameter, a warm start for the next search; 0 for none
};

#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif

/// Radial projection (eq. 23): r′/r = ρ′/ρ. The proxy moves along the trial deflection, not along the curve's normal.
/// `last` is the curve parameter of the last slip, or 0.
template <class Real, class Number>
[[nodiscard]] Projected<Number> project_radially(const CurveView<Real>& curve, const UnitTrial<Number>& trial,
                                                 Number last) noexcept {
  Number gauge_of_trial;
  if (curve.has_table()) {
    last = point_on_ray(curve, trial.force, trial.moment, last, gauge_of_trial).parameter;
  } else {
    gauge_of_trial = gauge(curve, trial.force, trial.moment, last);
  }
  const Number ratio = Number(Real(1)) / gauge_of_trial;
  return {!(gauge_of_trial <= trial.slip_from), ratio, ratio, trial.force, trial.compliance_ratio * trial.moment, last};
}

/// Closest point: the point of the curve nearest to the trial in the metric of the springs' compliance, f² + χm². There
/// the slip (f̂ − f, χ(m̂ − m)) is normal to the curve. x is slide : spin inside the rim and spin : slide beyond it
/// (Jet); the leading component is the force inside and the moment beyond, the trailing one the other. o_L is the
/// trial's excess over the leading component at x, o_T that over the trailing one, times χ inside the rim and 1/χ
/// beyond. The residual o_L − x·o_T is zero where the slip is parallel to the normal. It has one root for a trial
/// outside the curve.
template <class Real, class Number>
[[nodiscard]] Projected<Number> project_on_to_closest_point(const CurveView<Real>& curve,
                                                            const UnitTrial<Number>& trial, Number last) noexcept {
  using namespace arithmetic;
  const Number zero = Number(Real(0));
  const Number one = Number(Real(1));
  const Number chi = trial.compliance_ratio;
  const Number inverse_chi = one / chi;
  // First guess: the closest point of the ellipse with the same intercepts, by one Newton step for its multiplier λ =
  // n/d, taken on 1/√(f² + m²), which is nearly straight in λ.
  const auto guess_twist = [&]() noexcept {
    const Number ratio = Number(curve.moment_max * curve.inverse_force_max);
    const Number inverse_ratio = Number(curve.force_max * curve.inverse_moment_max);
    const Number x_trial = trial.force * Number(curve.inverse_force_max);
    const Number y_trial = trial.moment * Number(curve.inverse_moment_max);
    const Number eta = inverse_chi * inverse_ratio * inverse_ratio;
    const Number square = x_trial * x_trial + y_trial * y_trial;
    const Number n = square * larger(sqrt(square) - one, zero);
    const Number d = x_trial * x_trial + eta * (y_trial * y_trial);
    return std::array{x_trial * (d + eta * n) * ratio, y_trial * (d + n)};
  };
  const CurveSide<Real, Number> side(
      trial.force - Number(curve.rim_force) > chi * (trial.moment - Number(curve.rim_moment)), trial.force,
      trial.moment);
  const Number kappa = select(side.outside, inverse_chi, chi);
  Jet<Number> jet;
  const Root<Number> root = find_root<Real>(
      [&](Number at) noexcept -> Residual<Number> {
        jet = curve.jet(side.outside, at);
        const Number over_leading = side.leading - jet.leading;
        const Number over_trailing = kappa * (side.trailing - jet.trailing);
        const Number stiff = one + kappa * at * at;
        // A trial below a point of the curve in both components is inside: stop the search.
        const Number value =
            select(larger(over_leading, over_trailing) > zero, over_leading - at * over_trailing, zero);
        return {value, -jet.second * stiff - over_trailing,
                -jet.third * stiff - Number(Real(3)) * kappa * at * jet.second,
                Number(4 * std::numeric_limits<Real>::epsilon()) * (side.leading + at * kappa * side.trailing)};
      },
      side.begin(last, guess_twist));
  const Number x = root.x + root.step;
  jet = jet.moved(root.x, root.step);
  // The trial is outside the convex curve if and only if it is beyond the tangent at its closest point.
  const CurvePoint<Number> point = side.point(jet, x);
  return {!(side.trailing + x * side.leading <= jet.value(x) * trial.slip_from),
          point.force / trial.force,
          point.moment / trial.moment,
          point.slide,
          point.spin,
          point.parameter};
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

/// c-curve projection (Fig. 5) for a radius that depends on the load. The p-curve through the trial belongs to a load
/// λP and has its COR at c; the result is the point of the p-curve of P with the same c. Root in ln λ of ln gauge(f̂/λ,
/// m̂ a(P)/(λ a(λP))), bracketed; usually 3 or 4 steps. If the pressure is concentrated at the rim, f(s) can grow faster
/// than s; where a(P) grows about like P, the same c would then increase the force: the force stays and the moment
/// slips. Continuous in the trial, except where a(P) falls faster than P^−0.3: there the same c may increase the
/// moment, and c/a is kept instead.
template <class Real>
[[nodiscard]] Projected<Real> project_along_c_curve(const CurveView<Real>& curve, const UnitTrial<Real>& trial,
                                                    Real last, const RadiusLaw& radius_law, Real load) noexcept;

}  // namespace limitcurve::godobject
