// SPDX-License-Identifier: MIT
#include "limitcurve/engines/engine_coefficients.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/engines/engine_facts.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/patch/disc_models.hpp"
#include "limitcurve/patch/patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

namespace limitcurve::engines {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Facts = std::map<std::string, std::string, std::less<>>;  ///< a row's cells by their columns

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
    if (cells.size() != columns.size()) throw std::logic_error("data/engines: expected a cell a column: " + std::string(line));
    Facts& row = rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) row[columns[i]] = cells[i];
  }
  return rows;
}

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

/// A formula of coefficients.csv: the number that an engine wants for a friction μ and a lever m₀ a [m].
struct Formula {
  std::string_view text;
  double (*value)(double mu, double lever);
  double (*moment)(double value, double factor);  ///< over the load; `factor`: the parameter in column `times`. Null: it sets no moment
  std::string_view use;                           ///< what the engine makes of it; @: that parameter
};

double friction_of(double mu, double /*lever*/) {
  return mu;
}
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
    Formula{"m0 a", [](double /*mu*/, double lever) { return lever; }, [](double value, double factor) { return factor * value; },
            "times @ and load: the moment's limit"},
    Formula{"16 m0 a/(3 pi)", [](double /*mu*/, double lever) { return lever / hertz_ratio; },
            [](double value, double factor) { return hertz_ratio * factor * value; }, "times 3 pi/16 and @ and load: the moment's limit"},
    Formula{"sqrt(m0 a/pi)", [](double /*mu*/, double lever) { return std::sqrt(lever / std::numbers::pi); },
            [](double value, double factor) { return std::numbers::pi * value * value * factor; },
            "pi times its square and @ and load: the moment's limit"},
};

