// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/approximations.hpp"
#include "limitcurve/limit_curve.hpp"
#include "limitcurve/pressure_law.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// How wrong a limit curve is against another that is taken as exact, the curves of few parameters that are least wrong, and the cheapest that
/// will do. Offline work: it allocates, and costs 1150 to 1500 evaluations of the exact curve a call (0.1 to 0.6 ms for a closed-form law,
/// some 0.1 s by quadrature), fits included.
namespace limitcurve {

/// Errors over all rays of the normalised plane x = f/f_max, y = m/m_max of the exact curve, from axis to axis.
/// Radial errors are relative to the exact radius on the same ray, as fractions, ≥ 0. The extremes are refined between
/// the 1025 rays that are compared: right to 1e-9; the mean to 1e-6.
struct CurveError {
  double max_error = 0.0;           ///< the larger of the two below
  double rms_error = 0.0;           ///< root of the mean square over the rays' angle
  double max_over_estimate = 0.0;   ///< model radius/exact radius − 1 at its largest: holds where the finger slips
  double max_under_estimate = 0.0;  ///< 1 − model radius/exact radius at its largest: slips where the finger holds
  double max_cor_error = 0.0;       ///< |c/c_exact − 1| at its largest; inf where c is 0 or inf alone, or the ratio has no bound
  double min_cor_ratio = 1.0;       ///< c/c_exact at its smallest, both CORs normal to their curve on the same ray
  double max_cor_ratio = 1.0;       ///< … and at its largest
};

namespace detail {

/// The model on the ray through the exact point of one slip twist.
struct RayComparison {
  double angle;         ///< of the ray in the normalised plane
  double radius_ratio;  ///< model radius/exact radius
  double cor_ratio;     ///< c_model/c_exact
};

using CompareRay = std::function<RayComparison(SlipTwist)>;
using WrenchOfTwist = std::function<UnitWrench(SlipTwist)>;
using GaugeOfParameter = std::function<double(UnitWrench wrench, double parameter)>;

/// (f_max, m_max) of a curve.
template <LimitCurve Curve>
UnitWrench intercepts_of(const Curve& curve) {
  return {curve.wrench({1.0, 0.0}).force, curve.wrench({0.0, 1.0}).moment};
}

template <LimitCurve Curve>
WrenchOfTwist wrench_of(const Curve& curve) {
  return [&curve](SlipTwist twist) { return curve.wrench(twist); };
}

/// How a curve turns at its ends: the COR on a ray is about (f/m)/spin near pure spin, and slide/(m/f) near pure sliding.
struct EndTurns {
  double spin;   ///< d(f/m)/ds at s = 0
  double slide;  ///< s·m/f at s = ∞
};

template <LimitCurve Curve>
EndTurns end_turns(const Curve& curve) {
  const SlopedPoint spin = curve.point({0.0, 1.0});
  const SlopedPoint slide = curve.point({1.0, 0.0});
  return {std::fabs(spin.slope.force) / spin.wrench.moment, std::fabs(slide.slope.moment) / slide.wrench.force};
}

// What no slope says: these turn like a power at their ends, or not at all.
inline EndTurns end_turns(const Superellipse& superellipse) {
  if (superellipse.exponent() == 2.0) return end_turns(Ellipse(superellipse.force_max(), superellipse.moment_max()));
  const double turn = superellipse.exponent() > 2.0 ? std::numeric_limits<double>::infinity() : 0.0;
  return {turn, turn};
}
inline EndTurns end_turns(const Quartic& quartic) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return quartic.kappa() > 0.0 ? end_turns<Quartic>(quartic) : EndTurns{inf, inf};
}
template <std::size_t count>
EndTurns end_turns(const Polygon<count>& polygon) {
  const auto& vertices = polygon.vertices();
  const auto turn = [](double one, double other) { return one == other ? std::numeric_limits<double>::infinity() : 0.0; };
  return {turn(vertices[count - 2].moment, vertices[count - 1].moment), turn(vertices[0].force, vertices[1].force)};
}

/// `near_spin` and `near_slide` are the limits of the ratio of the CORs.
CurveError curve_error(const CompareRay& compare, UnitWrench intercepts, double near_spin, double near_slide);
/// The parameter in [low, high] at which over- and under-estimate are equal, of a model whose gauge is monotone in it.
double equal_ripple(const WrenchOfTwist& exact, UnitWrench intercepts, const GaugeOfParameter& gauge, double low, double high);
Ellipse inner_ellipse(const WrenchOfTwist& exact, UnitWrench intercepts);
Ellipse outer_ellipse(const WrenchOfTwist& exact, UnitWrench intercepts);

}  // namespace detail

