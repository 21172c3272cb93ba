// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/limit_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The contact radius over the normal load P, and the limit surface that follows from it: the unit curve grows by μP in force and by μPa(P)
/// in moment. All in SI units. Curves and radius laws are made offline: they throw std::invalid_argument for bad input.
namespace limitcurve {

/// A measured contact radius, or a measured limit of the friction moment, at a load.
struct LoadSample {
  double load;   ///< P [N] > 0
  double value;  ///< a [m] or Γ [N·m] > 0
};

/// How the contact radius grows with the load: a(P) = c·P^γ, which holds all published laws:
/// constant (γ = 0), Hertz a = (3PR/4E*)^{1/3} (γ = 1/3), soft finger c·P^γ (Xydas and Kao 1999, 0 ≤ γ ≤ 1/3);
/// or a table, a power law from sample to sample. Since Γ(P) = m₀ μ P a(P), a law of the moment limit is one of the
/// radius: see `of_moments`, and `linear_moment` for Γ = μ_r P. Immutable.
class RadiusLaw {
 public:
  /// a = radius [m] > 0 at every load.
  static RadiusLaw constant(double radius);
  /// Sphere of radius R [m] > 0 and effective modulus E* [Pa] > 0.
  static RadiusLaw hertz(double sphere_radius, double modulus);
  /// a = c P^γ, c [m/N^γ] > 0, γ ∈ [0, 1].
  static RadiusLaw power(double coefficient, double exponent);
  /// Straight lines between the samples (and beyond the outermost ones) in log–log. At least two, loads increasing;
  /// the exponent of every stretch in (−1, 1], so that larger loads bear more moment.
  static RadiusLaw sampled(std::span<const LoadSample> radii);
  /// The radius at which Γ(P) = m₀ μ P a(P) is the sampled moment limit [N·m]; as `sampled`.
  static RadiusLaw of_moments(std::span<const LoadSample> moments, double mu, double moment_ratio);
  /// The constant radius at which Γ(P) = μ_r P (paper, eq. 2): a = μ_r/(μ m₀), μ_r [m] > 0.
  static RadiusLaw linear_moment(double moment_coefficient, double mu, double moment_ratio);
  /// `constant:a=0.005`, `hertz:R=0.008,E=2e5`, `power:c=0.00207,gamma=0.259`.
  /// This and the factories throw `std::invalid_argument` naming parameter, value, unit and range.
  static RadiusLaw parse(std::string_view text);

  /// a(P) [m] at load P [N] ≥ 0; relative error ≤ 4 ε.
  [[nodiscard]] double radius(double load) const noexcept {
    if (is_sampled()) return sampled_radius(load);
    return exponent_ == 0.0 ? coefficient_ : coefficient_ * std::pow(load, exponent_);
  }
  /// a(λP)/a(P). But for a sampled law it does not depend on P.
  [[nodiscard]] double growth(double load_ratio, double load = 1.0) const noexcept {
    if (!is_sampled()) return exponent_ == 0.0 ? 1.0 : std::pow(load_ratio, exponent_);
    return radius(load_ratio * load) / radius(load);
  }
  /// The load [N] at which P·a(P) is `product` [N·m] ≥ 0.
  [[nodiscard]] double load_of_product(double product) const noexcept;
  /// c [m/N^γ] and γ at a load: of a sampled law, those of the stretch that holds it.
  [[nodiscard]] double coefficient(double load = 1.0) const noexcept;
  [[nodiscard]] double exponent(double load = 1.0) const noexcept;
  [[nodiscard]] bool is_sampled() const noexcept { return stretches_ != nullptr; }
  /// The least and the largest load [N] that a sample stands at; beyond them a sampled law is extrapolated. Of any other law 0 and infinity.
  [[nodiscard]] std::pair<double, double> sampled_loads() const noexcept { return sampled_loads_; }

 private:
  struct Stretch;

  RadiusLaw(double coefficient, double exponent) : coefficient_(coefficient), exponent_(exponent) {}

  [[nodiscard]] double sampled_radius(double load) const noexcept;
  [[nodiscard]] const Stretch& stretch_at(double load) const noexcept;