/// Null for a number.
const Formula* find_formula(std::string_view text) {
  const auto found = std::find_if(formulas.begin(), formulas.end(), [&](const Formula& one) { return one.text == text; });
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

void require(const char* name, double value, const char* unit) {
  if (!(value > 0.0) || std::isinf(value)) throw out_of_range(name, value, unit, "> 0 and finite");
}

/// Errors of a shape, as in EngineContact.
struct ShapeError {
  CurveError curve;
  double wrench = 0.0;
  double over_loads = 0.0;
};

/// Levers m₀ a(P) [m]: at the load of the translation, the smallest and the largest over the range of loads.
struct Levers {
  double here;
  double least;
  double greatest;
};

/// Coefficients of friction along x and y; rows of coefficients.csv `when` both are one, or two.
struct Friction {
  double x;
  double y;
  [[nodiscard]] bool has(const Facts& coefficient) const {
    const std::string& when = coefficient.at("when");
    return when.empty() || when == (x == y ? "one" : "two");  // not "read"
  }
};

bool takes_two(std::string_view engine) {
  return std::any_of(all_coefficients().begin(), all_coefficients().end(),
                     [&](const Facts& one) { return one.at("engine") == engine && one.at("when") == "two"; });
}

/// `levers` are largest moments over `mu` and the load.
std::vector<EngineContact> contacts_of(double mu, const Friction& friction, const Levers& levers,
                                       const std::function<ShapeError(const std::string&)>& error_of) {
  std::map<std::string, ShapeError> errors;  // of shapes that several engines have
  std::vector<EngineContact> contacts;
  for (const Facts& facts : all_engines()) {
    const std::string& model = facts.at("model");
    if (model == "field") continue;  // pressure on a mesh: no number chooses its moment
    if (friction.x != friction.y && !takes_two(facts.at("engine"))) continue;
    if (!errors.contains(model)) errors[model] = error_of(model);
    const ShapeError& error = errors[model];
    EngineContact contact{facts.at("engine"), model, {}, error.curve, error.wrench, error.over_loads, facts.at("link"), facts.at("needs")};
    for (const Facts& coefficient : all_coefficients()) {
      if (coefficient.at("engine") != contact.engine) continue;
      if (!coefficient.at("model").empty() && coefficient.at("model") != model) continue;
      if (!friction.has(coefficient)) continue;
      const std::string& text = coefficient.at("formula");
      const Formula* const formula = find_formula(text);
      const auto value = [&](double lever) {
        if (formula == nullptr) return parse_number(text).value();
        return formula->value(text == "mu_x" ? friction.x : text == "mu_y" ? friction.y : mu, lever);
      };
      contact.coefficients.push_back({coefficient.at("parameter"), value(levers.here), coefficient.at("unit"), text,
                                      coefficient.at("two_bodies"), note_of(coefficient), value(levers.least), value(levers.greatest)});
    }
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

/// Limits without a moment: the force alone, whatever the slip.
struct PointLimits {
  [[nodiscard]] static UnitWrench wrench(SlipTwist twist) { return {twist.slide > 0.0 ? 1.0 : 0.0, 0.0}; }
};

/// Largest distance between the wrenches of two curves at the same twist, in the normalised plane of the exact one: over twists evenly
/// spaced in the normalised slip angle, and beside the twists where box and diamond jump between corners. A smooth maximum is found to
/// 1e-6.
template <class Model>
double wrench_error(const Model& model, const ExactCurve& exact) {
  constexpr int steps = 4000;
  constexpr double quarter_turn = 1.5707963267948966;
  constexpr double beside = 1e-9;
  const auto error_at = [&](double angle) {
    const SlipTwist twist{std::sin(angle), std::cos(angle) / exact.moment_ratio()};
    const UnitWrench a = model.wrench(twist);
    const UnitWrench b = exact.wrench(twist);
    return std::hypot(a.force - b.force, (a.moment - b.moment) / exact.moment_ratio());
  };
  double largest = 0.0;
  for (const double angle : {beside, 0.5 * quarter_turn - beside, 0.5 * quarter_turn + beside, quarter_turn - beside}) {
    largest = std::max(largest, error_at(angle));
  }
  for (int i = 0; i < steps; ++i) largest = std::max(largest, error_at(quarter_turn * (i + 0.5) / steps));
  return largest;
}

/// Errors of the shape `make(moment_max)`, in unit wrenches at the load of the translation. At another load the engine's moment limit per
/// newton is constant, while the contact's grows with a(P).
template <class MakeModel>
ShapeError errors_of(const ExactCurve& exact, const Levers& levers, MakeModel make) {
  ShapeError error{curve_error(make(exact.moment_ratio()), exact), wrench_error(make(exact.moment_ratio()), exact)};
  error.over_loads = error.curve.max_error;
  for (const double lever : {levers.least, levers.greatest}) {
    if (lever == levers.here) continue;
    const double moment_max = exact.moment_ratio() * (levers.here / lever);
    error.over_loads = std::max(error.over_loads, curve_error(make(moment_max), exact).max_error);
  }
  return error;
}

/// A shape that bears no moment misses all of the exact one's.
CurveError no_moment() {
  CurveError error;
  error.max_error = error.max_under_estimate = 1.0;
  error.max_cor_error = std::numeric_limits<double>::infinity();
  return error;
}

}  // namespace

std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load, LoadRange loads) {
  require("mu", mu, "1");
  require("load", load, "N");
  require("lowest load", loads.low, "N");
  if (!(loads.high >= loads.low) || std::isinf(loads.high)) throw out_of_range("highest load", loads.high, "N", ">= the lowest and finite");

  const ExactCurve exact(law);
  Levers levers{exact.moment_ratio() * radius_law.radius(load), std::numeric_limits<double>::infinity(), 0.0};
  // The error depends on the largest change of the radius; a measured law need not be monotone.
  constexpr int steps = 1024;
  for (int i = 0; i <= steps; ++i) {
    const double other = loads.low * std::pow(loads.high / loads.low, static_cast<double>(i) / steps);
    const double lever = exact.moment_ratio() * radius_law.radius(other);
    levers.least = std::min(levers.least, lever);
    levers.greatest = std::max(levers.greatest, lever);
  }
  return contacts_of(mu, {mu, mu}, levers, [&](const std::string& model) -> ShapeError {
    if (model == "ellipse") return errors_of(exact, levers, [](double moment_max) { return Ellipse(1.0, moment_max); });
    if (model == "diamond") return errors_of(exact, levers, [](double moment_max) { return diamond(1.0, moment_max); });
    if (model == "box") return errors_of(exact, levers, [](double moment_max) { return box(1.0, moment_max); });
    if (model == "point") return {no_moment(), wrench_error(PointLimits(), exact), 1.0};
    throw std::logic_error("data/engines: unknown model " + model);
  });
}

std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load) {
  return translate(law, radius_law, mu, load, {0.25 * load, 4.0 * load});
}

std::vector<EngineContact> translate(const Patch& patch, double mu) {
  require("mu", mu, "1");
  const std::vector<EngineShape> shapes = engine_shapes(patch);
  const auto [mx, my] = patch.factors();
  const double own = mx == my ? mu * mx : mu;  // the factor of all directions is one of the coefficient
  const double lever = mu * patch.moment_ratio() / own;
  auto contacts = contacts_of(own, {mu * mx, mu * my}, {lever, lever, lever}, [&](const std::string& model) -> ShapeError {
    const auto shape = std::find_if(shapes.begin(), shapes.end(), [&](const EngineShape& one) { return one.name == model; });
    if (shape == shapes.end()) throw std::logic_error("data/engines: unknown model " + model);
    return {shape->error, shape->max_wrench_error, shape->error.max_error};
  });
  const char* const build = "; for one contact point (a ball, a capsule across); several: no torsion (condim 3), geometry of radius m0 a";
  for (EngineContact& contact : contacts) {
    for (EngineCoefficient& one : contact.coefficients) {
      if (const Formula* const formula = find_formula(one.formula); formula != nullptr && formula->moment != nullptr) one.note += build;
    }
  }
  return contacts;
}

std::vector<std::string> engines_of_one_friction() {
  std::vector<std::string> names;
  for (const Facts& facts : all_engines()) {
    const std::string& engine = facts.at("engine");
    if (!takes_two(engine) && std::find(names.begin(), names.end(), engine) == names.end()) names.push_back(engine);
  }
  return names;
}

