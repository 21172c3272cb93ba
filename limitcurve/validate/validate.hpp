// SPDX-License-Identifier: MIT
#pragma once

#include "../approximations.hpp"
#include "../limit_curve.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

/// Compares a limit curve with an exact one, and finds the best ellipse inside the exact one. For use offline: every
/// function allocates and evaluates the exact curve 1150 to 1500 times, including any fit. That takes 0.1 to 0.6 ms for
/// a closed form and about 0.1 s by quadrature.
namespace limitcurve {

/// Errors of a model over all rays, from axis to axis, of the plane x = f/f_max, y = m/m_max, normalised by the exact
/// curve. Radial errors are ≥ 0 and are fractions of the exact radius on the same ray. The comparison uses 1025 rays,
/// then refines the largest and smallest values between rays to 1e-9; the mean is accurate to 1e-6.
struct CurveError {
  double max_error = 0.0;           ///< the larger of max_over_estimate and max_under_estimate
  double rms_error = 0.0;           ///< root of the mean square over the rays' angle
  double max_over_estimate = 0.0;   ///< largest model radius/exact radius − 1: the model holds, but the finger slips
  double max_under_estimate = 0.0;  ///< largest 1 − model radius/exact radius: the model slips, but the finger holds
  double max_cor_error =
      0.0;  ///< largest |c/c_exact − 1|; inf if only one of the CORs is 0 or inf, or the ratio has no bound
  double min_cor_ratio = 1.0;  ///< smallest c/c_exact, both CORs from the curves' normals on the same ray
  double max_cor_ratio = 1.0;  ///< largest c/c_exact
};

/// The first-order Padé model of multibody mechanics (Zhuravlev, J. Appl. Math. Mech. 62:705, 1998) gives the wrench of
/// a slip twist: f = s/(s + σ_f), m = m₀σ_m/(s + σ_m). `pade_model` makes this model from a curve, exact at the two
/// ends and in the slope of the force at a pure spin and of the moment at a pure slide. In between, it is up to 42 %
/// too weak for Hertz (34 % of μP in f, 39 % of m₀ in m). It is not a LimitCurve, because the slip twist is not the
/// normal, so that it need not obey maximum dissipation.
class PadeModel {
 public:
  /// σ_f, σ_m: the COR distances c/a at which force and moment are half their largest. Positive; not checked.
  PadeModel(double force_cor, double moment_cor, double moment_ratio)
      : force_cor_(force_cor), moment_cor_(moment_cor), moment_ratio_(moment_ratio) {}

  [[nodiscard]] double force_cor() const noexcept { return force_cor_; }
  [[nodiscard]] double moment_cor() const noexcept { return moment_cor_; }
  [[nodiscard]] double moment_ratio() const noexcept { return moment_ratio_; }

  /// The wrench of a slip twist ≥ 0. With force_cor 0 the force of a pure spin is NaN.
  [[nodiscard]] UnitWrench wrench(SlipTwist twist) const noexcept {
    const auto share = [](double part, double other) {
      return part + other > 0.0 ? part / (part + other) : std::numeric_limits<double>::quiet_NaN();
    };
    return {share(twist.slide, force_cor_ * twist.spin), moment_ratio_ * share(moment_cor_ * twist.spin, twist.slide)};
  }

  /// The model's wrench on the ray through `direction` ≥ 0, and, instead of a normal, the slip twist that causes it.
  [[nodiscard]] RadialPoint along(UnitWrench direction) const noexcept {
    // m s² + σ_m(m − m₀f) s − m₀σ_mσ_f f = 0, without cancellation.
    const double half = 0.5 * moment_cor_ * (direction.moment - moment_ratio_ * direction.force);
    const double product = moment_ratio_ * moment_cor_ * force_cor_ * direction.force;
    const double root = std::sqrt(half * half + direction.moment * product);
    const SlipTwist twist = half < 0.0 ? SlipTwist{root - half, direction.moment} : SlipTwist{product, root + half};
    return {wrench(twist), twist};
  }

