// SPDX-License-Identifier: MIT
#include "godobject/contact_law.hpp"

#include "limitcurve/number.hpp"

#include <string_view>

namespace limitcurve::godobject {

namespace {

/// So far from any finger that only a wrong unit leads there, and so near 1 that no product of the step overflows.
double positive(std::string_view name, double value, std::string_view unit) {
  if (!(value >= 1e-15 && value <= 1e15)) throw out_of_range(name, value, unit, "> 0, from 1e-15 to 1e15");
  return value;
}

double non_negative(std::string_view name, double value, std::string_view unit) {
  if (!(value >= 0.0 && value <= 1e15)) throw out_of_range(name, value, unit, ">= 0, up to 1e15");
  return value;
}

/// The radius at which μ m₀ a is the moment coefficient; 0 where it or μ is zero.
double equivalent_radius(double moment_coefficient, double mu, double moment_ratio) {
  return mu > 0.0 ? moment_coefficient / (mu * moment_ratio) : 0.0;
}

}  // namespace

ContactLaw::ContactLaw(const FingerParameters& parameters, double moment_ratio)
    : springs_(Springs::of(positive("stiffness", parameters.stiffness, "N/m"),
                           positive("twist_stiffness", parameters.twist_stiffness, "N m/rad"))),
      damping_(non_negative("damping", parameters.damping, "N s/m")),
      twist_damping_(non_negative("twist_damping", parameters.twist_damping, "N m s/rad")),
      jump_limit_square_(parameters.jump_limit * parameters.jump_limit),
      hold_share_(parameters.hold_share) {
  if (!(parameters.jump_limit > 0.0)) throw out_of_range("jump_limit", parameters.jump_limit, "m", "> 0");
  if (!(hold_share_ >= 0.0 && hold_share_ <= 1.0)) throw out_of_range("hold_share", hold_share_, "1", "0 <= hold_share <= 1");
  positive("moment_ratio", moment_ratio, "1");
  const double mu = non_negative("mu", parameters.mu, "1");
  const double mu_dynamic = non_negative("mu_dynamic", parameters.mu_dynamic.value_or(mu), "1");
  if (mu_dynamic > mu) throw out_of_range("mu_dynamic", mu_dynamic, "1", "0 <= mu_dynamic <= mu");
  if (parameters.moment_coefficient) {
    const double mu_r = non_negative("moment_coefficient", *parameters.moment_coefficient, "m");
    if (mu == 0.0 && mu_r > 0.0) throw out_of_range("moment_coefficient", mu_r, "m", "0 where mu is 0");
    const double share = mu > 0.0 ? mu_dynamic / mu : 1.0;
    const double mu_r_dynamic =
        non_negative("moment_coefficient_dynamic", parameters.moment_coefficient_dynamic.value_or(mu_r * share), "m");
    if (mu_r_dynamic > mu_r) {
      throw out_of_range("moment_coefficient_dynamic", mu_r_dynamic, "m", "0 <= moment_coefficient_dynamic <= moment_coefficient");
    }
    static_ = {mu, equivalent_radius(mu_r, mu, moment_ratio)};
    dynamic_ = {mu_dynamic, equivalent_radius(mu_r_dynamic, mu_dynamic, moment_ratio)};
    // Not computed anew: the quotient would differ in the last digit.
    if (!parameters.moment_coefficient_dynamic && mu_dynamic > 0.0) dynamic_.radius = static_.radius;
  } else {
    if (parameters.moment_coefficient_dynamic) {
      throw out_of_range("moment_coefficient_dynamic", *parameters.moment_coefficient_dynamic, "m", "absent without moment_coefficient");
    }
    const double radius = positive("radius_law coefficient", parameters.radius_law.coefficient(), "m/N^gamma");
    static_ = {mu, radius};
    dynamic_ = {mu_dynamic, radius};
    if (parameters.radius_law.is_sampled() || parameters.radius_law.exponent() != 0.0) radius_law_ = parameters.radius_law;
  }
  constexpr double never = std::numeric_limits<double>::infinity();
  const auto inverse = [](double number) { return number > 0.0 ? 1.0 / number : never; };
  for (Limit* limit : {&static_, &dynamic_}) {
    limit->per_radius = inverse(limit->radius);
    limit->compliance_ratio = limit->radius * limit->radius * springs_.ratio;
    limit->per_compliance_ratio = inverse(limit->compliance_ratio);
    limit->least_load = least_unit * inverse(limit->mu * std::min(limit->radius, 1.0));
  }
  has_dampers_ = damping_ > 0.0 || twist_damping_ > 0.0;
  has_one_limit_ = static_.mu == dynamic_.mu && static_.radius == dynamic_.radius;
}

}  // namespace limitcurve::godobject