std::string find_engine(std::string_view name) {
  std::vector<std::string> known;
  for (const Facts& facts : all_engines()) {
    const std::string& engine = facts.at("engine");
    const std::vector<std::string> also = words(facts.at("also"));
    if (engine == name || std::find(also.begin(), also.end(), name) != also.end()) return engine;
    if (std::find(known.begin(), known.end(), engine) == known.end()) known.push_back(engine);
    known.insert(known.end(), also.begin(), also.end());
  }
  std::string expected;
  for (const std::string& one : known) expected += " " + one;
  throw std::invalid_argument("unknown engine '" + std::string(name) + "', expected one of" + expected +
                              did_you_mean(name, {known.begin(), known.end()}));
}

namespace {

/// The row of an engine's parameter, by any of its names.
const Facts& find_coefficient(std::string_view engine, std::string_view parameter) {
  std::vector<std::string> known;
  for (const Facts& facts : all_coefficients()) {
    if (facts.at("engine") != engine) continue;
    const std::vector<std::string> names = words(facts.at("word"));
    if (parameter == facts.at("parameter") || std::find(names.begin(), names.end(), parameter) != names.end()) return facts;
    if (std::find(known.begin(), known.end(), names.front()) == known.end()) known.push_back(names.front());
  }
  std::string expected;
  for (const std::string& one : known) expected += " " + one;
  throw std::invalid_argument(std::string(engine) + " has no parameter '" + std::string(parameter) + "', expected one of" + expected +
                              " or the engine's own name" + did_you_mean(parameter, {known.begin(), known.end()}));
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
  const auto found = std::find_if(contact.begin(), contact.end(), [](const auto& number) { return is_friction(*number.first); });
  return found == contact.end() ? otherwise : found->second;
}

CoefficientMeaning meaning_of(const Facts& row, double value, const ContactNumbers& contact, double mu, double moment_ratio) {
  CoefficientMeaning meaning{row.at("engine"), row.at("parameter"), nan, nan, note_of(row)};
  const Formula* const formula = find_formula(row.at("formula"));
  if (formula == nullptr || formula->moment == nullptr) return meaning;
  const auto other = [&](const char* column) {
    return row.at(column).empty() ? nullptr : &find_coefficient(meaning.engine, row.at(column));
  };
  const Facts* const times = other("times");
  const double friction = friction_in(contact, times, mu);
  double factor = friction;
  if (times != nullptr && !is_friction(*times)) {
    const bool is_given = contact.contains(times);
    factor = is_given ? contact.at(times) : parse_number(times->at("default")).value();
    if (!is_given) meaning.note += "; with " + row.at("times") + " " + times->at("default") + ", the default";
  }
  meaning.moment_per_load = formula->moment(value, factor);
  if (const Facts* const needed = other("needs"); needed != nullptr) {  // a switch: its formula is the number that turns it on
    const double least = parse_number(needed->at("formula")).value();
    const std::string condition = row.at("needs") + " " + needed->at("formula");
    if (contact.contains(needed)) {
      if (contact.at(needed) < least) meaning.moment_per_load = 0.0, meaning.note += "; needs " + condition;
    } else if (parse_number(needed->at("default")).value() < least) {
      meaning.note += "; if " + condition + ": the default is " + needed->at("default");
    }
  }
  if (meaning.moment_per_load == 0.0) {
    meaning.radius = 0.0;
    meaning.note += "; no moment";
    return meaning;
  }
  if (std::isnan(friction))
    throw std::invalid_argument(meaning.engine + "." + meaning.parameter + ": expected mu, or the friction beside it");
  meaning.radius = meaning.moment_per_load / friction / moment_ratio;
  constexpr double smallest = 1e-3;
  constexpr double largest = 2e-2;
  if (!(meaning.radius >= smallest && meaning.radius <= largest)) meaning.note += "; no fingertip: its contact radius is 3 to 10 mm";
  return meaning;
}

}  // namespace

std::vector<CoefficientMeaning> read_coefficients(std::span<const EngineNumber> numbers, double mu, const Law& law) {
  if (!std::isnan(mu)) require("mu", mu, "1");
  std::vector<const Facts*> rows;
  std::vector<std::size_t> contact_of;  // of each number
  std::vector<ContactNumbers> contacts;
  std::map<std::string, std::size_t> latest;  // contact of each engine
  for (const EngineNumber& number : numbers) {
    const std::string engine = find_engine(number.engine);
    const Facts& row = find_coefficient(engine, number.parameter);
    if (!(number.value >= 0.0) || std::isinf(number.value)) {
      throw out_of_range(engine + "." + number.parameter, number.value, row.at("unit"), ">= 0 and finite");
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
    meanings.push_back(meaning_of(*rows[i], numbers[i].value, contacts[contact_of[i]], mu, law->moment_ratio()));
  }
  return meanings;
}

}  // namespace limitcurve::engines
