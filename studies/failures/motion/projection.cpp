// SPDX-License-Identifier: MIT
// Entry "projection": a search that fails.
#include "../failures.hpp"

#include "../../../tests/fit/synthetic.hpp"
#include "../numerics/sampling.hpp"
#include "godobject/finger_curve.hpp"
#include "godobject/projection.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/table.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace limitcurve::stability {

namespace {

using namespace godobject;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The closest point's condition in s = c/a: (x − f(s)) − sχ(y − m(s)) = 0.
struct Condition {
  const PressureLaw& law;
  UnitTrial<double> trial;

  [[nodiscard]] std::pair<double, double> value_and_slope(double s) const {
    const UnitForces<double> at = law.forces(s);
    const double chi = trial.compliance_ratio;
    const double over_moment = chi * (trial.moment - at.moment);
    return {trial.force - at.force - s * over_moment, -at.force_slope - over_moment - s * s * chi * at.force_slope};
  }

  /// The one root, by halving the spin fraction's interval until it is a number.
  [[nodiscard]] double root() const {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 1100; ++i) {
      const double u = low > 0.0 || high > 1e-300 ? 0.5 * (low + high) : 0.0;
      if (u == low || u == high) break;
      // In u the function rises from −χy to x; in s it falls. Its sign is that of u(x − f) − (1−u)χ(y − m).
      const UnitForces<double> at = law.forces((1.0 - u) / u);
      const double value =
          u * (trial.force - at.force) - (1.0 - u) * trial.compliance_ratio * (trial.moment - at.moment);
      (value > 0.0 ? high : low) = u;
    }
    return high;
  }
};

/// Newton's method in its common form: until a step is small, without bracket, at most 64 steps. NaN if it fails.
double by_newton(const Condition& condition, double s) {
  for (int i = 0; i < 64; ++i) {
    const auto [value, slope] = condition.value_and_slope(s);
    const double step = value / slope;
    s -= step;
    if (!(s >= 0.0 && s < infinity)) break;
    if (std::fabs(step) <= 1e-10 * s) return s;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

struct Failures {
  double newton;
  double newton_ahead;
  double ours;
};

/// Fractions of random trials without a closest point, for stiffness ratio κ and trials `over` times the limit.
Failures failures(const Law& law, const FingerCurve& table, double kappa, double least_over, double most_over) {
  const ExactCurve curve(law);
  const double m0 = law->moment_ratio();
  fit::Random random(5);
  const auto logarithmic = [&](double low, double high) {
    return low * std::pow(high / low, random.uniform(0.0, 1.0));
  };
  constexpr int rounds = 300;
  Failures count{0.0, 0.0, 0.0};
  for (int i = 0; i < rounds; ++i) {
    const double angle = 0.5 * std::numbers::pi * random.uniform(0.001, 0.999);
    const UnitWrench direction{std::cos(angle), m0 * std::sin(angle)};
    const double scale = (1.0 + logarithmic(least_over, most_over)) / curve.gauge(direction);
    const UnitTrial<double> trial{direction.force * scale, direction.moment * scale, 1.0 / (kappa * m0 * m0), 1.0};
    const Condition condition{*law, trial};
    const UnitWrench truth = curve.wrench(SlipTwist::of_spin_fraction(condition.root()));
    const auto fails = [&](UnitWrench wrench) {
      return !(std::hypot(wrench.force - truth.force, (wrench.moment - truth.moment) / m0) <= 1e-8);
    };
    const auto at = [&](double s) {
      const UnitForces<double> forces = law->forces(std::isfinite(s) ? s : 0.0);
      return UnitWrench{std::isfinite(s) ? forces.force : infinity, forces.moment};
    };
    const double last = logarithmic(0.1, 10.0);
    count.newton += fails(at(by_newton(condition, last)));
    count.newton_ahead += fails(at(by_newton(condition, trial.force / (trial.compliance_ratio * trial.moment))));
    const auto found = project_on_to_closest_point(table.view(), trial, last < 1.0 ? last : 2.0 - 1.0 / last);
    count.ours += fails({trial.force * found.force_fraction, trial.moment * found.moment_fraction});
  }
  return {count.newton / rounds, count.newton_ahead / rounds, count.ours / rounds};
}

}  // namespace

Hazard newton_without_bracket() {
  Hazard found;
  const Law law = hertz();
  const FingerCurve table(Table::build(law, 1e-10));
  double ours = 0.0;
  for (const double kappa : in_ratios(1e-6, 1e6, 37)) raise(ours, failures(law, table, kappa, 1e-4, 10.0).ours);
  for (const double over : in_ratios(1e-4, 1e8, 37)) raise(ours, failures(law, table, 1.0, over, over * 1.0001).ours);
  const Failures even = failures(law, table, 1.0, 1e-4, 10.0);
  const Failures stiff = failures(law, table, 1e6, 1e-4, 10.0);
  const std::string share = "share of slips with no closest point found ";
  found.add("Newton without a bracket", "from the last COR", share + "(trials up to 11 times the limit)", even.newton,
            ours);
  found.add("Newton without a bracket", "from the trial's direction", share + "(k_r/k_l = 1e6·(m₀a)²)",
            stiff.newton_ahead, ours);
  return found;
}

}  // namespace limitcurve::stability
