// SPDX-License-Identifier: MIT
#pragma once

// Notation (docs/theory.md):
//   r, ρ      deflections of the springs if the proxy stayed; r′, ρ′ what friction lets them keep
//   F, M      friction force k_l r′ and moment k_r ρ′; of the trial: k_l r and k_r ρ
//   μP, μPa   what the unit limit curve is multiplied by: FrictionLimit::force, and that times FrictionLimit::radius
//   f̂, m̂     the trial in these units (UnitTrial); f, m: its projection on to the curve (Projected)
//   χ         a² k_l/k_r: what a change of m costs, in changes of f
//   last      curve parameter at which a search starts: 0 to 1 inside the rim, 1 to 2 outside
//   sticking  the limit with μ, of a contact at rest; sliding: the limit with μ_d

#include "projection.hpp"

#include <limits>

namespace limitcurve::godobject {

/// The friction limit at one load: the unit limit curve times μP in force and μPa in moment.
template <class Number>
struct FrictionLimit {
  Number force;   ///< μP [N] ≥ 0
  Number radius;  ///< a [m] ≥ 0
};

/// The limits of a contact at its current load, and the ratio of its springs.
template <class Number>
struct FrictionLimits {
  FrictionLimit<Number> sticking;  ///< with μ: of a contact that sticks
  FrictionLimit<Number> sliding;   ///< with μ_d: while it slides; neither μP nor μPa is larger
  Number stiffness_ratio;          ///< k_l/k_r [1/m²] of the springs
  Number force_stick_fraction =
      Number(1);  ///< a sliding contact comes to rest within the smaller of these two fractions of the
  Number moment_stick_fraction = Number(1);  ///< sliding limit, ≤ 1; on the box force and moment each within its own
  bool has_torsion = true;                   ///< false: Γ = 0, the moment is 0 and only the force is limited
  const RadiusLaw* radius_law = nullptr;     ///< a(P) if a depends on P, for the c-curve projection
  Number load = Number(0);                   ///< P [N], for the c-curve projection
};

/// Whether a radius [m] limits a moment, beside springs of this ratio k_l/k_r [1/m²]: one below rounding only turns
/// with the finger.
[[nodiscard]] constexpr bool has_torsion(double radius, double stiffness_ratio) noexcept {
  return radius * radius * stiffness_ratio > 1e-40;
}

/// The trial wrench: force and moment of springs and dampers if the proxy stayed (eq. 7).
template <class Number>
struct FrictionTrial {
  Number force;                        ///< k_l r [N]; its sign is ignored
  Number moment;                       ///< k_r ρ [N m]; likewise
  Number force_rounding = Number(0);   ///< bound on the rounding error of `force`, from the positions [N]
  Number moment_rounding = Number(0);  ///< bound on the rounding error of `moment` [N m]
};

/// The state of friction between steps. Initially a contact is at rest.
template <class Number>
struct FrictionMemory {
  decltype(Number{} < Number{})
      force_slides{};  ///< the sliding limit acts: it slipped and has not come to rest. On the box: for the force
  decltype(Number{} < Number{}) moment_slides{};  ///< on the box: the same for the moment
  Number search_start = Number(0);  ///< curve parameter of the last slip, the warm start of the search; 0: none
  Number search_rate = Number(0);   ///< its change in the last step
};

/// The result of the friction step: the fraction of the trial deflection that remains.
template <class Number>
struct FrictionResult {
  decltype(Number{} < Number{}) slips;  ///< in this step
  Number force_fraction;                ///< r′/r = F/(k_l r) ≤ 1; 1 if it sticks
  Number moment_fraction;               ///< ρ′/ρ = M/(k_r ρ) ≤ 1; 1 if it sticks
  Number cor;  ///< distance of the slip's centre of rotation [m], ∞ for pure sliding; NaN if it sticks
};

#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif

/// Bounds that keep all squares finite: a smaller limit counts as least_limit, and a trial that is longer in units of
/// the limit is shortened to largest_trial, without a turn.
template <class Real>
inline constexpr Real least_limit = sizeof(Real) == sizeof(double) ? Real(1e-125) : Real(1e-18);
template <class Real>
inline constexpr Real largest_trial = sizeof(Real) == sizeof(double) ? Real(1e60) : Real(1e8);

/// The trial wrench in units of a limit. The ratio of stiffnesses is clamped to [1/steepest, steepest].
template <class Real, class Number>
[[nodiscard]] UnitTrial<Number> unit_trial(const CurveView<Real>& curve, const FrictionLimit<Number>& limit,
                                           const FrictionTrial<Number>& trial, Number stiffness_ratio) noexcept {
  using namespace arithmetic;
  constexpr Real steepest = sizeof(Real) == sizeof(double) ? Real(1e40) : Real(1e9);
  const Number largest = Number(largest_trial<Real>);
  const Number per_force = Number(Real(1)) / larger(Number(least_limit<Real>), limit.force);
  const Number per_moment = Number(Real(1)) / larger(Number(least_limit<Real>), limit.force * limit.radius);
  const Number rounding = trial.force_rounding * per_force * Number(curve.inverse_force_max) +
                          trial.moment_rounding * per_moment * Number(curve.inverse_moment_max);
  // Rounding counts as the limit at most: a contact without friction must slip.
  return {smaller(abs(trial.force) * per_force, largest), smaller(abs(trial.moment) * per_moment, largest),
          smaller(larger(limit.radius * limit.radius * stiffness_ratio, Number(Real(1) / steepest)), Number(steepest)),
          Number(slip_onset<Real>) + smaller(rounding, Number(Real(1)))};
}

/// Where a component reached largest_trial, the whole trial is shortened, so that its direction stays.
template <class Real, class Number>
void keep_direction(UnitTrial<Number>& unit, const FrictionLimit<Number>& limit, const FrictionTrial<Number>& trial,
                    bool has_torsion) noexcept {
  using namespace arithmetic;
  const Number largest = Number(largest_trial<Real>);
  const auto is_long = unit.force >= largest || unit.moment >= largest;
  if (!any(is_long)) [[likely]]
    return;
  const Number most = Number((std::numeric_limits<Real>::max)());
  const auto in_units = [&](Number part, Number of) {
    return smaller(abs(part) / larger(Number(least_limit<Real>), of), most);
  };
  const Number force = in_units(trial.force, limit.force);
  const Number moment = has_torsion ? in_units(trial.moment, limit.force * limit.radius) : Number(Real(0));
  const Number shortened = largest / larger(largest, larger(force, moment));
  unit.force = select(is_long, force * shortened, unit.force);
  unit.moment = select(is_long, moment * shortened, unit.moment);
}

/// Projects the trial on to the limit curve.
template <class Real, class Number>
[[nodiscard]] Projected<Number> project(const CurveView<Real>& curve, Projection projection,
                                        const FrictionLimits<Number>& limits, const UnitTrial<Number>& trial,
                                        Number last) noexcept {
  if (!limits.has_torsion) {
    // Only the force is limited; the proxy turns with the finger.
    const Number zero = Number(Real(0));
    const Number limit = Number(curve.force_max);
    return {!(trial.force <= limit * trial.slip_from), limit / trial.force, zero, Number(Real(1)), zero, zero};
  }
  switch (projection) {
    case Projection::closest_point:
      return project_on_to_closest_point(curve, trial, last);
    case Projection::c_curve:
      if (limits.radius_law != nullptr)
        return project_along_c_curve(curve, trial, last, *limits.radius_law, limits.load);
      break;  // a radius that does not depend on the load: the same as radial
    case Projection::radial:
      break;
  }
  return project_radially(curve, trial, last);
}

/// Whether the sliding limit acts in the next step (hysteresis). After a slip the sliding limit acts until a trial
/// without slip is within `stick_fraction` of that limit; then the contact is at rest. `fraction` must return the trial
/// divided by the sliding limit, and is called only if the answer depends on it.
template <class Mask, class Number, class Fraction>
[[nodiscard]] Mask keeps_sliding(Mask was_sliding, Mask slips, Number stick_fraction, Fraction&& fraction) noexcept {
  using namespace arithmetic;
  const auto may_rest = was_sliding && !slips && stick_fraction < Number(1);
  if (!any(may_rest)) return slips;
  return slips || (may_rest && !(fraction() < stick_fraction));
}

/// The memory after a step in which the proxy slipped: it slid or turned. A slip below the rounding of its position
/// moves nothing and does not begin sliding.
template <class Number, class Mask>
[[nodiscard]] FrictionMemory<Number> settled(const FrictionMemory<Number>& before, FrictionMemory<Number> after,
                                             bool is_box, Mask slips, Mask slid, Mask turned) noexcept {
  using namespace arithmetic;
  const Number none = Number(0);
  after.force_slides = after.force_slides && (before.force_slides || (is_box ? slid : slips));
  after.moment_slides = after.moment_slides && (before.moment_slides || turned);
  after.search_start = select(slips, after.search_start, none);
  after.search_rate = select(slips, after.search_rate, none);
  return after;
}

/// The fraction of a trial that slip leaves: within [0, 1], 1 without slip. By rounding it may exceed 1; a NaN, which
/// finite input does not give, keeps nothing.
template <class Number, class Mask>
[[nodiscard]] Number kept_fraction(Mask slips, Number fraction) noexcept {
  using namespace arithmetic;
  return select(slips, larger(Number(0), smaller(fraction, Number(1))), Number(1));
}

/// One of the two scalar tests of the paper's §3.1: of the force (eqs. 8, 10, 11) or of the moment (eqs. 9, 10, 12).
/// Returns the fraction of the trial that the spring keeps, less than 1 if it slips. `slides` is the state of this
/// test.
template <class Real, class Number, class Mask>
[[nodiscard]] Number apply_scalar_friction(Number sticking, Number sliding, Number stick_fraction, Number trial,
                                           Number rounding, Mask& slides) noexcept {
  using namespace arithmetic;
  const Number limit = select(slides, sliding, sticking);
  const auto slips = !(trial <= limit * Number(slip_onset<Real>) + smaller(rounding, limit));
  slides = keeps_sliding(slides, slips, stick_fraction, [&] { return trial / sliding; });
  return kept_fraction(slips, sliding / trial);
}

/// The box (paper, §3.1): separate limits of force and moment, "they do not influence each other in any way". This is
/// the closest point of the box in every metric of the springs.
template <class Real, class Number>
[[nodiscard]] FrictionResult<Number> apply_uncoupled_friction(const CurveView<Real>& box,
                                                              const FrictionLimits<Number>& limits,
                                                              const FrictionTrial<Number>& trial,
                                                              FrictionMemory<Number>& memory) noexcept {
  using namespace arithmetic;
  const Number zero = Number(Real(0));
  const Number one = Number(Real(1));
  const FrictionLimit<Number>& sticking = limits.sticking;
  const FrictionLimit<Number>& sliding = limits.sliding;
  FrictionResult<Number> result;
  result.force_fraction = apply_scalar_friction<Real>(
      sticking.force * Number(box.force_max), sliding.force * Number(box.force_max), limits.force_stick_fraction,
      abs(trial.force), trial.force_rounding, memory.force_slides);
  result.slips = result.force_fraction < one;
  result.moment_fraction = zero;
  Number turned = abs(trial.moment);
  if (limits.has_torsion) {
    result.moment_fraction = apply_scalar_friction<Real>(sticking.force * sticking.radius * Number(box.moment_max),
                                                         sliding.force * sliding.radius * Number(box.moment_max),
                                                         limits.moment_stick_fraction, abs(trial.moment),
                                                         trial.moment_rounding, memory.moment_slides);
    result.slips = result.slips || result.moment_fraction < one;
    turned = turned * (one - result.moment_fraction);
  }
  const Number slid = abs(trial.force) * (one - result.force_fraction);
  result.cor =
      select(result.slips, slid / (turned * limits.stiffness_ratio), Number(std::numeric_limits<Real>::quiet_NaN()));
  return result;
}

/// Applies friction (step b of the paper, eqs. 8–12, 19–23): the fraction of the trial deflection that the limit curve
/// allows. Updates `memory`.
///
/// Call it in every step of a contact, even without displacement, because otherwise nothing limits the moment of a
/// twist alone. You must keep `memory` (new in each contact), and the deflection and angle, shortened by the fractions.
///
/// A contact at rest holds while the trial is within the sticking limit. After slip begins, the sliding limit acts,
/// until a trial is within the stick fraction of the sliding limit. In that step the contact comes to rest. The slip
/// work force·(r − r′) + moment·(ρ − ρ′) is never negative. The function does not allocate or throw, and finite input
/// gives no NaN. If the input is NaN, no friction remains. Cost: at most max_search_steps evaluations of the curve for
/// each search. `Number` is `double`, or a pack of double or float (`Real`) for as many contacts.
template <class Real, class Number>
[[nodiscard]] FrictionResult<Number> apply_friction(const CurveView<Real>& curve, Projection projection,
                                                    const FrictionLimits<Number>& limits,
                                                    const FrictionTrial<Number>& trial,
                                                    FrictionMemory<Number>& memory) noexcept {
  using namespace arithmetic;
  if (curve.is_box) return apply_uncoupled_friction(curve, limits, trial, memory);
  const Number zero = Number(Real(0));
  const Number one = Number(Real(1));
  const auto was_sliding = memory.force_slides;
  const auto had_parameter = memory.search_start > zero;
  // The centre of rotation seldom jumps: extrapolate the curve parameter for a warm start.
  const Number ahead = memory.search_start + memory.search_rate;
  const Number reach = Number(Real(0.1)) * smaller(memory.search_start, Number(Real(2)) - memory.search_start);
  FrictionLimit<Number> limit{select(was_sliding, limits.sliding.force, limits.sticking.force),
                              select(was_sliding, limits.sliding.radius, limits.sticking.radius)};
  // Below 1e-12 N start cold: if a(P) vanishes with the load, the root does, and from the last slip bisection takes
  // dozens of evaluations to it.
  const Number warm = select(abs(memory.search_rate) <= reach, ahead, memory.search_start);
  const Number last = select(limit.force > Number(Real(1e-12)), warm, zero);
  UnitTrial<Number> unit = unit_trial(curve, limit, trial, limits.stiffness_ratio);
  // Every limit curve is convex, so a trial within the chord between the intercepts sticks.
  const auto beyond_chord =
      !(unit.force * Number(curve.inverse_force_max) + unit.moment * Number(curve.inverse_moment_max) <= one);
  const Number nan = Number(std::numeric_limits<Real>::quiet_NaN());
  const auto fraction_of_unit = [&] { return fraction_of_limit(curve, limits.has_torsion, unit, last); };
  const Number stick_fraction = smaller(limits.force_stick_fraction, limits.moment_stick_fraction);
  if (!any(beyond_chord)) {
    memory = {keeps_sliding(was_sliding, beyond_chord, stick_fraction, fraction_of_unit), memory.moment_slides, zero,
              zero};
    return {beyond_chord, one, limits.has_torsion ? one : zero, nan};
  }
  keep_direction<Real>(unit, limit, trial, limits.has_torsion);
  Projected<Number> projected = project(curve, projection, limits, unit, last);
  const auto begins = !was_sliding && beyond_chord && projected.exceeds;
  if (any(begins &&
          (limits.sliding.force < limits.sticking.force || limits.sliding.radius != limits.sticking.radius))) {
    // Slip begins: project on to the sliding limit.
    limit = {select(begins, limits.sliding.force, limit.force), select(begins, limits.sliding.radius, limit.radius)};
    unit = unit_trial(curve, limit, trial, limits.stiffness_ratio);
    keep_direction<Real>(unit, limit, trial, limits.has_torsion);
    projected = project(curve, projection, limits, unit, last);
  }

  FrictionResult<Number> result;
  result.slips = beyond_chord && projected.exceeds;
  result.force_fraction = kept_fraction(result.slips && !(unit.force <= zero), projected.force_fraction);
  result.moment_fraction =
      limits.has_torsion ? kept_fraction(result.slips && !(unit.moment <= zero), projected.moment_fraction) : zero;
  // a(0) may be 0: keep the COR of pure sliding infinite.
  const Number radius = larger(limit.radius, Number((std::numeric_limits<Real>::min)()));
  Number cor = radius * (projected.slide / projected.spin);
  const Number half = Number(largest_trial<Real> / 2);
  const auto is_far = !(limit.force > Number(least_limit<Real>) && unit.force < half && unit.moment < half);
  // Without a load the springs relax, whatever the projection: the slip is the whole trial deflection.
  if (limits.has_torsion) {
    cor = select(is_far, abs(trial.force) / (abs(trial.moment) * limits.stiffness_ratio), cor);
  } else {  // the proxy turns with the finger
    cor = abs(trial.force) * (one - result.force_fraction) / (abs(trial.moment) * limits.stiffness_ratio);
  }
  if (any(is_far && result.slips)) {
    // The fractions are those of the shortened trial.
    const auto of_trial = [&](Number fraction, Number length, Number whole, Number per) {
      const auto is_shorter = is_far && result.slips && whole > zero;
      return select(is_shorter, kept_fraction(is_shorter, fraction * length / whole * per), fraction);
    };
    result.force_fraction = of_trial(result.force_fraction, unit.force, abs(trial.force), limit.force);
    result.moment_fraction =
        of_trial(result.moment_fraction, unit.moment, abs(trial.moment), limit.force * limit.radius);
  }
  result.cor = select(result.slips, cor, nan);
  memory.force_slides = keeps_sliding(was_sliding, result.slips, stick_fraction, fraction_of_unit);
  memory.search_rate =
      select(result.slips, select(had_parameter, projected.parameter - memory.search_start, zero), zero);
  memory.search_start = select(result.slips, projected.parameter, zero);
  return result;
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

}  // namespace limitcurve::godobject
