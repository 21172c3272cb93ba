// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/law_argument.hpp"
#include "cli/io/range.hpp"

#include "limitcurve/pressure_law.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace limitcurve::cli {

enum class Presence { optional, required };

/// Declares the options of a subcommand: each with the variable that takes its value. The parser's own header is slow to
/// compile and stays behind this one. A value that does not fit throws std::invalid_argument naming the option.
class Options {
 public:
  explicit Options(CLI::App& app) : app_(app) {}

  /// An option whose text `take` turns into a value, throwing std::invalid_argument if it cannot. `name` is "--law",
  /// "-o,--output", or without dashes a positional argument; `kind` is what help calls the value.
  void value(const std::string& name, const std::string& kind, std::function<void(const std::string&)> take, const std::string& help,
             Presence presence);
  /// The same for an option that may be given several times: `take` is called for each.
  void repeated(const std::string& name, const std::string& kind, std::function<void(const std::string&)> take, const std::string& help,
                Presence presence);
  void flag(const std::string& name, bool& value, const std::string& help);

  void text(const std::string& name, std::string& value, const std::string& kind, const std::string& help,
            Presence presence = Presence::optional);
  /// Help shows the value that stands in `value` as the default, if it is not NaN.
  void number(const std::string& name, double& value, Range range, const std::string& help, Presence presence = Presence::optional);
  void number(const std::string& name, std::optional<double>& value, Range range, const std::string& help);
  void numbers(const std::string& name, std::vector<double>& values, Range range, const std::string& help,
               Presence presence = Presence::required);
  void count(const std::string& name, std::size_t& value, std::size_t least, std::size_t most, const std::string& help);
  /// One of `choices`; `value` gets its index and shows the default.
  void choice(const std::string& name, std::size_t& value, std::vector<std::string> choices, const std::string& help,
              Presence presence = Presence::optional);

  void law(Law& value, Presence presence = Presence::required);
  void radius_law(std::optional<RadiusLawArgument>& value, Presence presence = Presence::required);

 private:
  CLI::App& app_;
};

}  // namespace limitcurve::cli
