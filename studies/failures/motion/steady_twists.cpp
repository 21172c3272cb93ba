// SPDX-License-Identifier: MIT
// Entry "projection": the steady wrench of a finger that keeps sliding and twisting about one centre of rotation.
#include "../failures.hpp"

#include "../numerics/sampling.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;

/// Distance of two unit wrenches in the normalised plane.
double normalised_distance(UnitWrench one, UnitWrench other, double moment_ratio) {
  return std::hypot(one.force - other.force, (one.moment - other.moment) / moment_ratio);
}

constexpr double stiffness = 1000.0;
constexpr double radius = 0.005;

/// Steady wrench of a finger under a steady twist about a COR at c = a, for κ = k_r/(k_l(m₀a)²).
UnitWrench settled(const FingerCurve& curve, Projection projection, double kappa) {
  const double moment_ratio = hertz()->moment_ratio();
  const double twist_stiffness = kappa * stiffness * moment_ratio * moment_ratio * radius * radius;
  constexpr double force_unit = 0.5;  // μP [N]
  constexpr FrictionLimit<double> limit{force_unit, radius};
  const FrictionLimits<double> limits{limit, limit, stiffness / twist_stiffness};
  // A step is a quarter of the longer of the two decay lengths of the springs.
  const double step = 0.25 * std::max(force_unit / stiffness, force_unit * moment_ratio * radius * radius / twist_stiffness);
  FrictionMemory<double> memory;
  double r = 0.0;
  double rho = 0.0;
  for (int i = 0; i < 400; ++i) {
    r += step;
    rho += step / radius;
    const auto kept = apply_friction(curve.view(), projection, limits, {stiffness * r, twist_stiffness * rho}, memory);
    r *= kept.force_fraction;
    rho *= kept.moment_fraction;
  }
  return {stiffness * r / force_unit, twist_stiffness * rho / (force_unit * radius)};
}

/// A finger under a load of 1 N, μ = 0.6, that turns about a centre of rotation at `cor` [m].
struct SteadyTwist {
  RadiusLaw radius_law;
  double twist_stiffness = 0.036;
  double cor = 0.005;

  static constexpr double mu = 0.6;

  /// Its wrench after `steps` of `step` [m], F in μP and M in Γ.
  [[nodiscard]] UnitWrench settled(const FingerCurve& curve, Projection projection, double step, int steps) const {
    FingerParameters with;
    with.mu = mu;
    with.radius_law = radius_law;
    with.stiffness = stiffness;
    with.twist_stiffness = twist_stiffness;
    SoftFinger finger(curve, with, projection);
    for (int i = 0; i <= steps; ++i) finger.update({{step * i, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), 1.0 / stiffness}, step * i / cor);
    return in_limits(finger.output().force.norm() / mu, -finger.output().moment / (mu * radius_law.radius(1.0)));
  }

  /// Eq. (17).
  [[nodiscard]] UnitWrench truth() const {
    const auto [force, moment] = ExactCurve(hertz()).wrench(SlipTwist::about_cor(cor / radius_law.radius(1.0)));
    return in_limits(force, moment);
  }

  static UnitWrench in_limits(double force, double moment) { return {force, moment / hertz()->moment_ratio()}; }
};

void add(Figure& figure, const char* series, double x, UnitWrench wrench) {
  figure.rows.push_back({"force", series, x, wrench.force});
  figure.rows.push_back({"moment", series, x, wrench.moment});
}

}  // namespace

Hazard stiffness_ratios() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"projection_stiffness", {}});
  const Law law = hertz();
  const double m0 = law->moment_ratio();
  const UnitWrench truth = ExactCurve(law).wrench(SlipTwist::about_cor(1.0));
  const Ellipse ellipse = Ellipse::through_intercepts(m0);
  const Table table = Table::build(law, 1e-8);
  const auto errors = [&](double kappa) {
    return std::array{normalised_distance(settled(ellipse, Projection::radial, kappa), truth, m0),
                      normalised_distance(settled(table, Projection::radial, kappa), truth, m0),
                      normalised_distance(settled(box(1.0, m0), Projection::closest_point, kappa), truth, m0),
                      normalised_distance(settled(table, Projection::closest_point, kappa), truth, m0)};
  };
  constexpr std::array series{"ellipse, shrunk along the ray", "exact curve, radial projection", "force and moment clamped separately",
                              "limitcurve"};
  double ours = 0.0;
  for (const double kappa : in_ratios(1e-6, 1e6, 49)) {
    const auto at = errors(kappa);
    for (std::size_t i = 0; i < series.size(); ++i) figure.rows.push_back({"error", series[i], kappa, at[i]});
    ours = std::max(ours, at.back());
  }
  for (const double kappa : {1e-6, 1.0, 10.0, 1e6}) {
    const std::string power = kappa == 1.0 ? "1" : kappa == 10.0 ? "10" : kappa < 1.0 ? "1e-6" : "1e6";
    found.findings.push_back({"stiffness ratios", "ellipse, radial projection (eq. 23)",
                              "error of the wrench of a steady twist (c = a, k_r/k_l = " + power + "·(m₀a)²; ours: any)", errors(kappa)[0],
                              ours});
  }
  found.findings.push_back({"stiffness ratios", "force and moment clamped separately (§3.1)", "the same, any ratio", errors(1.0)[2], ours});
  return found;
}

