// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace limitcurve::engines {

/// data/engines/engines.csv and coefficients.csv: the facts about engines, of which this is the only home.
extern const std::string_view engines_csv;
extern const std::string_view coefficients_csv;

using Facts = std::map<std::string, std::string, std::less<>>;  ///< a row's cells by their columns

/// The rows of both files.
const std::vector<Facts>& all_engines();
const std::vector<Facts>& all_coefficients();
/// Whether a row of coefficients.csv is of an engine, perhaps among others.
bool serves(const Facts& coefficient, std::string_view engine);
std::vector<std::string> words(std::string_view text);

/// A formula of coefficients.csv: the number that an engine wants for a friction μ and a lever m₀ a [m].
struct Formula {
  std::string_view text;
  double (*value)(double mu, double lever);
  /// Largest moment over the load of a number; `factor` is the parameter in column `times`. NaN if that number sets
  /// no moment; null if none does.
  double (*moment)(double value, double factor);
  std::string_view use;  ///< what the engine makes of it; @: that parameter
};

/// The value of a coefficient of friction.
double friction_of(double mu, double lever);
/// Null for a number.
const Formula* find_formula(std::string_view text);
/// How the engine uses a coefficient of this value.
std::string note_of(const Facts& coefficient, double value);

}  // namespace limitcurve::engines
