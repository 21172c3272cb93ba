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
#include <string>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;

const double m0 = hertz()->moment_ratio();
constexpr double stiffness = 1000.0;
constexpr double radius = 0.005;

/// Distance of two unit wrenches in the normalised plane.
double normalised_distance(UnitWrench one, UnitWrench other) {
  return std::hypot(one.force - other.force, (one.moment - other.moment) / m0);
}

/// Steady wrench of a finger under a steady twist about a COR at c = a, for κ = k_r/(k_l(m₀a)²).
UnitWrench settled(const FingerCurve& curve, Projection projection, double kappa) {
  const double twist_stiffness = kappa * stiffness * m0 * m0 * radius * radius;
  constexpr double force_unit = 0.5;  // μP [N]
  constexpr FrictionLimit<double> limit{force_unit, radius};
  const FrictionLimits<double> limits{limit, limit, stiffness / twist_stiffness};
  // A step is a quarter of the longer of the two decay lengths of the springs.
  const double step = 0.25 * std::max(force_unit / stiffness, force_unit * m0 * radius * radius / twist_stiffness);
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

/// The unit wrench of a steady twist about s if one of force and moment is limited first and the other within the rest
/// of the ellipse. Both springs stretch at a constant rate, a tenth of the limit a step.
UnitWrench one_after_the_other(double s, bool force_first) {
  const SlipTwist twist = SlipTwist::about_cor(s);
  double force = 0.0;
  double moment = 0.0;
  for (int i = 0; i < 2000; ++i) {
    force += 0.1 * twist.slide / (twist.slide + twist.spin);
    moment += 0.1 * twist.spin / (twist.slide + twist.spin) / m0;
    double& first = force_first ? force : moment;
    double& second = force_first ? moment : force;
    first = std::min(first, 1.0);
    second = std::min(second, std::sqrt(1.0 - first * first));
  }
  return {force, moment * m0};
}

}  // namespace

Hazard stiffness_ratios() {
  Hazard found;
  const UnitWrench truth = ExactCurve(hertz()).wrench(SlipTwist::about_cor(1.0));
  const FingerCurve table = Table::build(hertz(), 1e-8);
  double ours = 0.0;
  for (const double kappa : in_ratios(1e-6, 1e6, 49)) {
    raise(ours, normalised_distance(settled(table, Projection::closest_point, kappa), truth));
  }
  const auto add = [&](const char* method, const FingerCurve& curve, Projection projection, double kappa,
                       const char* name) {
    found.add("stiffness ratios", method,
              std::string("error of the wrench of a steady twist (c = a, k_r/k_l = ") + name + "·(m₀a)²; ours: any)",
              normalised_distance(settled(curve, projection, kappa), truth), ours);
  };
  for (const auto& [kappa, name] : {std::pair{1e-6, "1e-6"}, {1.0, "1"}, {10.0, "10"}, {1e6, "1e6"}}) {
    add("ellipse, radial projection (eq. 23)", Ellipse::through_intercepts(m0), Projection::radial, kappa, name);
  }
  add("force and moment clamped separately (§3.1)", box(1.0, m0), Projection::closest_point, 1.0, "1");
  return found;
}

Hazard order_of_limits() {
  Hazard found;
  const Table table = Table::build(hertz(), 1e-8);
  const ExactCurve curve(hertz());
  std::array<double, 3> worst{};
  for (const double s : in_ratios(0.1, 10.0, 31)) {
    const SlipTwist twist = SlipTwist::about_cor(s);
    const std::array wrenches{one_after_the_other(s, true), one_after_the_other(s, false), table.wrench(twist)};
    for (std::size_t i = 0; i < worst.size(); ++i)
      raise(worst[i], normalised_distance(wrenches[i], curve.wrench(twist)));
  }
  const std::string quantity = "error of the wrench of a steady twist (0.1 ≤ c/a ≤ 10)";
  found.add("order of the limits", "force first, moment within the rest", quantity, worst[0], worst[2]);
  found.add("order of the limits", "moment first, force within the rest", quantity, worst[1], worst[2]);
  return found;
}

}  // namespace limitcurve::stability
