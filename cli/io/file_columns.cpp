// SPDX-License-Identifier: MIT
#include "cli/io/file_columns.hpp"

#include "cli/io/argument_parts.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/internal/range.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

namespace limitcurve::cli {

using namespace ranges;

namespace {

struct Unit {
  std::string name;
  double value;  ///< in SI units
};

const std::vector<Unit> length_units{{"m", 1.0}, {"cm", 0.01}, {"mm", 1e-3}, {"um", 1e-6}, {"in", 0.0254}};
const std::vector<Unit> force_units{{"N", 1.0},  {"mN", 1e-3},     {"uN", 1e-6},
                                    {"kN", 1e3}, {"kgf", 9.80665}, {"lbf", 4.4482216152605}};

std::vector<Unit> products(const std::vector<Unit>& first, const std::vector<Unit>& second) {
  std::vector<Unit> all;
  for (const Unit& one : first) {
    for (const Unit& other : second) all.push_back({one.name + other.name, one.value * other.value});
  }
  return all;
}

struct Quantity {
  std::string_view name;
  std::vector<Unit> units;
  std::vector<std::string_view> columns;
};

const std::array<Quantity, 5> quantities{
    {{"length",
      length_units,
      {"radius", "sigma_radius", "ratio", "ratio_sd", "dx", "dy", "x", "y", "z", "bx", "by", "bz"}},
     {"force", force_units, {"load", "force", "sigma_force", "force_x", "force_y", "fx", "fy"}},
     {"moment", products(force_units, length_units), {"moment", "sigma_moment"}},
     {"angle", {{"rad", 1.0}, {"deg", std::numbers::pi / 180.0}}, {"twist", "dtheta"}},
     {"time", {{"s", 1.0}, {"ms", 1e-3}}, {"time"}}}};

/// Where the first `separator` outside of double quotes is, or the end.
std::size_t end_of_item(std::string_view text, char separator) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] == separator && !quoted) return i;
  }
  return text.size();
}

/// Calls `take(key, value)` of each item of KEY=VALUE,…, which returns false if it is none. Each key may stand there
/// once.
template <class Take>
void for_each_item(std::string_view list, std::string_view expected, const Take& take) {
  std::vector<std::string_view> keys;
  while (!list.empty()) {
    const std::string_view item = list.substr(0, end_of_item(list, ','));
    list.remove_prefix(std::min(item.size() + 1, list.size()));
    const std::size_t equals = item.find('=');
    if (std::find(keys.begin(), keys.end(), item.substr(0, equals)) != keys.end())
      throw std::invalid_argument("got '" + std::string(item) + "', expected one item of this name, got two");
    keys.push_back(item.substr(0, equals));
    if (equals == 0 || equals == std::string_view::npos || equals + 1 == item.size() ||
        !take(std::string(item.substr(0, equals)), std::string(item.substr(equals + 1)))) {
      throw std::invalid_argument("got '" + std::string(item) + "', expected " + std::string(expected));
    }
  }
}

}  // namespace

void FileColumns::read_names(std::string_view list) {
  for_each_item(list,
                "a list such as load=-Fz,force=Fx:Fy,moment=Tz, with a name that has a comma or colon in double quotes",
                [&](const std::string& own, const std::string& other) {
                  names.emplace_back(own, other);
                  return true;
                });
}

std::string FileColumns::options_of(const std::vector<std::string_view>& columns) const {
  std::string list;
  for (const auto& [own, in_file] : names) {
    if (std::find(columns.begin(), columns.end(), own) == columns.end()) continue;
    list.append(list.empty() ? "" : ",").append(own).append("=").append(in_file);
  }
  return (list.empty() ? "" : " --columns " + shell_word(list)) +
         (units.empty() ? "" : " --units " + shell_word(units));
}

FileColumns::Parts FileColumns::parts_of(std::string_view text) {
  Parts parts;
  parts.turned = text.starts_with('-');
  if (parts.turned) text.remove_prefix(1);
  parts.is_plain = !parts.turned && text.find_first_of(":\"") == std::string_view::npos;
  for (;;) {
    const std::size_t end = end_of_item(text, ':');
    std::string_view name = text.substr(0, end);
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
    parts.names.emplace_back(name);
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

std::string_view FileColumns::quantity_of(std::string_view column) {
  column = column.substr(0, column.find_last_not_of("0123456789") + 1);  // x2 is the x of the second finger
  for (const auto& [name, units, columns] : quantities) {
    if (std::find(columns.begin(), columns.end(), column) != columns.end()) return name;
  }
  return "";
}

double FileColumns::scale(std::string_view quantity) const {
  const auto given = scales.find(quantity);
  return given == scales.end() ? 1.0 : given->second;
}

void FileColumns::warn_idle_units(const std::vector<std::string_view>& used, const std::string& what) const {
  for (const auto& [quantity, scale] : scales) {
    if (messages != nullptr && std::find(used.begin(), used.end(), quantity) == used.end())
      messages->say("limitcurve: warning: --units " + quantity + " has no effect on " + what);
  }
}

void FileColumns::check_zero() const {
  if (zero && !least_load)
    throw std::invalid_argument("--zero needs --least-load, below which the sensor carries nothing");
}

std::optional<double> FileColumns::unit(std::string_view text) {
  if (text.size() > 2 && (text.front() == '[' || text.front() == '(')) text = text.substr(1, text.size() - 2);
  for (const Quantity& quantity : quantities) {
    const auto known =
        std::find_if(quantity.units.begin(), quantity.units.end(), [&](const Unit& one) { return one.name == text; });
    if (known != quantity.units.end()) return known->value;
  }
  return std::nullopt;
}

void FileColumns::read_units(std::string_view list) {
  for_each_item(list, units_text, [&](const std::string& name, const std::string& unit) {
    const auto quantity =
        std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& one) { return one.name == name; });
    if (quantity == quantities.end()) return false;
    const auto known =
        std::find_if(quantity->units.begin(), quantity->units.end(), [&](const Unit& one) { return one.name == unit; });
    const auto number = known == quantity->units.end() ? parse_number(unit) : known->value;
    if (!number || !positive.contains(*number)) return false;
    scales.insert_or_assign(name, *number);
    return true;
  });
  units = list;
}

}  // namespace limitcurve::cli
