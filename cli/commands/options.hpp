// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/csv_reader.hpp"
#include "cli/io/law_argument.hpp"
#include "limitcurve/internal/range.hpp"

#include "godobject/finger.hpp"
#include "godobject/finger_curve.hpp"
#include "limitcurve/internal/names.hpp"
#include "limitcurve/pressure_law.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace CLI {
class App;
}

namespace limitcurve::cli {

using namespace ranges;

enum class Presence { optional, required };

/// Declares the options of a subcommand, each with the variable that receives its value. This class hides the parser's
/// header, which is slow to compile. A value out of range throws std::invalid_argument that names the option.
class Options {
 public:
  /// `all`: help shows the rare options, too.
  Options(CLI::App& app, bool all) : app_(app), all_(all) {}

  /// What is declared from here on is rare: help shows it under --help-all alone.
  void rare() { is_rare_ = true; }
  [[nodiscard]] bool has_rare() const { return is_rare_; }

  /// An option whose text goes to `take`, which throws std::invalid_argument if it is no value. `name` is "--law",
  /// "-o,--output", or, without dashes, a positional argument; `kind` names the value in the help text.
  void value(const std::string& name, const std::string& kind, std::function<void(const std::string&)> take,
             const std::string& help, Presence presence);
  /// The same for an option that may be given several times: calls `take` for each.
  void repeated(const std::string& name, const std::string& kind, std::function<void(const std::string&)> take,
                const std::string& help, Presence presence);
  void flag(const std::string& name, bool& value, const std::string& help);

  void text(const std::string& name, std::string& value, const std::string& kind, const std::string& help,
            Presence presence = Presence::optional);
  /// Help shows the present `value` as the default, unless it is NaN.
  void number(const std::string& name, double& value, Range range, const std::string& help,
              Presence presence = Presence::optional);
  void number(const std::string& name, std::optional<double>& value, Range range, const std::string& help);
  void numbers(const std::string& name, std::vector<double>& values, Range range, const std::string& help,
               Presence presence = Presence::required);
  /// --columns and --units of a file of measurements.
  void file_columns(FileColumns& columns);
  /// --least-load and --zero, for data with a load.
  void least_load(FileColumns& columns);
  void count(const std::string& name, std::size_t& value, std::size_t least, std::size_t most, const std::string& help);
  void count(const std::string& name, std::optional<std::size_t>& value, std::size_t least, std::size_t most,
             const std::string& help);
  /// One of an enumeration's `names`, which help lists at "{}" of its text, and marks the present `value` as the
  /// default unless it is an optional one.
  template <class Value, class Kind>
  void named(const std::string& name, Value& value, std::span<const std::string_view> names,
             Kind (*parse)(std::string_view), const std::string& help) {
    std::size_t standard = names.size();
    if constexpr (std::is_same_v<Value, Kind>) standard = static_cast<std::size_t>(value);
    this->value(
        name, value_name(name), [&value, parse](const std::string& text) { value = parse(text); },
        listed(help, names, standard), Presence::optional);
  }
  /// One of an enumeration, whose `names` are in its order from 0 on; `value` holds the default.
  template <class Kind>
  void choice(const std::string& name, Kind& value, std::span<const std::string_view> names, const std::string& help,
              Presence presence = Presence::optional) {
    choice(
        name, static_cast<std::size_t>(value), [&value](std::size_t index) { value = static_cast<Kind>(index); }, names,
        help, presence);
  }

  /// The finger parameters (godobject/finger/finger_parameter_table.hpp), of which `required` must be given, and only
  /// `rare` ones or only the others.
  void finger(godobject::FingerParameters& value, const std::vector<std::string_view>& required, bool rare);
  void law(Law& value, Presence presence = Presence::required);
  void radius_law(std::optional<RadiusLawArgument>& value);
  /// --radius-law, and --mu-r with --gamma in its place.
  void moment(MomentArgument& value);

 private:
  /// "CURVE" of "--curve"; "" of a positional argument, which has its own name.
  static std::string value_name(std::string name);
  static std::string listed(const std::string& help, std::span<const std::string_view> names, std::size_t standard);
  void choice(const std::string& name, std::size_t standard, const std::function<void(std::size_t)>& take,
              std::span<const std::string_view> names, const std::string& help, Presence presence);
  void whole(const std::string& name, const std::function<void(std::size_t)>& take, std::size_t least, std::size_t most,
             const std::string& help);

  CLI::App& app_;
  bool all_;
  bool is_rare_ = false;
};

/// The law; any one where none is needed: the limits of an ellipse or a box with mu_r do not depend on it.
Law law_if_needed(const Law& law, godobject::CurveKind kind, bool has_mu_r);

}  // namespace limitcurve::cli
