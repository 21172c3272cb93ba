// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger.hpp"
#include "limitcurve/internal/range.hpp"

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <variant>

namespace limitcurve::godobject {

/// A number among the parameters of a finger: what the options of the command, Python's keywords, C's structure and the
/// checks are made from.
struct ParameterInfo {
  std::string_view name;
  std::variant<double FingerParameters::*, std::optional<double> FingerParameters::*> member;
  std::string_view unit;
  Range range;
  std::string_view text;  ///< help
  bool rare = false;      ///< help shows it under --help-all alone
};

/// So wide that only a wrong unit leaves it, and so narrow that no product in a step overflows.
inline constexpr Range coefficient{0.0, 1e15, "a number >= 0, up to 1e15"};
inline constexpr Range spring{1e-15, 1e15, "a number > 0, from 1e-15 to 1e15"};

inline constexpr std::array finger_parameter_table = std::to_array<ParameterInfo>({
    {"mu", &FingerParameters::mu, "1", coefficient, "Friction coefficient mu [1]"},
    {"mu_dynamic", &FingerParameters::mu_dynamic, "1", coefficient, "Friction coefficient during slip (default mu)"},
    {"mu_r", &FingerParameters::mu_r, "m", coefficient,
     "Instead of a radius law: mu_r [m/N^gamma], which sets the moment limit mu_r P^(1+gamma)"},
    {"gamma",
     &FingerParameters::gamma,
     "1",
     {-0.5, 1.0, "a number from -0.5 to 1"},
     "Exponent gamma of mu_r, from -0.5 to 1",
     true},
    {"mu_r_dynamic", &FingerParameters::mu_r_dynamic, "m", coefficient,
     "mu_r during slip [m] (default mu_r times mu_dynamic/mu)", true},
    {"stiffness", &FingerParameters::stiffness, "N/m", spring,
     "Contact stiffness k_l [N/m]; the load is P = k_l times depth"},
    {"twist_stiffness", &FingerParameters::twist_stiffness, "N m/rad", spring, "Torsional stiffness k_r [N m/rad]"},
    {"damping", &FingerParameters::damping, "N s/m", coefficient, "Damping b_l of each finger [N s/m]"},
    {"twist_damping", &FingerParameters::twist_damping, "N m s/rad", coefficient,
     "Damping b_r of each finger [N m s/rad]", true},
    {"rest_margin", &FingerParameters::rest_margin, "1", coefficient,
     "Hysteresis: a sliding finger rests once its trial is below the sliding limit / (1 + this*(mu/mu_dynamic - 1)) "
     "[1]",
     true},
    {"max_speed",
     &FingerParameters::max_speed,
     "m/s",
     {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::infinity(), "a number > 0, or inf"},
     "Largest speed since the last good sample [m/s]; a faster sample is invalid (default 5; inf: none is)",
     true},
    {"fault_decay",
     &FingerParameters::fault_decay,
     "1",
     {0.0, 1.0, "a number from 0 to 1"},
     "Factor on load, force and moment at each invalid sample after the first [1]: 0.95 fades, 1 holds",
     true},
});

/// Calls `take(number, value)` for each; the value is a double or an optional one.
template <class Parameters, class Take>
void for_each_number(Parameters& parameters, const Take& take) {
  for (const ParameterInfo& number : finger_parameter_table)
    std::visit([&](auto member) { take(number, parameters.*member); }, number.member);
}

}  // namespace limitcurve::godobject
