// SPDX-License-Identifier: MIT
#pragma once

#include "arithmetic.hpp"
#include "limit_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The contact radius as a function of the normal load P, and the limit curve in newtons that follows from it: the unit curve times μP in
/// force and μPa(P) in moment. SI units. Functions that make curves and radius laws throw std::invalid_argument for bad input; call them
/// offline.
namespace limitcurve {

/// A measured contact radius, or a measured limit of the friction moment, at a load.
struct LoadSample {
  double load;   ///< P [N] > 0
  double value;  ///< a [m] or Γ [N·m] > 0
};

/// A radius law: the contact radius a(P) at normal load P. Either a power law a = c·P^γ, which covers the published laws: constant (γ = 0),
/// Hertz a = (3PR/4E*)^{1/3} (γ = 1/3), soft finger c·P^γ (Xydas and Kao 1999, 0 ≤ γ ≤ 1/3); or measured samples with a power law from each
/// sample to the next. Because Γ(P) = m₀ μ P a(P), a measured moment limit gives a radius law, too: `of_moments`, and `of_mu_r` for
/// Γ = μ_r P^(1+γ). Immutable; copies share the samples.
class RadiusLaw {
 public:
  /// a = radius [m] > 0 at every load.
  static RadiusLaw constant(double radius);
  /// Sphere of radius R [m] > 0 and effective modulus E* [Pa] > 0.
  static RadiusLaw hertz(double sphere_radius, double modulus);
  /// a = c P^γ, c [m/N^γ] > 0, γ ∈ [0, 1].
  static RadiusLaw power(double coefficient, double exponent);
  /// Interpolates samples of the radius linearly in log–log; the first and last lines go on beyond the samples. At least two samples, loads
  /// increasing, the exponent between two samples in (−1, 1], so that the moment limit grows with the load.
  static RadiusLaw sampled(std::span<const LoadSample> radii);
  /// Interpolates samples of the moment limit Γ [N·m] the same way: a = Γ/(m₀ μ P).
  static RadiusLaw of_moments(std::span<const LoadSample> moments, double mu, double moment_ratio);
  /// The radius at which Γ(P) = μ_r P^(1+γ) (paper, eq. 2): a = μ_r P^γ/(μ m₀), μ_r [m/N^γ] ≥ 0, γ ∈ [−0.5, 1]. Without friction μ_r must be
  /// 0; for μ_r = 0 the radius is so small that the moment is negligible: limits are continuous in the parameters.
  static RadiusLaw of_mu_r(double mu_r, double gamma, double mu, double moment_ratio);
  /// `constant:a=0.005`, `hertz:R=0.008,E=2e5`, `power:c=0.00207,gamma=0.259`.
  /// Like all factories here it throws `std::invalid_argument`, with the parameter, its value, unit and range.
  static RadiusLaw parse(std::string_view text);

  // Moving copies, which is cheap: what was moved from stays what it was.
  RadiusLaw(const RadiusLaw&) = default;
  RadiusLaw& operator=(const RadiusLaw&) = default;

  /// a(P) [m] at load P [N] ≥ 0; relative error ≤ 4 ε.
  [[nodiscard]] double radius(double load) const noexcept {
    if (is_sampled()) return sampled_radius(load);
    return exponent_ == 0.0 ? coefficient_ : coefficient_ * std::pow(load, exponent_);
  }
  /// a(λP)/a(P) for a load ratio λ > 0. `load` is P; it matters for a sampled law only.
  [[nodiscard]] double growth(double load_ratio, double load = 1.0) const noexcept {
    if (!is_sampled()) return exponent_ == 0.0 ? 1.0 : std::pow(load_ratio, exponent_);
    return radius(load_ratio * load) / radius(load);
  }
  /// The load P [N] for which P·a(P) = `product` [N·m] ≥ 0.
  [[nodiscard]] double load_of_product(double product) const noexcept;
  /// c [m/N^γ] and γ at a load; for a sampled law those between the two samples around the load.
  [[nodiscard]] double coefficient(double load = 1.0) const noexcept;
  [[nodiscard]] double exponent(double load = 1.0) const noexcept;
  [[nodiscard]] bool is_sampled() const noexcept { return stretches_ != nullptr; }
  /// Whether a is a function of the load, as a property of the law: two equal radii do not make it constant.
  [[nodiscard]] bool depends_on_load() const noexcept { return is_sampled() || exponent_ != 0.0; }
  /// The smallest and the largest load [N] of the samples, beyond which a sampled law extrapolates; 0 and infinity for any other law.
  [[nodiscard]] std::pair<double, double> sampled_loads() const noexcept { return sampled_loads_; }

 private:
  struct Stretch;

  RadiusLaw(double coefficient, double exponent) : coefficient_(coefficient), exponent_(exponent) {}

  [[nodiscard]] double sampled_radius(double load) const noexcept;
  [[nodiscard]] const Stretch& stretch_at(double load) const noexcept;

  double coefficient_;
  double exponent_;
  std::pair<double, double> sampled_loads_{0.0, std::numeric_limits<double>::infinity()};
  std::shared_ptr<const std::vector<Stretch>> stretches_;  // of a sampled law; shared by its copies
};

/// The friction of a round contact, as it is known: its coefficient, and its contact radius or its moment coefficient.
struct ContactFriction {
  double mu = 0.0;                           ///< coefficient of friction μ ≥ 0
  std::optional<RadiusLaw> radius_law = {};  ///< contact radius a(P); or
  std::optional<double> mu_r = {};  ///< moment coefficient μ_r [m/N^γ] ≥ 0, as measured: Γ = μ_r P^(1+γ), whatever the radius
  double gamma = 0.0;               ///< γ ∈ [−0.5, 1] of μ_r

