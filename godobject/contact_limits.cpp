// SPDX-License-Identifier: MIT
#include "godobject/contact_limits.hpp"

#include "godobject/finger/finger_parameter_table.hpp"
#include "limitcurve/contact/load_curves.hpp"
#include "limitcurve/contact/load_to_hold.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve::godobject {

namespace {

/// μ of a contact that slides.
double mu_of_slip(const FingerParameters& parameters) noexcept {
  return std::max(parameters.mu_dynamic.value_or(parameters.mu), min_sliding_fraction * parameters.mu);
}

/// The sliding limit divided by the sticking limit; 1 if that is 0.
double fraction(double sliding, double sticking) {
  return sticking > 0.0 ? sliding / sticking : 1.0;
}

}  // namespace

template <class Real>
void check_projection(const BasicFingerCurve<Real>& curve, Projection projection) {
  if (curve.is_box() && projection != Projection::closest_point)
    throw std::invalid_argument("projection: got " + std::string(to_string(projection)) +
                                ", but a box goes with closest-point only, which clamps force and moment each on its "
                                "own");
}
template void check_projection(const BasicFingerCurve<double>& curve, Projection projection);
template void check_projection(const BasicFingerCurve<float>& curve, Projection projection);

template <std::floating_point Real>
Real radius_at(const RadiusLaw& law, Real load) noexcept {
  return static_cast<Real>(
      std::min(law.radius(static_cast<double>(load)), static_cast<double>(std::numeric_limits<Real>::max())));
}

template double radius_at(const RadiusLaw&, double) noexcept;
template float radius_at(const RadiusLaw&, float) noexcept;

double stick_fraction(double sliding_fraction, double rest_margin) noexcept {
  // A trial within a limit of almost 0 is rounding: a contact without a sliding limit never comes to rest.
  constexpr double rounding = 1e-12;
  if (!(sliding_fraction < 1.0)) return 1.0;
  return sliding_fraction > rounding ? sliding_fraction / (sliding_fraction + rest_margin * (1.0 - sliding_fraction))
                                     : 0.0;
}

std::optional<BadParameter> first_bad(const FingerParameters& parameters, std::optional<double> moment_max) noexcept {
  std::optional<BadParameter> bad;
  const auto require = [&](bool holds, std::string_view name, double value, std::string_view unit,
                           std::string_view range) {
    if (!holds && !bad) bad = {name, value, unit, range};
  };
  for_each_number(parameters, [&](const ParameterInfo& number, std::optional<double> value) {
    if (value) require(number.range.contains(*value), number.name, *value, number.unit, number.range.text);
  });
  if (moment_max) require(spring.contains(*moment_max), "moment_max", *moment_max, "1", spring.text);
  const double mu = parameters.mu;
  const double mu_dynamic = parameters.mu_dynamic.value_or(mu);
  require(mu_dynamic <= mu, "mu_dynamic", mu_dynamic, "1", "0 <= mu_dynamic <= mu");
  const std::optional<double>& of_slip = parameters.mu_r_dynamic;
  if (!parameters.mu_r) {
    require(parameters.gamma == 0.0, "gamma", parameters.gamma, "1", "0 without mu_r");
    if (of_slip) require(false, "mu_r_dynamic", *of_slip, "m", "absent without mu_r");
    const double radius = parameters.radius_law.radius(1.0);
    require(spring.contains(radius), "radius_law coefficient", radius, "m/N^gamma", spring.text);
    return bad;
  }
  const double mu_r = *parameters.mu_r;
  require(moment_max.has_value(), "mu_r", mu_r, "m", "absent with a patch, which has its own moments");
  require(mu > 0.0 || mu_r == 0.0, "mu_r", mu_r, "m", "0 where mu is 0");
  if (of_slip) {
    require(*of_slip <= mu_r, "mu_r_dynamic", *of_slip, "m", "0 <= mu_r_dynamic <= mu_r");
    require(mu_of_slip(parameters) > 0.0 || *of_slip == 0.0, "mu_r_dynamic", *of_slip, "m", "0 where mu_dynamic is 0");
  }
  return bad;
}