 private:
  double force_cor_;
  double moment_cor_;
  double moment_ratio_;
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

/// (f_max, m_max) of a curve.
template <LimitCurve Curve>
UnitWrench intercepts_of(const Curve& curve) {
  return {curve.wrench({1.0, 0.0}).force, curve.wrench({0.0, 1.0}).moment};
}

template <LimitCurve Curve>
WrenchOfTwist wrench_of(const Curve& curve) {
  return [&curve](SlipTwist twist) { return curve.wrench(twist); };
}

/// Rate at which a curve's normal turns at its ends: on a ray the COR is about (f/m)/spin near pure spin, and
/// slide/(m/f) near pure sliding.
struct EndTurns {
  double spin;   ///< d(f/m)/ds at s = 0
  double slide;  ///< s·m/f at s = ∞
};

template <LimitCurve Curve>
EndTurns end_turns(const Curve& curve) {
  const SlopedPoint spin = curve.point({0.0, 1.0});
  const SlopedPoint slide = curve.point({1.0, 0.0});
  // A slope that still grows so near to pure spin grows without bound: a pressure that is infinite at the centre
  // (uniform-wear).
  const double slope = std::fabs(spin.slope.force);
  const bool is_infinite = slope > 1.5 * std::fabs(curve.point({1e-100, 1.0}).slope.force);
  return {is_infinite ? std::numeric_limits<double>::infinity() : slope / spin.wrench.moment,
          std::fabs(slide.slope.moment) / slide.wrench.force};
}

/// f ≈ s/σ_f near pure spin, m ≈ m₀σ_m/s near pure sliding.
inline EndTurns end_turns(const PadeModel& model) {
  const double turns = model.force_cor() * model.moment_ratio();
  return {turns > 0.0 ? 1.0 / turns : std::numeric_limits<double>::infinity(),
          model.moment_cor() * model.moment_ratio()};
}

// The normals of a polygon turn at once, or not at all, which no slope shows.
template <std::size_t count>
EndTurns end_turns(const Polygon<count>& polygon) {
  const auto& vertices = polygon.vertices();
  const auto turn = [](double one, double other) {
    return one == other ? std::numeric_limits<double>::infinity() : 0.0;
  };
  return {turn(vertices[count - 2].moment, vertices[count - 1].moment), turn(vertices[0].force, vertices[1].force)};
}

/// `near_spin` and `near_slide` are the limits of the ratio of the CORs at the ends.
CurveError curve_error(const CompareRay& compare, UnitWrench intercepts, double near_spin, double near_slide);
Ellipse inner_ellipse(const WrenchOfTwist& exact, UnitWrench intercepts);

}  // namespace detail

/// The Padé model with the slopes that `exact` has at pure spin and pure sliding; `exact` must have force_max 1. If the
/// force of `exact` rises infinitely steeply from a pure spin (uniform-wear), the result is useless: it has
/// force_cor 0, and infinite errors.
template <LimitCurve Exact>
PadeModel pade_model(const Exact& exact) {
  const double m0 = exact.moment_ratio();
  const auto [spin, slide] = detail::end_turns(exact);
  return {1.0 / (spin * m0), slide / m0, m0};
}

/// Compares `model`, a LimitCurve or a PadeModel, with `exact`, which must be strictly convex (the exact curve, a table
/// or an ellipse, but not a polygon). At pure sliding and pure spin, the ratio of the CORs is taken as its limit, from
/// the slopes of both curves.
template <class Model, LimitCurve Exact>
CurveError curve_error(const Model& model, const Exact& exact) {
  const UnitWrench intercepts = detail::intercepts_of(exact);
  const auto compare = [&](SlipTwist twist) -> detail::RayComparison {
    const UnitWrench wrench = exact.wrench(twist);
    const RadialPoint on_model = model.along(wrench);
    return {std::atan2(wrench.moment / intercepts.moment, wrench.force / intercepts.force),
            gauge_from(on_model.wrench, wrench), on_model.normal.cor() / twist.cor()};
  };
  const auto [exact_spin, exact_slide] = detail::end_turns(exact);
  const auto [model_spin, model_slide] = detail::end_turns(model);
  const double near_spin = exact_spin == model_spin ? 1.0 : exact_spin / model_spin;  // both may be infinite
  return detail::curve_error(compare, intercepts, near_spin, model_slide / exact_slide);
}

/// The minimax ellipse inside the exact curve; both semi-axes are free. It holds only where the
/// exact curve holds. For common laws it is the ellipse through the intercepts, shrunk (Hertz: to
/// 0.940 of both). Semi-axes accurate to 1e-7; it is inside to 1e-12.
template <LimitCurve Exact>
Ellipse inner_ellipse(const Exact& exact) {
  return detail::inner_ellipse(detail::wrench_of(exact), detail::intercepts_of(exact));
}

}  // namespace limitcurve