  /// a(P): `radius_law`, or `RadiusLaw::of_mu_r` for a curve with the unit moment `moment_ratio` of a pure twist. Throws
  /// std::invalid_argument, with the name, for a number out of range, and unless one of `radius_law` and `mu_r` is given.
  [[nodiscard]] RadiusLaw radius(double moment_ratio) const;
};

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
/// a(P) [m]; 0 without load where the law has no finite radius.
[[nodiscard]] inline double radius_at(const RadiusLaw& law, double load) noexcept {
  const double radius = law.radius(load);
  return load > 0.0 || std::isfinite(radius) ? radius : 0.0;
}
/// The radius law of a contact on this curve.
template <class Curve>
[[nodiscard]] RadiusLaw radius_law_of(const Curve& curve, const ContactFriction& contact) {
  return contact.radius(contact.mu_r ? curve.wrench({0.0, 1.0}).moment : 1.0);
}
}  // namespace detail

/// Slip twists from pure spin (c = 0) to pure sliding (c = ∞), both ends included, evenly spaced in the slip angle atan2(|v|, a|ω|). The
/// curve's normal then turns by equal steps, so that a polyline through the points looks smooth. `points` ≥ 2, else std::invalid_argument.
std::vector<SlipTwist> slip_twists(std::size_t points);

/// The wrench of a contact that slips about a COR at distance `cor` [m] ∈ [0, ∞] under `load` [N] ≥ 0: F = μP f(c/a), M = μPa m(c/a)
/// with a = a(P). Relative error: the curve's plus 8 ε. Throws std::invalid_argument for an argument out of range.
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

/// p-curve: points of the limit curve at one load [N] ≥ 0, from pure spin to pure sliding, at `slip_twists(points)`. Throws like
/// `load_point`.
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

/// c-curve: the wrenches that slip about one COR [m], at the given `loads` [N]. A straight line from the origin if a does not depend on P,
/// else curved (the paper's Figs. 4 and 5 draw straight lines). Throws like `load_point`.
template <LimitCurve Curve>
std::vector<LoadPoint> c_curve(const Curve& curve, const ContactFriction& contact, double cor, std::span<const double> loads) {
  std::vector<LoadPoint> result;
  for (const double load : loads) result.push_back(load_point(curve, contact, load, cor));
  return result;
}

/// Γ(P) = m₀ μ P a(P) [N·m]: the largest friction moment, that of a pure twist. `moment_ratio` is m₀ ≥ 0, `load` P [N] ≥ 0. Throws
/// std::invalid_argument for an argument out of range.
double moment_capacity(double moment_ratio, const RadiusLaw& radius_law, double mu, double load);

namespace detail {
#ifdef LIMITCURVE_COPIES
inline namespace LIMITCURVE_COPIES {  // arithmetic.hpp
#endif
/// `load_to_hold` of a contact whose radius law is known and whose numbers are in range.
///
/// It is the root of ln gauge(F/μP, M/μPa(P)) = 0 in ln P. The slope is −(1 + γω): γ is the exponent of the radius law, ω the fraction of
/// the dissipated power that rotation takes, from the curve's normal. Newton's method inside a bracket: below, the larger of the loads that
/// hold F alone and M alone; above, by convexity, their sum.
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
  if (!radius_law.is_sampled() && radius_law.exponent() == 0.0)
    return curve.gauge({scaled_force, scaled_moment / radius_law.coefficient()});
  const double force_alone = scaled_force / curve.wrench({1.0, 0.0}).force;
  const double moment_alone = radius_law.load_of_product(scaled_moment / curve.wrench({0.0, 1.0}).moment);
  double low = (std::max)(force_alone, moment_alone);
  double high = force_alone + moment_alone;
  if (force == 0.0 || moment == 0.0 || std::isinf(high)) return high;
  // Where the radius falls with the load the sum of the two loads need not hold. A load that bears twice the force alone and twice the
  // moment alone does.
  if (radius_law.is_sampled() || radius_law.exponent() < 0.0)
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

/// The smallest load [N] under which the contact bears a force [N] and a moment [N·m] without slip; their signs do not count. 0 for none of
/// both; ∞ without friction, for a moment without moment coefficient, and where no finite load holds; NaN for NaN. Relative error ≤ 1e-12
/// plus the curve's. Throws like `ContactFriction::radius`. Cost: one call of `gauge` for a constant radius, else 3 to 6 calls of `along`,
/// at most 60.
template <class Curve>
double load_to_hold(const Curve& curve, const ContactFriction& contact, double force, double moment) {
  const RadiusLaw radius_law = detail::radius_law_of(curve, contact);
  if (contact.mu_r == 0.0 && std::fabs(moment) > 0.0 && !std::isnan(force)) return std::numeric_limits<double>::infinity();
  return detail::load_to_hold(curve, radius_law, contact.mu, force, moment);
}

#ifdef LIMITCURVE_COPIES
}  // namespace LIMITCURVE_COPIES
#endif

}  // namespace limitcurve