  double coefficient_;
  double exponent_;
  std::pair<double, double> sampled_loads_{0.0, std::numeric_limits<double>::infinity()};
  std::shared_ptr<const std::vector<Stretch>> stretches_;  // of a sampled law; shared, because laws are copied about
};

/// A wrench at which a contact under load P slips about a COR at distance c.
struct LoadPoint {
  double load = 0.0;    ///< P [N]
  double cor = 0.0;     ///< c [m] ∈ [0, ∞]
  double force = 0.0;   ///< F [N]
  double moment = 0.0;  ///< M [N·m]
};

namespace detail {
/// Each throws std::invalid_argument naming the parameter, value, unit and range.
void check_friction(double mu);
void check_load(double load);
void check_cor(double cor);
void check_wrench(double force, double moment);
/// That the contact's limits μP and μPa are finite.
void check_limits(double mu, double load, double radius);
}  // namespace detail

/// Twists from pure spin (c = 0) to pure sliding (c = ∞), both ends included, evenly in the slip angle atan2(|v|, a|ω|):
/// the curve's normal turns by equal steps, so that polylines through the points have no corner. `points` ≥ 2.
std::vector<SlipTwist> slip_twists(std::size_t points);

/// Where a contact of radius a(P) slips when it turns about `cor` [m] ∈ [0, ∞] under `load` [N] ≥ 0, μ ≥ 0:
/// F = μP f(c/a), M = μPa m(c/a). Relative error: the curve's and 8 ε.
template <LimitCurve Curve>
LoadPoint load_point(const Curve& curve, const RadiusLaw& radius_law, double mu, double load, double cor) {
  detail::check_friction(mu);
  detail::check_load(load);
  detail::check_cor(cor);
  const double radius = radius_law.radius(load);
  const double capacity = mu * load;
  // Without a contact there is nothing to slip against, and c/a may be 0/0.
  if (!(radius > 0.0)) return {load, cor, 0.0, 0.0};
  detail::check_limits(mu, load, radius);
  const UnitWrench unit = curve.wrench(SlipTwist::about_cor(cor / radius));
  return {load, cor, capacity * unit.force, capacity * radius * unit.moment};
}

/// p-curve: the limit curve at one load, at `slip_twists(points)`.
template <LimitCurve Curve>
std::vector<LoadPoint> p_curve(const Curve& curve, const RadiusLaw& radius_law, double mu, double load, std::size_t points) {
  detail::check_friction(mu);
  detail::check_load(load);
  const double radius = radius_law.radius(load);
  detail::check_limits(mu, load, radius);
  std::vector<LoadPoint> result;
  for (const SlipTwist twist : slip_twists(points)) {
    const UnitWrench unit = curve.wrench(twist);
    // At load 0 the radius may be 0, and 0·∞ is no place.
    const double cor = twist.spin > 0.0 ? radius * twist.cor() : twist.cor();
    result.push_back({load, cor, mu * load * unit.force, mu * load * radius * unit.moment});
  }
  return result;
}

/// c-curve: the wrench that slips about one COR [m], over the `loads` [N]. A straight line from the origin if a does
/// not depend on P, else bent.
template <LimitCurve Curve>
std::vector<LoadPoint> c_curve(const Curve& curve, const RadiusLaw& radius_law, double mu, double cor, std::span<const double> loads) {
  std::vector<LoadPoint> result;
  for (const double load : loads) result.push_back(load_point(curve, radius_law, mu, load, cor));
  return result;
}

/// Γ(P) = m₀ μ P a(P) [N·m]: the moment that a pure twist needs. `moment_ratio` is m₀ ≥ 0.
double moment_capacity(double moment_ratio, const RadiusLaw& radius_law, double mu, double load);

/// The load [N] at which (F, M) begins to slip: the grip that holds it. F, M ≥ 0; 0 for F = M = 0, ∞ for any other wrench
/// without friction (μ = 0) or beyond every finite load.
///
/// Root of ln gauge(F/μP, M/μPa(P)) = 0, which falls with ln P at the slope −(1 + γω): γ the radius law's exponent, ω the
/// twist's share of the dissipation, told by the normal ahead. Newton in ln P, inside the bracket of the loads that hold
/// F or M alone (below) and their sum (above, by convexity). 3 to 6 calls of `along`, at most 60; for a constant radius
/// one call of `gauge`. A sampled radius law gives its exponent at the load at hand. Relative error ≤ 1e-12, the curve's own apart.
template <class Curve>
double load_to_hold(const Curve& curve, const RadiusLaw& radius_law, double mu, double force, double moment) {
  constexpr int search_limit = 60;
  constexpr double tolerance = 1e-14;
  detail::check_friction(mu);
  detail::check_wrench(force, moment);
  if (force == 0.0 && moment == 0.0) return 0.0;
  if (mu == 0.0) return std::numeric_limits<double>::infinity();
  const double scaled_force = force / mu;
  const double scaled_moment = moment / mu;
  if (!radius_law.is_sampled() && radius_law.exponent() == 0.0)
    return curve.gauge({scaled_force, scaled_moment / radius_law.coefficient()});
  const double force_alone = scaled_force / curve.wrench({1.0, 0.0}).force;
  const double moment_alone = radius_law.load_of_product(scaled_moment / curve.wrench({0.0, 1.0}).moment);
  double low = (std::max)(force_alone, moment_alone);
  double high = force_alone + moment_alone;
  if (force == 0.0 || moment == 0.0 || std::isinf(high)) return high;
  // A sampled radius may fall with the load, where the sum of the two loads need not hold; a load that bears twice the
  // force and twice the moment, each alone, does.
  if (radius_law.is_sampled())
    high = (std::max)(high, radius_law.load_of_product(scaled_moment / curve.wrench({0.0, 1.0}).moment * 2.0) + 2.0 * force_alone);
  double load = low;
  for (int i = 0; i < search_limit; ++i) {
    const UnitWrench wrench{scaled_force / load, scaled_moment / (load * radius_law.radius(load))};
    const double gamma = radius_law.exponent(load);
    const auto [on_curve, normal] = curve.along(wrench);
    const double gauge = gauge_from(wrench, on_curve);
    (gauge > 1.0 ? low : high) = load;
    const double slide_power = normal.slide * on_curve.force;
    const double spin_power = normal.spin * on_curve.moment;
    const double share = spin_power / (slide_power + spin_power);
    double next = load * std::pow(gauge, 1.0 / (1.0 + gamma * share));
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::fabs(next - load);
    load = next;
    if (step <= tolerance * load) break;
  }
  return load;
}

/// Grip to spare [N]: `load` less the load at which (F, M) begins to slip. Negative where it slips.
template <class Curve>
double grip_margin(const Curve& curve, const RadiusLaw& radius_law, double mu, double load, double force, double moment) {
  detail::check_load(load);
  return load - load_to_hold(curve, radius_law, mu, force, moment);
}

}  // namespace limitcurve
