// SPDX-License-Identifier: MIT
#include "limitcurve/pressure_law.hpp"

#include "limitcurve/quadrature/evaluators.hpp"
#include "limitcurve/quadrature/tanh_sinh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace limitcurve {

Law checked(Law law) {
  if (!law) throw std::invalid_argument("law: none (a null pointer), expected a pressure law");
  const std::vector<Extended>& breaks = law->breaks();
  const auto refuse = [&](const char* what) { throw std::invalid_argument("law '" + law->name() + "': " + what); };
  const auto falls = [](Extended one, Extended next) {
    return !(next > one && next <= std::numeric_limits<double>::max());
  };
  if (breaks.size() < 2 || breaks[0] != 0 || std::adjacent_find(breaks.begin(), breaks.end(), falls) != breaks.end()) {
    refuse("its breaks do not increase, expected radii from 0 to the end of the pressure");
  }
  const UnitForces<Extended> error = law->unrounded(1, Slope::unwanted).error;
  if (!(std::max(error.force, error.moment / breaks.back()) <= 1e-3L)) {
    refuse(
        "quadrature of its pressure does not give the load 1, expected the integral of 2 rho g to be 1, and breaks at "
        "every kink, jump and "
        "singular ring");
  }
  return law;
}

std::span<const std::string_view> method_names() {
  static constexpr std::array<std::string_view, 6> names{"auto", "closed", "ring", "punch", "direct", "boost"};
  return names;
}

std::string_view to_string(Method method) {
  return method_names()[static_cast<std::size_t>(method)];
}

Method method_of(const PressureLaw& law, std::string_view name) {
  std::string has;
  for (std::size_t i = 0; i < method_names().size(); ++i) {
    const auto method = static_cast<Method>(i);
    if (!law.allows(method)) continue;
    if (to_string(method) == name) return method;
    has += (has.empty() ? "" : ", ") + std::string(to_string(method));
  }
  throw std::invalid_argument("method '" + std::string(name) + "': law '" + law.name() +
                              "' has no such method, expected one of " + has);
}

namespace {

const std::vector<Extended>& unit_disc() {
  static const std::vector<Extended> ends{0, 1};
  return ends;
}

}  // namespace

PressureLaw::PressureLaw() {
  // Build static data now, so that no control loop builds it on first use.
  static_cast<void>(TanhSinhRule<double>::get());
  static_cast<void>(TanhSinhRule<Extended>::get());
  unit_disc();
}

const std::vector<Extended>& PressureLaw::breaks() const noexcept {
  return unit_disc();
}

UnitForces<double> PressureLaw::forces(double s, Slope slope) const noexcept {
  if (const auto exact = closed(s, slope)) {
    return {static_cast<double>(exact->force), static_cast<double>(exact->moment),
            static_cast<double>(exact->force_slope)};
  }
  return evaluators::ring(*this, s, slope).forces;
}

Quadrature<Extended> PressureLaw::unrounded(Extended s, Slope slope) const noexcept {
  if (const auto forces = closed(s, slope)) return {*forces, {0, 0, 0}};
  return evaluators::ring(*this, s, slope);
}

Quadrature<double> PressureLaw::line_profile(double t) const noexcept {
  return evaluators::line_profile(*this, t);
}

bool PressureLaw::allows(Method method) const noexcept {
  if (method == Method::closed) return closed(1, Slope::unwanted).has_value();
  if (method == Method::punch) return punch_density({0.5L, 0.5L}).has_value();
  return true;
}

WrenchEstimate PressureLaw::evaluate(double s, Method method) const noexcept {
  s = std::fabs(s);
  if (method == Method::punch) return evaluators::rounded(evaluators::punch(*this, Extended(s)));
  if (method == Method::direct) return evaluators::rounded(evaluators::direct(*this, Extended(s)));
  if (method == Method::boost) {
    const auto [forces, error] = evaluators::boost(*this, s);
    return {{forces.force, forces.moment}, {error.force, error.moment}, forces.force_slope};
  }
  if (method != Method::ring) return evaluators::rounded(PressureLaw::unrounded(s, Slope::wanted));
  return evaluators::rounded(evaluators::ring(*this, Extended(s), Slope::wanted));
}

}  // namespace limitcurve
