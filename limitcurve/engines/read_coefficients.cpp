// SPDX-License-Identifier: MIT
#include "limitcurve/engines/engine_coefficients.hpp"

#include "limitcurve/engines/engine_facts.hpp"
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/pressure_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace limitcurve::engines {

namespace {

/// The row of an engine's parameter, by any of its names.
const Facts& find_coefficient(std::string_view engine, std::string_view parameter) {
  std::vector<std::string> known;
  for (const Facts& facts : all_coefficients()) {
    std::vector<std::string> names = words(facts.at("word"));
    if (names.empty() || !serves(facts, engine)) continue;
    names.push_back(facts.at("parameter"));
    if (std::find(names.begin(), names.end(), parameter) != names.end()) return facts;
    for (std::string& one : names)
      if (std::find(known.begin(), known.end(), one) == known.end()) known.push_back(std::move(one));
  }
  std::string expected;
  for (const std::string& one : known) expected += (expected.empty() ? "" : ", ") + one;
  throw std::invalid_argument(std::string(engine) + " has no parameter '" + std::string(parameter) +
                              "', expected one of " + expected + did_you_mean(parameter, {known.begin(), known.end()}));
}

/// The engine's name; throws also for its own spelling of a parameter, without the engine.
std::string engine_of(const EngineNumber& number) {
  const std::string own = number.engine + "." + number.parameter;
  for (const Facts& facts : all_coefficients()) {
    if (facts.at("parameter") == own)
      throw std::invalid_argument("'" + own + "' needs its engine before it, as in " +
                                  words(facts.at("engine")).front() + "." + own);
  }
  return find_engine(number.engine);
}

/// Whether a number limits the force.
bool is_friction(const Facts& coefficient) {
  const Formula* const formula = find_formula(coefficient.at("formula"));
  return formula != nullptr && formula->value == friction_of && coefficient.at("times").empty();
}

/// The numbers of one contact, by their rows.
using ContactNumbers = std::map<const Facts*, double>;

double friction_in(const ContactNumbers& contact, const Facts* factor, double otherwise) {
  if (factor != nullptr && is_friction(*factor) && contact.contains(factor)) return contact.at(factor);
  const auto found =
      std::find_if(contact.begin(), contact.end(), [](const auto& number) { return is_friction(*number.first); });
  return found == contact.end() ? otherwise : found->second;
}

CoefficientMeaning meaning_of(const std::string& engine, const Facts& row, double value, const ContactNumbers& contact,
                              double mu, double moment_ratio) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  CoefficientMeaning meaning{engine, row.at("parameter"), unknown, unknown, note_of(row, value)};
  const Formula* const formula = find_formula(row.at("formula"));
  if (formula == nullptr || formula->moment == nullptr || std::isnan(formula->moment(value, 1.0))) return meaning;
  const Facts* const times = row.at("times").empty() ? nullptr : &find_coefficient(meaning.engine, row.at("times"));
  const double friction = friction_in(contact, times, mu);
  double factor = friction;
  if (times != nullptr && !is_friction(*times)) {
    const bool is_given = contact.contains(times);
    factor = is_given ? contact.at(times) : parse_number(times->at("default")).value();
    if (!is_given) meaning.note += "; with " + row.at("times") + " " + times->at("default") + ", the default";
  }
  meaning.moment_per_load = formula->moment(value, factor);
  for (const std::string& need : words(row.at("needs"))) {
    const bool must_be_off = need.starts_with('!');
    const std::string name = need.substr(must_be_off ? 1 : 0);
    const Facts& needed = find_coefficient(meaning.engine, name);
    const std::string least = must_be_off ? "0" : needed.at("formula");  // of a switch: the number for on
    const auto given = contact.find(&needed);
    const double number = given != contact.end() ? given->second : parse_number(needed.at("default")).value();
    if (must_be_off ? number == 0.0 : number >= parse_number(least).value()) continue;
    // Without its own number a switch counts as on.
    const bool is_off = must_be_off || given != contact.end();
    if (is_off) meaning.moment_per_load = 0.0;
    meaning.note += (is_off ? "; needs " : "; if ") + name + " " + least;
    if (given == contact.end()) meaning.note += ": the default is " + needed.at("default");
  }
  if (meaning.moment_per_load == 0.0) {
    meaning.radius = 0.0;
    meaning.note += "; no moment";
    return meaning;
  }
  if (std::isnan(friction))
    throw std::invalid_argument("the radius of " + meaning.engine + "." + meaning.parameter +
                                " needs mu, or the engine's friction among the numbers");
  meaning.radius = meaning.moment_per_load / friction / moment_ratio;
  constexpr double smallest = 1e-3;
  constexpr double largest = 2e-2;
  if (!(meaning.radius >= smallest && meaning.radius <= largest))
    meaning.note += "; no fingertip: its contact radius is 3 to 10 mm";
  return meaning;
}

}  // namespace

std::vector<CoefficientMeaning> read_coefficients(std::span<const EngineNumber> numbers, double mu, const Law& law) {
  if (mu <= 0.0 || std::isinf(mu)) throw out_of_range("mu", mu, "1", "> 0 and finite");
  static_cast<void>(checked(law));
  std::vector<const Facts*> rows;
  std::vector<std::size_t> contact_of;  // of each number
  std::vector<ContactNumbers> contacts;
  std::map<std::string, std::size_t> latest;  // contact of each engine
  for (const EngineNumber& number : numbers) {
    const std::string engine = engine_of(number);
    const Facts& row = find_coefficient(engine, number.parameter);
    if (!(number.value >= 0.0) || std::isinf(number.value)) {
      throw out_of_range(engine + "." + number.parameter, number.value, row.at("unit"),
                         ">= 0 and finite; leave out a number that sets no limit");
    }
    if (!latest.contains(engine) || contacts[latest[engine]].contains(&row)) {
      latest[engine] = contacts.size();
      contacts.emplace_back();
    }
    contacts[latest[engine]][&row] = number.value;
    rows.push_back(&row);
    contact_of.push_back(latest[engine]);
  }
  std::vector<CoefficientMeaning> meanings;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    meanings.push_back(meaning_of(find_engine(numbers[i].engine), *rows[i], numbers[i].value, contacts[contact_of[i]],
                                  mu, law->moment_ratio()));
  }
  return meanings;
}

}  // namespace limitcurve::engines