/// Error of `model` against `exact`, which must be strictly convex (the exact curve, a table, an ellipse; not a polygon).
/// At the ends the ratio of the CORs is its limit, by the slopes of both curves there.
template <LimitCurve Model, LimitCurve Exact>
CurveError curve_error(const Model& model, const Exact& exact) {
  const UnitWrench intercepts = detail::intercepts_of(exact);
  const auto compare = [&](SlipTwist twist) -> detail::RayComparison {
    const UnitWrench wrench = exact.wrench(twist);
    const RadialPoint on_model = model.along(wrench);
    return {std::atan2(wrench.moment / intercepts.moment, wrench.force / intercepts.force), gauge_from(on_model.wrench, wrench),
            on_model.normal.cor() / twist.cor()};
  };
  const auto [exact_spin, exact_slide] = detail::end_turns(exact);
  const auto [model_spin, model_slide] = detail::end_turns(model);
  return detail::curve_error(compare, intercepts, exact_spin / model_spin, model_slide / exact_slide);
}

/// The superellipse through the exact intercepts whose largest radial error is least: there its largest over- and
/// under-estimate are equal. Exponent right to 1e-9, within [1.01, 100].
template <LimitCurve Exact>
Superellipse minimax_superellipse(const Exact& exact) {
  const UnitWrench end = detail::intercepts_of(exact);
  const auto gauge = [&](UnitWrench wrench, double exponent) { return Superellipse(end.force, end.moment, exponent).gauge(wrench); };
  return {end.force, end.moment, detail::equal_ripple(detail::wrench_of(exact), end, gauge, 1.01, 100.0)};
}

/// The quartic through the exact intercepts whose largest radial error is least; κ right to 1e-9.
template <LimitCurve Exact>
Quartic minimax_quartic(const Exact& exact) {
  const UnitWrench end = detail::intercepts_of(exact);
  const auto gauge = [&](UnitWrench wrench, double kappa) { return Quartic(end.force, end.moment, kappa).gauge(wrench); };
  return {end.force, end.moment, detail::equal_ripple(detail::wrench_of(exact), end, gauge, 0.0, 6.0)};
}

/// Of all ellipses (both semi-axes free) inside the exact curve the one of largest area: it never promises a hold
/// that slips. Semi-axes right to 1e-7, inside to 1e-12.
template <LimitCurve Exact>
Ellipse inner_ellipse(const Exact& exact) {
  return detail::inner_ellipse(detail::wrench_of(exact), detail::intercepts_of(exact));
}

/// Of all ellipses (both semi-axes free) that contain the exact curve the one of smallest area: it never calls
/// slipping what holds. Unless the pressure is sharply peaked (xydas-kao:k=0.2) that is the ellipse through the
/// intercepts. Semi-axes right to 1e-7, outside to 1e-12.
template <LimitCurve Exact>
Ellipse outer_ellipse(const Exact& exact) {
  return detail::outer_ellipse(detail::wrench_of(exact), detail::intercepts_of(exact));
}

/// A limit curve that might do, and what it is worth.
struct Candidate {
  std::string model;  ///< diamond, box, ellipse, superellipse, quartic, table, exact
  double parameter;   ///< as `limitcurve validate` prints it; of the table its tolerance; nan of the exact curve
  double
      error;  ///< largest radial error relative to the exact curve, either way; inf of a table that cannot be built to what the tolerance needs
  double nanoseconds;  ///< of a wrench by its slip twist
  bool chosen = false;
  std::string reason = {};  ///< in words: what it is too wrong by, "chosen", or what it costs more than the chosen one
};

/// The cheapest curve for `law` whose error is at most `tolerance`, among those it beat: dearer ones that would also
/// do, cheaper ones that would not. Sorted by cost; one is chosen, since the exact curve always does.
///
/// Costs are shipped figures (shipped_costs.hpp), measured on one machine: read them as ratios. The same input gives the same choice everywhere.
/// Throws std::invalid_argument for a tolerance out of [1e-10, 1]. Cost: a millisecond for a closed form, a second
/// by quadrature. For what a whole scene needs, projection included: godobject/choose_step.hpp.
std::vector<Candidate> choose(const Law& law, double tolerance);

/// Sorts candidates by cost, and chooses the cheapest whose error is at most `tolerance`, or, where none is, that of the least error; gives each
/// its reason.
void choose_cheapest(std::vector<Candidate>& candidates, double tolerance);

/// A fraction as people read it: "6.4 %", "0.9 %", and below 0.01 % as "1e-6".
std::string in_percent(double fraction);

}  // namespace limitcurve
