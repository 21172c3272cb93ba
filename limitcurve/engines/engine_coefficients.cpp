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
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace limitcurve::engines {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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
                     [&](const Facts& one) { return one.at("when") == "two" && serves(one, engine); });
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
    EngineContact contact{facts.at("engine"), model, {}, error.curve, error.wrench, error.over_loads, facts.at("link"),
                          facts.at("needs")};
    for (const Facts& coefficient : all_coefficients()) {
      if (!serves(coefficient, contact.engine)) continue;
      if (!coefficient.at("model").empty() && coefficient.at("model") != model) continue;
      if (!friction.has(coefficient)) continue;
      const std::string& text = coefficient.at("formula");
      const Formula* const formula = find_formula(text);
      const auto value = [&](double lever) {
        if (formula == nullptr) return parse_number(text).value();
        return formula->value(text == "mu_x" ? friction.x : text == "mu_y" ? friction.y : mu, lever);
      };
      const double here = value(levers.here);
      contact.coefficients.push_back({coefficient.at("parameter"), here, coefficient.at("unit"), text,
                                      coefficient.at("two_bodies"), note_of(coefficient, here), value(levers.least),
                                      value(levers.greatest)});
    }
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

/// Limits without a moment: the force alone, whatever the slip.
struct PointLimits {
  [[nodiscard]] static UnitWrench wrench(SlipTwist twist) { return {twist.slide > 0.0 ? 1.0 : 0.0, 0.0}; }
};

/// Largest distance between the wrenches of two curves at the same twist, in the normalised plane of the exact one:
/// over twists evenly spaced in the normalised slip angle, and beside the twists where box and diamond jump between
/// corners. A smooth maximum is found to 1e-6.
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

/// Errors of the shape `make(moment_max)`, in unit wrenches at the load of the translation. At another load the
/// engine's moment limit per newton is constant, while the contact's grows with a(P).
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

std::vector<EngineContact> translate(const Law& law, const RadiusLaw& radius_law, double mu, double load,
                                     LoadRange loads) {
  require("mu", mu, "1");
  require("load", load, "N");
  require("lowest load", loads.low, "N");
  if (!(loads.high >= loads.low) || std::isinf(loads.high))
    throw out_of_range("highest load", loads.high, "N", ">= the lowest and finite");

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
  auto contacts =
      contacts_of(own, {mu * mx, mu * my}, {lever, lever, lever}, [&](const std::string& model) -> ShapeError {
        const auto shape =
            std::find_if(shapes.begin(), shapes.end(), [&](const EngineShape& one) { return one.name == model; });
        if (shape == shapes.end()) throw std::logic_error("data/engines: unknown model " + model);
        return {shape->error, shape->max_wrench_error, shape->error.max_error};
      });
  const char* const build =
      "; for one contact point (a ball, a capsule across); several: no torsion (condim 3), geometry of radius m0 a";
  for (EngineContact& contact : contacts) {
    for (EngineCoefficient& one : contact.coefficients) {
      if (const Formula* const formula = find_formula(one.formula); formula != nullptr && formula->moment != nullptr)
        one.note += build;
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
  std::string engines;
  for (const std::string& one : known) engines += (engines.empty() ? "" : ", ") + one;
  throw std::invalid_argument("unknown engine '" + std::string(name) + "', expected one of " + engines +
                              did_you_mean(name, {known.begin(), known.end()}));
}

}  // namespace limitcurve::engines