ContactLimits::ContactLimits(const FingerParameters& parameters, std::optional<double> moment_max) {
  if (const auto bad = first_bad(parameters, moment_max))
    throw out_of_range(bad->name, bad->value, bad->unit, bad->range);
  const double mu = parameters.mu;
  const double sliding = mu_of_slip(parameters);
  if (parameters.mu_r) {
    const double mu_r = *parameters.mu_r;
    const RadiusLaw radius_law = RadiusLaw::of_mu_r(mu_r, parameters.gamma, mu, *moment_max);
    sticking_ = {mu, radius_law.radius(1.0)};
    // By default both coefficients fall by the same factor, so that the radius stays.
    sliding_ = {sliding, sticking_.radius};
    if (parameters.mu_r_dynamic) {
      sliding_.radius = RadiusLaw::of_mu_r(*parameters.mu_r_dynamic, 0.0, sliding, *moment_max).radius(1.0);
    }
    has_torsion_ = mu_r > 0.0;
    if (parameters.gamma != 0.0) radius_law_ = radius_law;
  } else {
    const double radius = parameters.radius_law.radius(1.0);
    sticking_ = {mu, radius};
    sliding_ = {sliding, radius};
    if (parameters.radius_law.depends_on_load()) radius_law_ = parameters.radius_law;
    has_torsion_ = mu > 0.0;
  }
  sliding_radius_fraction_ = sliding_.radius / sticking_.radius;
  const double moment_fraction =
      has_torsion_ ? fraction(sliding_.force * sliding_.radius, sticking_.force * sticking_.radius) : 1.0;
  force_stick_fraction_ = stick_fraction(fraction(sliding_.force, sticking_.force), parameters.rest_margin);
  moment_stick_fraction_ = stick_fraction(moment_fraction, parameters.rest_margin);
}

double ContactLimits::margin(const FingerCurve& curve, const FingerParameters& parameters,
                             const FingerState& state) const noexcept {
  if (!state.in_contact) return 1.0;
  if (state.output.state == ContactState::slip) return 0.0;
  const FrictionTrial<double> wrench{state.output.force.norm(), std::fabs(state.output.moment)};
  if (wrench.force == 0.0 && wrench.moment == 0.0) return 1.0;
  const FrictionLimits<double> limits = at<double>(state.limit_load, parameters.stiffness / parameters.twist_stiffness);
  const auto acting = [&](bool slides) { return slides ? limits.sliding : limits.sticking; };
  if (curve.is_box() && limits.has_torsion) {
    // Compare force and moment with the limits that act on each.
    const FrictionLimit<double> of_moment = acting(state.friction.moment_slides);
    const double moment_limit = of_moment.force * of_moment.radius * static_cast<double>(curve.view().moment_max);
    const double force_fraction =
        wrench.force > 0.0 ? wrench.force / (acting(state.friction.force_slides).force * curve.force_max()) : 0.0;
    return std::clamp(1.0 - std::max(force_fraction, wrench.moment > 0.0 ? wrench.moment / moment_limit : 0.0), 0.0,
                      1.0);
  }
  const UnitTrial<double> trial =
      unit_trial(curve.view(), acting(state.friction.force_slides), wrench, limits.stiffness_ratio);
  return std::clamp(1.0 - fraction_of_limit(curve.view(), limits.has_torsion, trial, 0.0), 0.0, 1.0);
}

double ContactLimits::load_to_hold(const FingerCurve& curve, double force, double moment) const noexcept {
  constexpr double never = std::numeric_limits<double>::infinity();
  const bool turns = moment > 0.0;
  if ((sticking_.force == 0.0 && force > 0.0) || (!has_torsion_ && turns)) return never;
  if (sticking_.force == 0.0) return 0.0;
  if (radius_law_) return limitcurve::detail::load_to_hold(curve, *radius_law_, sticking_.force, force, moment);
  return curve.gauge({force / sticking_.force, turns ? moment / (sticking_.force * sticking_.radius) : 0.0});
}

}  // namespace limitcurve::godobject