Hazard small_contacts() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"projection_small", {}});
  const double m0 = hertz()->moment_ratio();
  const Ellipse ellipse = Ellipse::through_intercepts(m0);
  const FingerCurve table = Table::build(hertz(), 1e-8);
  const auto of_moment = [&](double mu_r) { return SteadyTwist{RadiusLaw::of_mu_r(mu_r, 0.0, SteadyTwist::mu, m0)}; };
  const auto settled = [&](const SteadyTwist& twist, const FingerCurve& curve, Projection projection) {
    return twist.settled(curve, projection, 2e-5, 4000);
  };
  for (const double mu_r : in_ratios(1e-6, 0.1, 41)) {
    const SteadyTwist twist = of_moment(mu_r);
    add(figure, "eq. (17)", 1e3 * mu_r, twist.truth());
    add(figure, "ellipse, shrunk along the ray", 1e3 * mu_r, settled(twist, ellipse, Projection::radial));
    add(figure, "limitcurve", 1e3 * mu_r, settled(twist, table, Projection::closest_point));
  }
  for (const auto& [mu_r, name] : {std::pair{1e-3, "1"}, {1e-4, "0.1"}, {1e-6, "0.001"}}) {
    const SteadyTwist twist = of_moment(mu_r);
    found.findings.push_back({"a small contact, the springs of a larger one", "ellipse, radial projection (eq. 23)",
                              std::string("friction force of a steady twist in μP (c = 5 mm, μ_r = ") + name + " mm, k_r = 0.036 N m/rad)",
                              settled(twist, ellipse, Projection::radial).force, settled(twist, table, Projection::closest_point).force});
  }
  return found;
}

Hazard growing_radius() {
  Hazard found;
  Figure& figure = found.figures.emplace_back(Figure{"projection_growth", {}});
  const FingerCurve table = Table::build(hertz(), 1e-8);
  const auto at = [](double cor) { return SteadyTwist{RadiusLaw::power(0.006, 1.0 / 3.0), 0.036, cor}; };
  // 10 mm/s at 1 kHz: the result of the c-curve depends on the step.
  const auto settled = [&](const SteadyTwist& twist, Projection projection) { return twist.settled(table, projection, 1e-5, 4000); };
  for (const double cor : in_ratios(2e-4, 0.1, 31)) {
    const SteadyTwist twist = at(cor);
    add(figure, "eq. (17)", 1e3 * cor, twist.truth());
    add(figure, "shrunk along the ray", 1e3 * cor, settled(twist, Projection::radial));
    add(figure, "shrunk along the c-curve", 1e3 * cor, settled(twist, Projection::c_curve));
    add(figure, "limitcurve", 1e3 * cor, settled(twist, Projection::closest_point));
  }
  const SteadyTwist twist = at(0.005);
  const double ours = SteadyTwist::mu * settled(twist, Projection::closest_point).force;
  const auto add_finding = [&](const char* method, Projection projection, double step, const char* micrometres) {
    found.findings.push_back({"a radius that grows with the load", method,
                              std::string("friction force of a steady twist [N] (c = 5 mm, a = 6 mm at 1 N, a ∝ P^⅓, μP = 0.6 N, ") +
                                  micrometres + " µm a step)",
                              SteadyTwist::mu * twist.settled(table, projection, step, static_cast<int>(std::lround(0.04 / step))).force,
                              ours});
  };
  add_finding("exact curve, radial projection", Projection::radial, 1e-5, "10");
  for (const auto& [step, micrometres] : {std::pair{1e-5, "10"}, {1e-4, "100"}, {1e-6, "1"}}) {
    add_finding("exact curve, projection along the c-curve (Fig. 5)", Projection::c_curve, step, micrometres);
  }
  return found;
}

}  // namespace limitcurve::stability
