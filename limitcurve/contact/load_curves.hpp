// SPDX-License-Identifier: MIT
#pragma once

#include "../limit_curve.hpp"
#include "contact_friction.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

/// The limit curve in newtons: the unit curve times μP in force and μPa(P) in moment. SI units.
namespace limitcurve {

/// The wrench of a contact under load P that slips about a COR at distance c.
struct LoadPoint {
  double load = 0.0;    ///< P [N]
  double cor = 0.0;     ///< c [m] ∈ [0, ∞]
  double force = 0.0;   ///< F [N]
  double moment = 0.0;  ///< M [N·m]
};

namespace detail {
/// Each throws std::invalid_argument, with the parameter, its value, unit and range.
void check_load(double load);
void check_cor(double cor);
/// Throws unless the limits μP and μPa are finite.
void check_limits(double mu, double load, double radius);
}  // namespace detail

/// Slip twists from pure spin (c = 0) to pure sliding (c = ∞), both ends included, evenly spaced in the slip angle
/// atan2(|v|, a|ω|). The curve's normal then turns by equal steps, so that a polyline through the points looks smooth.
/// `points` ≥ 2, else std::invalid_argument.
std::vector<SlipTwist> slip_twists(std::size_t points);

/// The wrench of a contact that slips about a COR at distance `cor` [m] ∈ [0, ∞] under `load` [N] ≥ 0: F = μP f(c/a), M
/// = μPa m(c/a) with a = a(P). Relative error: the curve's plus 8 ε. Throws std::invalid_argument for an argument out
/// of range.
template <LimitCurve Curve>
LoadPoint load_point(const Curve& curve, const ContactFriction& contact, double load, double cor) {
  detail::check_load(load);
  detail::check_cor(cor);
  const double radius = detail::radius_at(detail::radius_law_of(curve, contact), load);
  const double capacity = contact.mu * load;
  // Without a contact there is nothing to slip against, and c/a may be 0/0.
  if (!(radius > 0.0)) return {load, cor, 0.0, 0.0};
  detail::check_limits(contact.mu, load, radius);
  const UnitWrench unit = curve.wrench(SlipTwist::about_cor(cor / radius));
  return {load, cor, capacity * unit.force, capacity * radius * unit.moment};
}

/// p-curve: points of the limit curve at one load [N] ≥ 0, from pure spin to pure sliding, at `slip_twists(points)`.
/// Throws like `load_point`.
template <LimitCurve Curve>
std::vector<LoadPoint> p_curve(const Curve& curve, const ContactFriction& contact, double load, std::size_t points) {
  detail::check_load(load);
  const double mu = contact.mu;
  const double radius = detail::radius_at(detail::radius_law_of(curve, contact), load);
  detail::check_limits(mu, load, radius);
  std::vector<LoadPoint> result;
  for (const SlipTwist twist : slip_twists(points)) {
    const UnitWrench unit = curve.wrench(twist);
    // At load 0 the radius may be 0, and 0·∞ is NaN.
    const double cor = twist.spin > 0.0 ? radius * twist.cor() : twist.cor();
    result.push_back({load, cor, mu * load * unit.force, mu * load * radius * unit.moment});
  }
  return result;
}

/// c-curve: the wrenches that slip about one COR [m], at the given `loads` [N]. A straight line from the origin if a
/// does not depend on P, else curved (the paper's Figs. 4 and 5 draw straight lines). Throws like `load_point`.
template <LimitCurve Curve>
std::vector<LoadPoint> c_curve(const Curve& curve, const ContactFriction& contact, double cor,
                               std::span<const double> loads) {
  std::vector<LoadPoint> result;
  for (const double load : loads) result.push_back(load_point(curve, contact, load, cor));
  return result;
}

/// Γ(P) = m₀ μ P a(P) [N·m]: the largest friction moment, that of a pure twist. `moment_ratio` is m₀ ≥ 0, `load` P [N]
/// ≥ 0. Throws std::invalid_argument for an argument out of range.
double moment_capacity(double moment_ratio, const RadiusLaw& radius_law, double mu, double load);

}  // namespace limitcurve
