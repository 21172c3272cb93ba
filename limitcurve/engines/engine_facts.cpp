// SPDX-License-Identifier: MIT
#include "limitcurve/engines/engine_facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

constexpr std::array formulas{
    Formula{"mu", friction_of, nullptr, "times load: the force's limit"},
    Formula{"mu_x", friction_of, nullptr, "times load: the force's limit along x"},
    Formula{"mu_y", friction_of, nullptr, "times load: the force's limit along y"},
    Formula{"mu/f", friction_of, nullptr, "times f and load: the force's limit"},
    Formula{"mu_r", moment_of, itself, "times load: the moment's limit"},
    Formula{"mu_r/f", moment_of, itself, "times f and load: the moment's limit"},
    Formula{"mu_r/1000", [](double mu, double lever) { return 1e-3 * (mu * lever); }, nullptr, ""},
    Formula{"m0 a", [](double /*mu*/, double lever) { return lever; },
            [](double value, double factor) { return factor * value; }, "times @ and load: the moment's limit"},
    Formula{"16 m0 a/(3 pi)", [](double /*mu*/, double lever) { return lever / hertz_ratio; },
            [](double value, double factor) { return hertz_ratio * factor * value; },
            "times 3 pi/16 and @ and load: the moment's limit"},
    Formula{"sqrt(m0 a/pi)", [](double /*mu*/, double lever) { return std::sqrt(lever / std::numbers::pi); },
            [](double value, double factor) { return std::numbers::pi * value * value * factor; },
            "pi times its square and @ and load: the moment's limit"},
};

}  // namespace

const Formula* find_formula(std::string_view text) {
  const auto found =
      std::find_if(formulas.begin(), formulas.end(), [&](const Formula& one) { return one.text == text; });
  return found == formulas.end() ? nullptr : &*found;
}

std::string note_of(const Facts& coefficient) {
  const std::string& note = coefficient.at("note");
  const Formula* const formula = find_formula(coefficient.at("formula"));
  std::string result(formula == nullptr || note.starts_with("times") ? "" : formula->use);
  if (const std::size_t at = result.find('@'); at != std::string::npos) result.replace(at, 1, coefficient.at("times"));
  if (!result.empty() && !note.empty()) result += "; ";
  return result + note;
}

}  // namespace limitcurve::engines
