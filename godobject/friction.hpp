// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/projection.hpp"

#include <limits>

namespace limitcurve::godobject {

/// The limit of friction at one load: the unit limit curve grows to μP in force and μPa in moment.
template <class Number>
struct FrictionLimit {
  Number force;   ///< μP [N] ≥ 0
  Number radius;  ///< a [m] > 0
};

/// What friction acts on: the limits at the present load, and the springs between proxy and finger.
template <class Number>
struct FrictionLimits {
  FrictionLimit<Number> at_rest;          ///< with μ_s: what a contact at rest bears
  FrictionLimit<Number> sliding;          ///< with μ_d: what a contact that slips bears, not larger
  Number stiffness_ratio;                 ///< k_l/k_r [1/m²] of the springs
  Number force_rest_share = Number(1);    ///< a contact that slides comes to rest within the smaller of these shares of the sliding
  Number moment_rest_share = Number(1);   ///< limit, ≤ 1; on the box each part within its own
  bool has_torsion = true;                ///< false: Γ = 0, the moment is 0 and the force is limited by itself
  const RadiusLaw* radius_law = nullptr;  ///< a(P), for the c-curve projection where a depends on P
  Number load = Number(0);                ///< P [N], for the same
};

/// The trial wrench: what the springs would exert if the proxy stayed where it is (eq. 7).
template <class Number>
struct FrictionTrial {
  Number force;                        ///< k_l r [N] ≥ 0
  Number moment;                       ///< k_r ρ [N m] ≥ 0
  Number force_rounding = Number(0);   ///< what of it may be rounding of the positions [N]
  Number moment_rounding = Number(0);  ///< likewise [N m]
};

/// What friction remembers of a contact from one step to the next. To begin with a contact is at rest.
template <class Number>
struct FrictionMemory {
  decltype(Number{} < Number{}) slides{};  ///< it has slipped, and not come to rest since: the sliding limit acts. On the box: of the force
  decltype(Number{} < Number{}) turns{};   ///< on the box: the same of the moment
  Number parameter = Number(0);            ///< of the curve at the last slip, where a search begins; 0: none
  Number rate = Number(0);                 ///< how far that moved in the last step
};

/// What friction does to the trial deflection.
template <class Number>
struct FrictionResult {
  decltype(Number{} < Number{}) slips;  ///< in this step
  Number force_ratio;                   ///< r′/r = F/(k_l r) ≤ 1: what the springs keep; 1 where it sticks
  Number moment_ratio;                  ///< ρ′/ρ
  Number cor;                           ///< distance of the slip's centre of rotation [m], ∞ for pure sliding; NaN where it sticks
};

#ifdef __FAST_MATH__
inline namespace fast_math {  // arithmetic.hpp
#endif

/// The trial in units of a limit. Kept so far from overflow that all squares are finite; a limit of almost nothing is divided by as if it
/// were `least`, no trial is told from a larger one beyond `largest`, and no ratio of stiffnesses from a greater one beyond `steepest`.
template <class Real, class Number>
[[nodiscard]] UnitTrial<Number> unit_trial(const CurveView<Real>& curve, const FrictionLimit<Number>& limit,
                                           const FrictionTrial<Number>& trial, Number stiffness_ratio) noexcept {
  using namespace arithmetic;
  constexpr bool wide = std::numeric_limits<Real>::max_exponent > 256;
  constexpr Real least = wide ? Real(1e-125) : Real(1e-18);
  constexpr Real largest = wide ? Real(1e60) : Real(1e8);
  constexpr Real steepest = wide ? Real(1e40) : Real(1e9);
  const Number per_force = Number(Real(1)) / larger(Number(least), limit.force);
  const Number per_moment = Number(Real(1)) / larger(Number(least), limit.force * limit.radius);
  const Number rounding = trial.force_rounding * per_force * Number(curve.inverse_force_max) +
                          trial.moment_rounding * per_moment * Number(curve.inverse_moment_max);
  // Not more than the limit itself: with no friction at all a contact slips.
  return {smaller(trial.force * per_force, Number(largest)), smaller(trial.moment * per_moment, Number(largest)),
          smaller(larger(limit.radius * limit.radius * stiffness_ratio, Number(Real(1) / steepest)), Number(steepest)),
          Number(slip_onset<Real>) + smaller(rounding, Number(Real(1)))};
}

/// Brings the trial on to the limit by the chosen projection.
template <class Real, class Number>
[[nodiscard]] Projected<Number> project(const CurveView<Real>& curve, Projection projection, const FrictionLimits<Number>& limits,
                                        const UnitTrial<Number>& trial, Number last) noexcept {
  if (!limits.has_torsion) {
    // The force is limited by itself, and the proxy turns with the finger.
    const Number zero = Number(Real(0));
    const Number limit = Number(curve.force_max);
    return {trial.force > limit * trial.slip_from, limit / trial.force, zero, Number(Real(1)), zero, zero};
  }
  if (projection == Projection::closest_point) return project_on_to_closest_point(curve, trial, last);
  if (projection == Projection::c_curve && limits.radius_law != nullptr)
    return project_along_c_curve(curve, trial, last, *limits.radius_law, limits.load);
  return project_radially(curve, trial, last);
}

/// One of the two tests of the paper's §3.1: of the force (eqs. 8, 10, 11) or of the moment (eqs. 9, 10, 12). Which part of its trial the spring
/// keeps: less than 1 where it slips. `slides` is the test's own memory.
template <class Real, class Number, class Mask>
[[nodiscard]] Number apply_scalar_friction(Number at_rest, Number sliding, Number rest_share, Number trial, Number rounding,
                                           Mask& slides) noexcept {
  using namespace arithmetic;
  const Number one = Number(Real(1));
  const Number limit = select(slides, sliding, at_rest);
  const auto slips = trial > limit * Number(slip_onset<Real>) + smaller(rounding, limit);
  const auto lingers = slides && rest_share < one && !(trial < rest_share * sliding);
  slides = slips || lingers;
  return select(slips, sliding / trial, one);
}

/// The paper's §3.1, the box: force and moment each on its own, "they do not influence each other in any way". The closest point of the box,
/// whatever the metric.
template <class Real, class Number>
[[nodiscard]] FrictionResult<Number> apply_uncoupled_friction(const CurveView<Real>& box, const FrictionLimits<Number>& limits,
                                                              const FrictionTrial<Number>& trial, FrictionMemory<Number>& memory) noexcept {
  using namespace arithmetic;
  const Number zero = Number(Real(0));
  const Number one = Number(Real(1));
  const FrictionLimit<Number>& at_rest = limits.at_rest;
  const FrictionLimit<Number>& sliding = limits.sliding;
  FrictionResult<Number> result;
  result.force_ratio = apply_scalar_friction<Real>(at_rest.force * Number(box.force_max), sliding.force * Number(box.force_max),
                                                   limits.force_rest_share, trial.force, trial.force_rounding, memory.slides);
  result.slips = result.force_ratio < one;
  Number turned = zero;
  result.moment_ratio = zero;
  if (limits.has_torsion) {
    result.moment_ratio = apply_scalar_friction<Real>(at_rest.force * at_rest.radius * Number(box.moment_max),
                                                      sliding.force * sliding.radius * Number(box.moment_max), limits.moment_rest_share,
                                                      trial.moment, trial.moment_rounding, memory.turns);
    result.slips = result.slips || result.moment_ratio < one;
    turned = trial.moment * (one - result.moment_ratio);
  }
  // The slip over the turn: in the springs' units of force and moment they are k_l/k_r times as far apart.
  const Number slid = trial.force * (one - result.force_ratio);
  result.cor = select(result.slips, slid / (turned * limits.stiffness_ratio), Number(std::numeric_limits<Real>::quiet_NaN()));
  return result;
}

/// Step b of the paper (eqs. 8–12, 19–23): what part of the trial deflection the limit curve lets the springs keep.
///
/// The rule of sticking: a contact at rest holds while its trial lies within the limit at rest. Once it slips the sliding limit acts, until it
/// comes to rest: in the first step whose trial lies within its rest share of that. Slip work force·(r − r′) + moment·(ρ − ρ′) is never negative. No
/// allocation, no exception, no NaN from finite input; some 10 ns, at most max_search_steps evaluations of the curve. `Number` is `double`, or
/// a pack of double or float (`Real`) for as many contacts.
template <class Real, class Number>
[[nodiscard]] FrictionResult<Number> apply_friction(const CurveView<Real>& curve, Projection projection,
                                                    const FrictionLimits<Number>& limits, const FrictionTrial<Number>& trial,
                                                    FrictionMemory<Number>& memory) noexcept {
  using namespace arithmetic;
  if (curve.is_box) return apply_uncoupled_friction(curve, limits, trial, memory);
  const Number zero = Number(Real(0));
  const Number one = Number(Real(1));
  const auto was_sliding = memory.slides;
  const auto had_parameter = memory.parameter > zero;
  // The centre of rotation seldom jumps: it is looked for where the last slips point to.
  const Number ahead = memory.parameter + memory.rate;
  const Number reach = Number(Real(0.1)) * smaller(memory.parameter, Number(Real(2)) - memory.parameter);
  const Number last = select(abs(memory.rate) <= reach, ahead, memory.parameter);

  FrictionLimit<Number> limit{select(was_sliding, limits.sliding.force, limits.at_rest.force),
                              select(was_sliding, limits.sliding.radius, limits.at_rest.radius)};
  UnitTrial<Number> unit = unit_trial(curve, limit, trial, limits.stiffness_ratio);
  // The chord between the intercepts lies within every limit curve.
  const auto beyond_chord = unit.force * Number(curve.inverse_force_max) + unit.moment * Number(curve.inverse_moment_max) > one;
  Projected<Number> projected{};
  if (any(beyond_chord)) projected = project(curve, projection, limits, unit, last);
  const auto begins = !was_sliding && projected.outside;
  if (any(begins && (limits.sliding.force < limits.at_rest.force || limits.sliding.radius != limits.at_rest.radius))) {
    // From rest into slip: now the sliding limit acts.
    limit = {select(begins, limits.sliding.force, limit.force), select(begins, limits.sliding.radius, limit.radius)};
    unit = unit_trial(curve, limit, trial, limits.stiffness_ratio);
    projected = project(curve, projection, limits, unit, last);
  }

  FrictionResult<Number> result;
  result.slips = projected.outside;
  // Rounding may leave a small component above the trial's; the springs cannot.
  const auto kept = [&](Number ratio, Number trial_wrench) {
    return select(result.slips && trial_wrench > zero, larger(zero, smaller(one, ratio)), one);
  };
  result.force_ratio = kept(projected.force_ratio, trial.force);
  result.moment_ratio = limits.has_torsion ? kept(projected.moment_ratio, trial.moment) : zero;
  const Number nan = Number(std::numeric_limits<Real>::quiet_NaN());
  // Pure sliding is that at any radius, also at a(0) = 0.
  const Number radius = larger(limit.radius, Number((std::numeric_limits<Real>::min)()));
  result.cor = select(result.slips, radius * (projected.slide / projected.spin), nan);
  memory.slides = result.slips;
  const Number rest_share = smaller(limits.force_rest_share, limits.moment_rest_share);
  const auto lingers = was_sliding && !result.slips && rest_share < one;
  if (any(lingers)) memory.slides = memory.slides || (lingers && !(share_of_limit(curve, limits.has_torsion, unit, last) < rest_share));
  memory.rate = select(result.slips, select(had_parameter, projected.parameter - memory.parameter, zero), zero);
  memory.parameter = select(result.slips, projected.parameter, zero);
  return result;
}

#ifdef __FAST_MATH__
}  // namespace fast_math
#endif

}  // namespace limitcurve::godobject
