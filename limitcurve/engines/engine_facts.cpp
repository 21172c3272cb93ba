// SPDX-License-Identifier: MIT
#include "limitcurve/engines/engine_facts.hpp"

#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace limitcurve::engines {

namespace {

/// The rows of a CSV text; cells may be quoted.
std::vector<Facts> read_facts(std::string_view text) {
  std::vector<std::string> columns;
  std::vector<Facts> rows;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    if (line.empty() || line.front() == '#') continue;
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"' && quoted && line.substr(i + 1, 1) == "\"") {
        cells.back() += line[++i];
      } else if (line[i] == '"') {
        quoted = !quoted;
      } else if (line[i] == ',' && !quoted) {
        cells.emplace_back();
      } else {
        cells.back() += line[i];
      }
    }
    if (columns.empty()) {
      columns = cells;
      continue;
    }
    if (cells.size() != columns.size())
      throw std::logic_error("data/engines: expected a cell a column: " + std::string(line));
    Facts& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) row[columns[i]] = cells[i];
  }
  return rows;
}

}  // namespace

const std::vector<Facts>& all_engines() {
  static const std::vector<Facts> rows = read_facts(engines_csv);
  return rows;
}

const std::vector<Facts>& all_coefficients() {
  static const std::vector<Facts> rows = read_facts(coefficients_csv);
  return rows;
}

bool serves(const Facts& coefficient, std::string_view engine) {
  const std::vector<std::string> engines = words(coefficient.at("engine"));
  return std::find(engines.begin(), engines.end(), engine) != engines.end();
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    if (!word.empty()) result.emplace_back(word);
    text.remove_prefix(std::min(text.size(), word.size() + 1));
  }
  return result;
}

double friction_of(double mu, double /*lever*/) {
  return mu;
}
namespace {

double moment_of(double mu, double lever) {
  return mu * lever;
}
double itself(double value, double /*factor*/) {
  return value;
}

constexpr double hertz_ratio = 3.0 * std::numbers::pi / 16.0;

/// The lever of PhysX and Gazebo that grows with the depth, at 0.1 mm; 0 switches it off.
double lever_at_depth(double value) {
  return value > 0.0 ? std::sqrt(value * 1e-4) : std::numeric_limits<double>::quiet_NaN();
}
double zero(double /*mu*/, double /*lever*/) {
  return 0.0;
}

constexpr std::array formulas{
    Formula{"mu", friction_of, nullptr, "force limit = value * load"},
    Formula{"mu_x", friction_of, nullptr, "force limit = value * load along x"},
    Formula{"mu_y", friction_of, nullptr, "force limit = value * load along y"},
    Formula{"mu/f", friction_of, nullptr, "force limit = value * f * load"},
    Formula{"mu_r", moment_of, itself, "moment limit = value * load"},
    Formula{"mu_r/f", moment_of, itself, "moment limit = value * f * load"},
    Formula{"mu_r/1000", [](double mu, double lever) { return 1e-3 * (mu * lever); }, nullptr, ""},
    Formula{"rho", zero,
            [](double value, double) { return value > 0.0 ? value : std::numeric_limits<double>::quiet_NaN(); }, ""},
    Formula{"m0 a", [](double /*mu*/, double lever) { return lever; },
            [](double value, double factor) { return factor * value; }, "moment limit = value * @ * load"},
    Formula{"sqrt(value depth)", zero, [](double value, double factor) { return factor * lever_at_depth(value); },
            "moment limit = sqrt(value * depth) * @ * load: here at a depth of 0.1 mm"},
    Formula{"3 pi/16 sqrt(value depth)", zero,
            [](double value, double factor) { return hertz_ratio * factor * lever_at_depth(value); },
            "moment limit = 3 pi/16 * sqrt(value * depth) * @ * load: here at a depth of 0.1 mm"},
    Formula{"16 m0 a/(3 pi)", [](double /*mu*/, double lever) { return lever / hertz_ratio; },
            [](double value, double factor) { return hertz_ratio * factor * value; },
            "moment limit = value * 3 pi/16 * @ * load"},
    Formula{"sqrt(m0 a/pi)", [](double /*mu*/, double lever) { return std::sqrt(lever / std::numbers::pi); },
            [](double value, double factor) { return std::numbers::pi * value * value * factor; },
            "moment limit = pi * value^2 * @ * load"},
};

/// Whether a value meets a condition of a note: 4, >0, <1000.
bool holds(std::string_view condition, double value) {
  const char sign = condition.front();
  const double bound = parse_number(condition.substr(sign == '<' || sign == '>')).value();
  return sign == '<' ? value < bound : sign == '>' ? value > bound : value == bound;
}

}  // namespace

const Formula* find_formula(std::string_view text) {
  const auto found =
      std::find_if(formulas.begin(), formulas.end(), [&](const Formula& one) { return one.text == text; });
  return found == formulas.end() ? nullptr : &*found;
}

std::string note_of(const Facts& coefficient, double value) {
  std::string_view note = coefficient.at("note");
  const Formula* const formula = find_formula(coefficient.at("formula"));
  std::string result(formula == nullptr || note.find("limit = ") != note.npos ? "" : formula->use);
  if (const std::size_t at = result.find('@'); at != std::string::npos) result.replace(at, 1, coefficient.at("times"));
  while (!note.empty()) {
    std::string_view part = note.substr(0, note.find("; "));
    note.remove_prefix(std::min(note.size(), part.size() + 2));
    if (part.front() == '[') {
      const std::size_t end = part.find(']');
      if (!holds(part.substr(1, end - 1), value)) continue;
      part.remove_prefix(end + 2);
    }
    result.append(result.empty() ? "" : "; ").append(part);
  }
  return result;
}

}  // namespace limitcurve::engines
