// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include "cli/commands/subcommands.hpp"

#include "limitcurve/internal/did_you_mean.hpp"
#include "limitcurve/version.hpp"

// The only place that includes it: it takes seconds to compile.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace limitcurve::cli {

namespace {

CLI::Option* add_option(CLI::App& app, const std::string& name, const std::string& kind, std::function<void(const std::string&)> take,
                        const std::string& help, Presence presence) {
  const auto take_each = [name, take = std::move(take)](const CLI::results_t& texts) {
    try {
      for (const std::string& text : texts) take(text);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(name + ": " + error.what());
    }
    return true;
  };
  return app.add_option(name, take_each, help)->type_name(kind)->required(presence == Presence::required);
}

struct Entry {
  std::unique_ptr<Subcommand> subcommand;
  CLI::App* app = nullptr;
  Format format = Format::csv;
  bool quiet = false;
};

std::vector<Entry> make_entries() {
  std::vector<Entry> entries;
  for (const auto make :
       {make_laws, make_eval, make_curve, make_p_curves, make_c_curves, make_table, make_lookup, make_validate, make_choose,
#ifdef LIMITCURVE_HAS_FIT
        make_fit, make_translate,
#endif
        make_replay, make_pivot, make_hold, make_patch
#ifdef LIMITCURVE_HAS_REPORT
        ,
        make_report
#endif
       })
    entries.push_back({make()});
  return entries;
}

void declare(CLI::App& whole, Entry& entry) {
  const Manual manual = entry.subcommand->manual();
  entry.app = whole.add_subcommand(manual.name, manual.purpose);
  entry.app->footer(manual.notes + (manual.notes.empty() ? "" : "\n\n") + "Example:\n  " + manual.example);
  Options options(*entry.app);
  entry.subcommand->declare(options);
  options.value(
      "--format", "csv|json",
      [&entry](const std::string& text) {
        if (text != "csv" && text != "json") throw std::invalid_argument("got '" + text + "', expected csv or json");
        entry.format = text == "json" ? Format::json : Format::csv;
      },
      "Form of the results (default csv)", Presence::optional);
  options.flag("--quiet", entry.quiet, "Write nothing but errors to standard error");
}

void check_subcommand(const std::string& name, const std::vector<Entry>& entries) {
  std::string expected;
  std::vector<std::string_view> known{"--help", "--version"};
  for (const Entry& entry : entries) {
    if (entry.app->get_name() == name) return;
    expected += ' ' + entry.app->get_name();
    known.push_back(entry.app->get_name());
  }
  if (name == "fit" || name == "translate" || name == "report") {
    throw std::invalid_argument("subcommand '" + name +
                                "' is not in this executable (it needs Ceres, and the report another system than Windows), " +
                                "expected one of" + expected);
  }
  throw std::invalid_argument((name.empty() ? "no subcommand" : "unknown subcommand '" + name + "'") + ", expected one of" + expected +
                              did_you_mean(name, known));
}

/// What to say of the first argument that looks like an option and is none of the subcommand's; empty if nothing helps.
std::string option_meant(const std::vector<std::string>& arguments, const std::vector<Entry>& entries) {
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
  const std::string meant = did_you_mean(word(*unknown), {names.begin(), names.end()});
  return meant.empty() ? "" : "; '" + word(*unknown) + "' is none of its options" + meant;
}

}  // namespace

void Options::value(const std::string& name, const std::string& kind, std::function<void(const std::string&)> take, const std::string& help,
                    Presence presence) {
  add_option(app_, name, kind, std::move(take), help, presence)->expected(1);
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
  CLI::App app("Friction limit curves of soft fingers: exact, tabulated, approximated, and driving a god-object.", "limitcurve");
  app.set_version_flag("--version", "limitcurve " + std::string(version));
  app.require_subcommand(1);
  app.footer(
      "Results go to standard output as CSV (or JSON), messages to standard error.\n"
      "Exit status: 0 success, 1 the job failed, 2 wrong usage or bad input.\n"
      "limitcurve SUBCOMMAND --help shows its options and an example.");
  std::vector<Entry> entries = make_entries();
  for (Entry& entry : entries) declare(app, entry);
  const std::string name = arguments.empty() ? "" : arguments[0];
  if (name != "-h" && name != "--help" && name != "--version") check_subcommand(name, entries);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::CallForHelp&) {
    results.output.write(app.help());
    return results.output.flush();
  } catch (const CLI::CallForVersion& version) {
    results.output.write(std::string(version.what()) + "\n");
    return results.output.flush();
  } catch (const CLI::ExtrasError&) {
    std::string unknown;  // as they were typed: the error has them from the last
    for (const std::string& argument : app.remaining(true)) unknown += ' ' + argument;
    throw std::invalid_argument("these arguments were not expected:" + unknown + " (expected usage: limitcurve " + name + " --help)" +
                                option_meant(arguments, entries));
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(std::string(error.what()) + " (expected usage: limitcurve " + name + " --help)" +
                                option_meant(arguments, entries));
  }
  for (const Entry& entry : entries) {
    if (!entry.app->parsed()) continue;
    results.format = entry.format;
    Messages own(Messages::Kind::notes);
    if (results.messages == nullptr) results.messages = &own;
    if (entry.quiet) results.messages->silence();
    results.messages->start(entry.app->get_name());
    entry.subcommand->run(results);
  }
}

}  // namespace limitcurve::cli
