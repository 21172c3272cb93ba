// SPDX-License-Identifier: MIT
// The parameters of a finger from Python's keywords, and what they ask of a device.
#include "python/core.hpp"
#include "python/parameters.hpp"

#include "cli/io/law_argument.hpp"
#include "cli/io/unit_checks.hpp"
#include "godobject/finger/finger_parameter_table.hpp"
#include "godobject/scene/passivity.hpp"
#include "limitcurve/internal/names.hpp"
#include "limitcurve/internal/number.hpp"

#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace limitcurve::python {

using namespace godobject;

namespace {

/// A radius law's text, and the rows of its file.
using RadiusRows = std::tuple<std::string, std::vector<double>, std::vector<double>>;

}  // namespace

nb::dict without(const nb::dict& all, const char* name) {
  const auto result = nb::cast<nb::dict>(all.attr("copy")());
  if (result.contains(name)) PyDict_DelItemString(result.ptr(), name);
  return result;
}

nb::dict read_files(nb::dict given) {
  if (!given.contains("radius_law") || !nb::isinstance<nb::str>(given["radius_law"])) return given;
  const auto argument = cli::read_radius_law(nb::cast<std::string>(given["radius_law"]));
  if (argument.rows().empty()) return given;
  RadiusRows rows{argument.text(), {}, {}};
  for (const LoadSample& sample : argument.rows()) {
    std::get<1>(rows).push_back(sample.load);
    std::get<2>(rows).push_back(sample.value);
  }
  given["radius_law"] = rows;
  return given;
}

FingerParameters parameters_of(const nb::dict& given, double moment_max) {
  FingerParameters parameters;
  std::optional<cli::RadiusLawArgument> radius_law;
  for (const auto& [key, value] : given) {
    const auto name = nb::cast<std::string>(key);
    if (name == "radius_law") {
      RadiusRows rows;
      if (nb::try_cast(value, rows)) {
        const auto& [text, loads, values] = rows;
        std::vector<LoadSample> samples;
        for (std::size_t i = 0; i < std::min(loads.size(), values.size()); ++i)
          samples.push_back({loads[i], values[i]});
        radius_law.emplace(text, std::move(samples));
        continue;
      }
      if (!nb::isinstance<nb::str>(value)) refuse("radius_law", value, "a str, such as 'constant:a=0.005'");
      radius_law = cli::read_radius_law(nb::cast<std::string>(value));
      continue;
    }
    for_each_number(parameters, [&](const ParameterInfo& number, auto& field) {
      const bool may_be_absent = !std::is_same_v<decltype(field), double&>;
      if (number.name == name && !(may_be_absent && value.is_none())) field = number_of(value, name);
    });
  }
  if (!radius_law) return parameters;
  if (parameters.mu_r) throw std::invalid_argument("mu_r: not with radius_law, expected one of them");
  parameters.radius_law = radius_law->of(parameters.mu, moment_max);
  ask_unit(parameters.radius_law);
  return parameters;
}

void warn_without_skin(const char* type, const nb::dict& given, bool of_patch) {
  FingerParameters assumed;
  bool is_given = given.contains("radius_law");
  for_each_number(assumed, [&](const ParameterInfo& number, auto&) {
    is_given = is_given || given.contains(std::string(number.name).c_str());
  });
  if (is_given) return;
  const std::string radius = format_number(assumed.radius_law.radius(1.0));
  warn(std::string(type) + " without mu, stiffness, twist_stiffness" +
       (of_patch ? "" : " and radius_law (or mu_r), so a = " + radius + " m") + ": it has mu " +
       format_number(assumed.mu) + ", " + format_number(assumed.stiffness) + " N/m and " +
       format_number(assumed.twist_stiffness) + " N m/rad");
}

void ask_unit(const RadiusLaw& law) {
  const auto [first, last] = law.sampled_loads();
  cli::UnitChecks questions;
  questions.radii(law, std::array{std::max(first, 1.0), std::min(last, std::max(first, 1.0))});
  warn(questions.lines());
}

std::string parameters_signature(bool of_patch) {
  std::string text;
  const FingerParameters standard;
  for_each_number(standard, [&](const ParameterInfo& number, const auto& value) {
    if (of_patch && number.name.find("mu_r") != std::string_view::npos) return;
    if (of_patch && number.name == "gamma") return;
    text.append(text.empty() ? "" : ", ").append(number.name);
    if constexpr (std::is_same_v<decltype(value), const double&>) {
      const std::string digits = format_number(value);
      text.append(": float = ").append(digits).append(digits.find_first_of(".e") == std::string::npos ? ".0" : "");
    } else {
      text.append(": float | None = None");
    }
  });
  return of_patch ? text : text + ", radius_law: str = 'constant:a=0.005'";
}

Projection projection_of(nb::handle word) {
  if (word.is_none()) return Projection::closest_point;
  if (!nb::isinstance<nb::str>(word)) refuse("projection", word, joined(projection_names));
  return parse_projection(nb::cast<std::string>(word));
}

void add_passivity(nb::module_& module) {
  const auto delay_of = [](nb::handle given) {
    int delay = 0;
    if (!given.is_none() && !nb::try_cast(given, delay)) refuse("delay", given, "a whole number");
    return delay;
  };
  const std::string rest = parameters_signature() + ") -> ";
  define_static(
      module, "def device_damping_needed(sample_time: float, *, delay: int = 0, " + rest + "tuple[float, float]",
      [delay_of](const BoundArguments& given) {
        const DeviceDamping device = device_damping_needed(parameters_of(given.by_name, 1.0),
                                                           number_of(given[0], "sample_time"), delay_of(given[1]));
        return std::tuple(device.sliding, device.twist);
      },
      "The damping [N s/m] and twist damping [N m s/rad] that a device itself needs, with its force `delay` samples "
      "late, so that the\n"
      "sampled springs and dampers of a finger add no energy in any hand. Most devices are a sample late.\n\n"
      ">>> import limitcurve as lc\n"
      ">>> lc.device_damping_needed(1e-3, delay=1, stiffness=1000, twist_stiffness=0.04)\n"
      "(1.5, 6e-05)\n");
  define_static(
      module,
      "def require_passive(sample_time: float, b: float, b_r: float = float('inf'), *, delay: int = 0, " + rest +
          "None",
      [delay_of](const BoundArguments& given) {
        const double twist = number_of(given[2], "b_r", std::numeric_limits<double>::infinity());
        require_passive(parameters_of(given.by_name, 1.0), number_of(given[0], "sample_time"),
                        {number_of(given[1], "b"), twist}, delay_of(given[3]));
      },
      "ValueError, with what to change, unless a device damped by b [N s/m] and b_r [N m s/rad] has more than it "
      "needs; inf leaves one "
      "unchecked.");
}

}  // namespace limitcurve::python
