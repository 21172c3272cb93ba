// SPDX-License-Identifier: MIT
#include "cli/commands/options.hpp"

#include "cli/io/argument_parts.hpp"
#include "godobject/finger/finger_parameter_table.hpp"
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace limitcurve::cli {

void Options::text(const std::string& name, std::string& value, const std::string& kind, const std::string& help,
                   Presence presence) {
  this->value(
      name, kind,
      [&value](const std::string& text) {
        if (text.empty()) throw std::invalid_argument("empty");
        value = text;
      },
      help, presence);
}

void Options::number(const std::string& name, double& value, Range range, const std::string& help, Presence presence) {
  const std::string standard =
      std::isnan(value) || presence == Presence::required ? "" : " (default " + format_number(value) + ")";
  this->value(
      name, "NUMBER", [&value, range](const std::string& text) { value = read_number(text, range); }, help + standard,
      presence);
}

void Options::number(const std::string& name, std::optional<double>& value, Range range, const std::string& help) {
  this->value(
      name, "NUMBER", [&value, range](const std::string& text) { value = read_number(text, range); }, help,
      Presence::optional);
}

void Options::numbers(const std::string& name, std::vector<double>& values, Range range, const std::string& help,
                      Presence presence) {
  value(
      name, "LIST", [&values, range](const std::string& text) { values = read_number_list(text, range); }, help,
      presence);
}

void Options::file_columns(FileColumns& columns) {
  columns.is_offered = true;
  value(
      "--columns", "LIST", [&columns](const std::string& list) { columns.read_names(list); },
      "Columns to read from the file: load=-Fz,force=Fx:Fy,moment=Fx:Fy:Fz:Tx:Ty:Tz reads -Fz as the load, the length "
      "of (Fx, Fy) as the force, and F.T/Fz as the moment, which is about the sensor's z through the contact, wherever "
      "that is (Tz alone is about the sensor's axis). The third of the six is the load's column. Put a name with : or "
      ", in double quotes",
      Presence::optional);
  value(
      "--units", "LIST", [&columns](const std::string& list) { columns.read_units(list); },
      "Units of the file, and of a force, moment or load option: " + std::string(units_text) + " (default SI)",
      Presence::optional);
}

void Options::least_load(FileColumns& columns) {
  number("--least-load", columns.least_load, positive,
         "Skip rows of --data with a load below this (in the file's unit), such as those of an empty gripper");
  flag("--zero", columns.zero,
       "Subtract the sensor's zero, which is the median of each pause: at least 5 rows with less than --least-load "
       "above "
       "the lowest percentile. Their scatter gives sigma_force and sigma_moment");
  columns.is_log = true;
}

void Options::count(const std::string& name, std::size_t& value, std::size_t least, std::size_t most,
                    const std::string& help) {
  whole(
      name, [&value](std::size_t number) { value = number; }, least, most,
      help + " (default " + std::to_string(value) + ")");
}

void Options::count(const std::string& name, std::optional<std::size_t>& value, std::size_t least, std::size_t most,
                    const std::string& help) {
  whole(
      name, [&value](std::size_t number) { value = number; }, least, most, help);
}

void Options::whole(const std::string& name, const std::function<void(std::size_t)>& take, std::size_t least,
                    std::size_t most, const std::string& help) {
  value(
      name, "N",
      [take, least, most](const std::string& text) {
        const auto number = parse_number(text);
        if (!number || !(*number >= static_cast<double>(least) && *number <= static_cast<double>(most)) ||
            *number != std::floor(*number)) {
          throw std::invalid_argument("got '" + text + "', expected a whole number from " + std::to_string(least) +
                                      " to " + std::to_string(most));
        }
        take(static_cast<std::size_t>(*number));
      },
      help, Presence::optional);
}

void Options::choice(const std::string& name, std::size_t standard, const std::function<void(std::size_t)>& take,
                     std::span<const std::string_view> names, const std::string& help, Presence presence) {
  value(
      name, value_name(name),
      [take, names](const std::string& text) {
        std::string given = text;
        std::replace(given.begin(), given.end(), '_', '-');
        const auto found = std::find(names.begin(), names.end(), given);
        if (found == names.end()) {
          throw std::invalid_argument("got '" + text + "', expected " + joined(names) +
                                      did_you_mean(text, {names.begin(), names.end()}));
        }
        take(static_cast<std::size_t>(found - names.begin()));
      },
      listed(help, names, presence == Presence::required ? names.size() : standard), presence);
}

std::string Options::value_name(std::string name) {
  if (!name.starts_with("--")) return "";
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name.substr(2);
}

std::string Options::listed(const std::string& help, std::span<const std::string_view> names, std::size_t standard) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    list.append(i == 0 ? "" : i + 1 == names.size() ? " or " : ", ").append(names[i]);
    if (i == standard) list += " (default)";
  }
  const std::size_t place = help.find("{}");
  return help.substr(0, place) + list + help.substr(place + 2);
}

void Options::finger(godobject::FingerParameters& value, const std::vector<std::string_view>& required, bool rare) {
  godobject::for_each_number(value, [&](const godobject::ParameterInfo& number, auto& field) {
    if (number.rare != rare) return;
    std::string name = "--" + std::string(number.name);
    std::replace(name.begin(), name.end(), '_', '-');
    const bool is_required = std::find(required.begin(), required.end(), number.name) != required.end();
    if constexpr (std::is_same_v<decltype(field), double&>) {
      this->number(name, field, number.range, std::string(number.text),
                   is_required ? Presence::required : Presence::optional);
    } else {
      this->number(name, field, number.range, std::string(number.text));
    }
  });
}

void Options::law(Law& value, Presence presence) {
  this->value(
      "--law", "LAW", [&value](const std::string& text) { value = read_law(text); },
      "Pressure law: hertz, uniform, power:n=2.3, … ('limitcurve laws' lists all), or measured "
      "samples:FILE.csv[,rim=RADIUS]",
      presence);
}

void Options::radius_law(std::optional<RadiusLawArgument>& value) {
  this->value(
      "--radius-law", "RADIUS-LAW", [&value](const std::string& text) { value = read_radius_law(text); },
      "Contact radius a(P) [m]: " + joined(RadiusLaw::examples(), ", ") +
          ", or measured samples:FILE.csv (columns load,radius) or moments:FILE.csv (load,moment, the moment limit [N "
          "m])",
      Presence::optional);
}

void Options::moment(MomentArgument& value) {
  radius_law(value.radius_law);
  number("--mu-r", value.mu_r, non_negative,
         "mu_r [m/N^gamma], which sets the moment limit mu_r P^(1+gamma), instead of --radius-law");
  number("--gamma", value.gamma, Range{-0.5, 1.0, "a number from -0.5 to 1"},
         "Exponent gamma of --mu-r, from -0.5 to 1 (default 0)");
}

Law law_if_needed(const Law& law, godobject::CurveKind kind, bool has_mu_r) {
  const bool is_closed = kind == godobject::CurveKind::ellipse || kind == godobject::CurveKind::box;
  return law == nullptr && is_closed && has_mu_r ? hertz() : law;
}

}  // namespace limitcurve::cli
