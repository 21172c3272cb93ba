// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include "cli/commands/subcommands.hpp"

#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/version.hpp"

// The only place that includes it: it takes seconds to compile.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace limitcurve::cli {

namespace {

/// The help of a subcommand: required options, an example, the other options, notes.
class Help final : public CLI::Formatter {
 public:
  static constexpr const char* required = "Required";

  explicit Help(std::string example) : example_(std::move(example)) { label("REQUIRED", ""); }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return CLI::Formatter::make_help(app, std::move(name), mode);
    const auto group = [&](const std::string& title) {
      const auto options = app->get_options(
          [&](const CLI::Option* option) { return option->get_group() == title && option->nonpositional(); });
      return options.empty() ? std::string() : make_group(title, false, options);
    };
    std::string text =
        make_description(app) + make_usage(app, std::move(name)) + make_positionals(app) + group(required);
    if (!example_.empty()) text += "\nExample:\n  " + example_ + "\n";
    return text + group("Options") + group("Rare options") + make_subcommands(app, mode) + "\n" + make_footer(app);
  }

 private:
  std::string example_;
};

CLI::Option* add_option(CLI::App& app, const std::string& name, const std::string& kind,
                        std::function<void(const std::string&)> take, const std::string& help, Presence presence) {
  const auto take_each = [name, take = std::move(take)](const CLI::results_t& texts) {
    try {
      for (const std::string& text : texts) take(text);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(name + ": " + error.what());
    }
    return true;
  };
  CLI::Option* const option = app.add_option(name, take_each, help)->type_name(kind);
  if (presence == Presence::required) option->required()->group(Help::required);
  return option;
}

struct Entry {
  std::unique_ptr<Subcommand> subcommand;
  std::string group;
  CLI::App* app = nullptr;
  std::optional<Format> format = {};
  bool quiet = false;
};

/// The subcommands in groups, in the order of --help.
std::vector<Entry> make_entries() {
  using Make = std::unique_ptr<Subcommand> (*)();
  const std::initializer_list<std::pair<const char*, std::vector<Make>>> groups{
      {"Questions",
       {
           make_hold,
           make_translate,
           make_validate,
           make_choose,
#ifdef LIMITCURVE_HAS_FIT
           make_fit,
#endif
       }},
      {"Curves and tables",
       {make_laws, make_eval, make_curve, make_p_curves, make_c_curves, make_table, make_lookup, make_patch}},
      {"Simulations", {make_replay, make_pivot}}};
  std::vector<Entry> entries;
  for (const auto& [group, makes] : groups) {
    for (const Make make : makes) entries.push_back({make(), group});
  }
  return entries;
}

void declare(CLI::App& whole, Entry& entry, bool all) {
  const Manual manual = entry.subcommand->manual();
  entry.app = whole.add_subcommand(manual.name, manual.purpose)->group(entry.group);
  entry.app->formatter(std::make_shared<Help>(manual.example));
  entry.app->footer(manual.notes);
  Options options(*entry.app, all);
  entry.subcommand->declare(options);
  Options common(*entry.app, all);
  common.value(
      "--format", "table|csv|json",
      [&entry](const std::string& text) {
        constexpr std::array<std::string_view, 3> names{"table", "csv", "json"};
        const auto found = std::find(names.begin(), names.end(), text);
        if (found == names.end()) throw std::invalid_argument("got '" + text + "', expected table, csv or json");
        entry.format = static_cast<Format>(found - names.begin());
      },
      "Output format (default: table on a terminal, otherwise csv)", Presence::optional);
  common.flag("--quiet", entry.quiet, "Print errors only, no notes or warnings");
  entry.app->set_help_flag("-h,--help",
                           options.has_rare() ? "Show this help; --help-all adds rare options" : "Show this help");
}

void check_subcommand(const std::string& name, const std::vector<Entry>& entries) {
  std::string all;
  std::vector<std::string_view> known{"--help", "--version"};
  for (const Entry& entry : entries) {
    if (entry.app->get_name() == name) return;
    all.append(all.empty() ? "; there are " : ", ").append(entry.app->get_name());
    known.push_back(entry.app->get_name());
  }
  if (name == "fit")
    throw std::invalid_argument("this limitcurve was built without Ceres and has no 'fit': install Ceres and rebuild");
  if (name == "lint") throw std::invalid_argument("'lint' is in the Python package: python -m limitcurve.lint FILE");
  throw std::invalid_argument("no subcommand" + (name.empty() ? "" : " '" + name + "'") + did_you_mean(name, known) +
                              all);
}

/// Names the first argument that looks like an option and is none of the subcommand's; "" if there is none.
std::string unknown_option(const std::vector<std::string>& arguments, const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    if (entry.app->get_name() != arguments[0]) continue;
    for (const CLI::Option* const option : entry.app->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  }
  const auto word = [](const std::string& argument) { return argument.substr(0, argument.find('=')); };
  const auto unknown = std::find_if(arguments.begin(), arguments.end(), [&](const std::string& argument) {
    return argument.starts_with("--") && std::find(names.begin(), names.end(), word(argument)) == names.end();
  });
  if (unknown == arguments.end()) return "";
  return arguments[0] + " has no option '" + word(*unknown) + "'" +
         did_you_mean(word(*unknown), {names.begin(), names.end()});
}

/// "--mu, --stiffness are required" of the subcommand that was parsed; empty if nothing is missing.
std::string missing_options(const std::vector<Entry>& entries) {
  std::string names;
  std::size_t count = 0;
  for (const Entry& entry : entries) {
    if (!entry.app->parsed()) continue;
    for (const CLI::Option* const option : entry.app->get_options()) {
      if (!option->get_required() || option->count() > 0) continue;
      names += (names.empty() ? "" : ", ") + option->get_name();
      ++count;
    }
  }
  return names.empty() ? names : names + (count == 1 ? " is required" : " are required");
}

/// The complaint of a library's parameter; by the name of its option if the user gave that.
std::string as_typed(const std::string& complaint, const std::vector<std::string>& given) {
  const std::size_t end = std::min({complaint.find(": "), complaint.find(" = "), complaint.size()});
  std::string option = "--" + complaint.substr(0, end);
  std::replace(option.begin(), option.end(), '_', '-');
  const bool is_given = std::find(given.begin(), given.end(), option) != given.end();
  return is_given ? option + complaint.substr(end) : complaint;
}

}  // namespace

void Options::value(const std::string& name, const std::string& kind, std::function<void(const std::string&)> take,
                    const std::string& help, Presence presence) {
  CLI::Option* const option = add_option(app_, name, kind, std::move(take), help, presence)->expected(1);
  if (is_rare_) option->group(all_ ? "Rare options" : "");
}

void Options::repeated(const std::string& name, const std::string& kind, std::function<void(const std::string&)> take,
                       const std::string& help, Presence presence) {
  add_option(app_, name, kind, std::move(take), help, presence)
      ->expected(1, CLI::detail::expected_max_vector_size)
      ->allow_extra_args(false);
}

void Options::flag(const std::string& name, bool& value, const std::string& help) {
  app_.add_flag(name, value, help);
}

void run_command_line(std::vector<std::string> arguments, Results results) {
  CLI::App app(
      "Friction limit curves of soft fingers, exact, tabulated or approximated, and a soft finger for a servo loop.",
      "limitcurve");
  app.formatter(std::make_shared<Help>(""));
  app.set_help_flag("-h,--help", "Show this help");
  app.set_version_flag("-V,--version", "limitcurve " + std::string(version), "The version");
  app.require_subcommand(1);
  app.footer(
      "Results go to standard output, as a table on a terminal and as CSV elsewhere. Messages go to standard error.\n"
      "Exit status: 0 success, 1 the job failed, 2 wrong usage or bad input.\n"
      "limitcurve help SUBCOMMAND shows its options and an example.");
  // "help", "help SUBCOMMAND" and --help-all are ways to ask for --help.
  if (!arguments.empty() && arguments[0] == "help")
    arguments = {arguments.size() > 1 ? arguments[1] : "--help", "--help"};
  const auto all = std::find(arguments.begin(), arguments.end(), "--help-all");
  const bool shows_all = all != arguments.end();
  if (shows_all) *all = "--help";
  std::vector<Entry> entries = make_entries();
  for (Entry& entry : entries) declare(app, entry, shows_all);
  if (arguments.empty()) throw NoSubcommand(app.help());
  const std::string name = arguments[0];
  if (name != "-h" && name != "--help" && name != "--version" && name != "-V") check_subcommand(name, entries);
  const std::string see = " (see 'limitcurve help " + name + "')";
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    results.output.write(app.help());
    return results.output.flush();
  } catch (const CLI::CallForVersion& version) {
    results.output.write(std::string(version.what()) + "\n");
    return results.output.flush();
  } catch (const CLI::ExtrasError&) {
    const std::string unknown = unknown_option(arguments, entries);
    throw std::invalid_argument(
        (unknown.empty() ? name + " takes no argument '" + app.remaining(true).front() + "'" : unknown) + see);
  } catch (const CLI::ParseError& error) {
    const std::string missing = missing_options(entries);
    const std::string unknown = unknown_option(arguments, entries);
    throw std::invalid_argument((missing.empty() ? std::string(error.what()) : missing) +
                                (unknown.empty() ? "" : "; " + unknown) + see);
  }
  for (const Entry& entry : entries) {
    if (!entry.app->parsed()) continue;
    results.format = entry.format.value_or(results.format);
    for (const CLI::Option* const option : entry.app->get_options()) {
      if (option->count() == 0) continue;
      for (const std::string& long_name : option->get_lnames()) results.given.push_back("--" + long_name);
    }
    Messages own(Messages::Kind::notes);
    if (results.messages == nullptr) results.messages = &own;
    if (entry.quiet) results.messages->silence();
    results.messages->start(entry.app->get_name());
    try {
      entry.subcommand->run(results);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(as_typed(error.what(), results.given));
    }
  }
}

}  // namespace limitcurve::cli
