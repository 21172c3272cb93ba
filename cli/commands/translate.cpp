// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/column_list.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/engines/engine_coefficients.hpp"
#include "limitcurve/internal/number.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace limitcurve::cli {

namespace {

/// An empty cell instead of NaN.
std::optional<double> if_any(double number) {
  return std::isnan(number) ? std::nullopt : std::optional(number);
}

struct Translated {
  engines::EngineContact contact;
  engines::EngineCoefficient coefficient;
  double mu;
};

using engines::EngineCoefficient;
using engines::EngineContact;

constexpr std::array coefficient_columns = std::to_array<ListedColumn<Translated>>({
    {"engine", of<&Translated::contact, &EngineContact::engine>, "its name"},
    {"parameter", of<&Translated::coefficient, &EngineCoefficient::parameter>, "in the engine's spelling"},
    {"value", of<&Translated::coefficient, &EngineCoefficient::value>, "the number to set"},
    {"unit", of<&Translated::coefficient, &EngineCoefficient::unit>, "of the value"},
    {"model", of<&Translated::contact, &EngineContact::model>,
     "ellipse, diamond, box, or point, which carries no moment"},
    {"max_error", of<&Translated::contact, &EngineContact::error, &CurveError::max_error>,
     "its largest radial error against the exact curve (0.07 is 7 %)"},
    {"cor_error", of<&Translated::contact, &EngineContact::max_wrench_error>,
     "its largest error of the wrench about one centre of rotation, as a fraction of the limits"},
    {"loads_error", of<&Translated::contact, &EngineContact::max_error_over_loads>,
     "its largest radial error over --loads, because the value is constant"},
    {"note", of<&Translated::coefficient, &EngineCoefficient::note>,
     "what the engine multiplies the value by, and how it calls the value"},
    {"formula", of<&Translated::coefficient, &EngineCoefficient::formula>,
     "from mu, a, m0 (see 'limitcurve laws'), mu_r = mu m0 a, and f, the other body's friction, taken as 1"},
    {"two_bodies", of<&Translated::coefficient, &EngineCoefficient::two_bodies>,
     "how the engine combines the values of two bodies"},
});
// In a table, or of one engine, the errors are rows, and the note says how two bodies' values combine.
constexpr std::array narrow_columns = std::to_array<ListedColumn<Translated>>(
    {coefficient_columns[0], coefficient_columns[1], coefficient_columns[2], coefficient_columns[3],
     coefficient_columns[4], coefficient_columns[8], coefficient_columns[9]});
constexpr std::array load_columns = std::to_array<ListedColumn<Translated>>({
    {"low", of<&Translated::coefficient, &EngineCoefficient::low>},
    {"high", of<&Translated::coefficient, &EngineCoefficient::high>,
     "with --loads: the range of the value, for domain randomisation"},
});
constexpr std::array friction_columns = std::to_array<ListedColumn<Translated>>({
    {"mu", of<&Translated::mu>, "with several values of --mu"},
});

struct Meant {
  engines::CoefficientMeaning meaning;
  double value;
};

constexpr std::array meaning_columns = std::to_array<ListedColumn<Meant>>({
    {"engine", of<&Meant::meaning, &engines::CoefficientMeaning::engine>},
    {"parameter", of<&Meant::meaning, &engines::CoefficientMeaning::parameter>},
    {"value", of<&Meant::value>, "the number in the scene"},
    {"moment_per_load", [](const Meant& row) -> Cell { return if_any(row.meaning.moment_per_load); },
     "[m], the largest moment over the load, empty if the number sets none"},
    {"radius", [](const Meant& row) -> Cell { return if_any(row.meaning.radius); },
     "[m], the contact radius that has this moment under --law"},
    {"note", of<&Meant::meaning, &engines::CoefficientMeaning::note>, "also lists the defaults assumed"},
});

class Translate final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "translate",
        "Find coefficients for physics engines, with the error that remains, or the meaning of a coefficient",
        "Give --mu, --load, and --law with --radius-law or --mu-r; or --mu and --patch. The engine then has the exact "
        "limits of force\nand moment at --load; between the limits it follows its model.\n" +
            ColumnList(coefficient_columns).add(load_columns).add(friction_columns).help() +
            R"(With --engine, and in a table, the errors are rows, and the note says how two bodies' values combine.
Draw mu and mu_r together, because mu_r is proportional to mu.
With --read, give --law, and --mu unless the engine's friction is among the numbers. PARAMETER is the engine's name or
a short one: friction, torsional, patch_radius, ... VALUE may be a whole attribute: 'mujoco.friction=1 0.005 0.0001'.
Numbers of one engine describe one contact; a parameter that comes again begins the next.
)" + ColumnList(meaning_columns).help(),
        "limitcurve translate --law hertz --radius-law power:c=0.00207,gamma=0.259 --mu 0.8 --load 2"};
  }

  void declare(Options& options) override {
    options.law(law_, Presence::optional);
    options.moment(moment_);
    options.text("--patch", patch_, "PATCH",
                 "A contact that is not round, instead of --law, --radius-law and --load (see 'limitcurve patch')");
    options.numbers("--mu", frictions_, positive, "Friction coefficient mu [1], or several: 0.4,1.2",
                    Presence::optional);
    options.number("--load", load_, positive, "Normal load P [N] at which the engine gets the exact limits");
    options.numbers("--loads", loads_, positive,
                    "Range LOW,HIGH of loads [N] for loads_error (default: --load/4 to 4 times --load)",
                    Presence::optional);
    options.value(
        "--engine", "ENGINE", [this](const std::string& text) { engine_ = engines::find_engine(text); },
        "Only this engine: mujoco, newton, genesis, physx, isaac, sapien, bullet, ...", Presence::optional);
    options.repeated(
        "--read", "ENGINE.PARAMETER=VALUE", [this](const std::string& text) { readings_.push_back(text); },
        "Explain a coefficient found in a scene instead; may be repeated", Presence::optional);
    options.flag("--explain", explain_, "Print what else each engine needs, and a link to its documentation");
  }

  void run(const Results& results) override {
    const auto refuse = [](const std::string& option, bool given, const char* why) {
      const bool several = option.find(',') != std::string::npos;
      if (given)
        throw std::invalid_argument(option + (several ? " have" : " has") + " no effect with " + why + ": leave " +
                                    (several ? "them" : "it") + " out");
    };
    if (!readings_.empty()) {
      refuse("--radius-law, --mu-r, --gamma", moment_.given(), "--read, which finds the radius");
      refuse("--patch", !patch_.empty(), "--read, which finds a radius");
      refuse("--load", load_.has_value(), "--read, which gives the moment divided by the load");
      refuse("--loads", !loads_.empty(), "--read, which gives the moment divided by the load");
      refuse("--engine", !engine_.empty(), "--read, which names the engine");
      if (frictions_.size() > 1) throw std::invalid_argument("--mu: --read needs one value");
      if (law_ == nullptr)
        throw std::invalid_argument("--law is required: --read finds the radius that has the moment under it");
      results.warn_idle({{"--explain", true}}, "translate --read");
      return read(results);
    }
    if (frictions_.empty()) throw std::invalid_argument("--mu is required");
    if (!patch_.empty()) {
      const char* const why = "--patch, which has its own size and moments at every load";
      refuse("--law", law_ != nullptr, why);
      refuse("--radius-law, --mu-r, --gamma", moment_.given(), why);
      refuse("--load", load_.has_value(), why);
      refuse("--loads", !loads_.empty(), why);
      const Patch patch = read_patch(patch_, *results.messages);
      refuse_factors(*results.messages, patch);
      return write(results, [&](double mu) { return engines::translate(patch, mu); });
    }
    if (law_ == nullptr && !moment_.mu_r)
      throw std::invalid_argument("say what to translate: --law or --mu-r, or --patch, or --read");
    moment_.check(law_, *results.messages);
    // The moment itself, if it was measured.
    const std::string measured = moment_.mu_r                        ? "--mu-r"
                                 : moment_.radius_law->sets_moment() ? "--radius-law " + moment_.radius_law->text()
                                                                     : "";
    if (!measured.empty() && frictions_.size() > 1)
      throw std::invalid_argument(measured +
                                  " was measured at one --mu: give one value of --mu, or the radii by "
                                  "--radius-law");
    if (!load_)
      throw std::invalid_argument("--load is required, the normal load [N] at which the engine gets the exact limits");
    if (measured.empty()) note_profile_error(law_, *results.messages);
    if (!loads_.empty() && (loads_.size() != 2 || loads_[0] > loads_[1])) {
      throw std::invalid_argument("--loads: give two numbers LOW,HIGH, the smaller first");
    }
    if (law_ == nullptr) {
      law_ = hertz();
      results.messages->say(
          "limitcurve: note: without --law, the errors are against the curve of Hertz; the coefficients follow from "
          "--mu-r and need no law");
    }
    const engines::LoadRange range =
        loads_.empty() ? engines::LoadRange{*load_ / 4.0, 4.0 * *load_} : engines::LoadRange{loads_[0], loads_[1]};
    for (const double mu : frictions_) {
      results.messages->say(radius_warnings(moment_.with(mu, law_).radius(law_->moment_ratio()),
                                            std::array{range.low, range.high, *load_}));
    }
    write(results, [&](double mu) {
      return engines::translate(law_, moment_.with(mu, law_).radius(law_->moment_ratio()), mu, *load_, range);
    });
  }

 private:
  /// Where friction along x and y differs: the engine that has one coefficient alone, or a note of them.
  void refuse_factors(Messages& messages, const Patch& patch) const {
    const auto [mx, my] = patch.factors();
    if (mx == my) return;
    std::string names;
    for (const std::string& engine : engines::engines_of_one_friction()) {
      if (engine == engine_) {
        throw std::invalid_argument(
            "--engine: " + engine + " has one friction coefficient for all directions, but this patch has two (mx = " +
            format_number(mx) + ", my = " + format_number(my) + "): use mujoco, gazebo, gz-sim or ode, or set mx = my");
      }
      names += ' ' + engine;
    }
    if (engine_.empty())
      messages.say("limitcurve: note: left out, because they have one coefficient of friction for x and y:" + names);
  }

  /// `translate` gives the contacts of a friction.
  void write(const Results& results,
             const std::function<std::vector<engines::EngineContact>(double)>& translate) const {
    const bool narrow = !engine_.empty() || (results.format == Format::table && results.columns == nullptr);
    const bool one_mu = frictions_.size() == 1;
    std::size_t count = 7;  // as many of the narrow columns as fit 120 places, and, of one engine, eight columns
    if (!loads_.empty() && engine_.empty()) count = one_mu ? 5 : 4;
    if (!loads_.empty() && !engine_.empty() && !one_mu) count = 6;
    ColumnList list(std::array<ListedColumn<Translated>, 0>{});
    list.add(narrow ? std::span(narrow_columns).first(count).subspan(engine_.empty() ? 0 : 1)
                    : std::span(coefficient_columns));
    if (!loads_.empty()) list.add(load_columns);
    if (frictions_.size() > 1) list.add(friction_columns);
    Rows rows(results, list.names());
    for (const double mu : frictions_) {
      for (const engines::EngineContact& contact : translate(mu)) {
        if (!engine_.empty() && contact.engine != engine_) continue;
        for (EngineCoefficient coefficient : contact.coefficients) {
          if (narrow && !coefficient.two_bodies.empty())
            coefficient.note += (coefficient.note.empty() ? "two bodies: " : "; two bodies: ") + coefficient.two_bodies;
          list.write(rows, {contact, coefficient, mu});
        }
        for (const auto& error : std::span(coefficient_columns).subspan(5, narrow ? 3 : 0)) {
          const double size = std::get<double>(error.of({contact, {}, mu}));
          list.write(rows, {contact, {std::string(error.name), size, "1", "", "", "", size, size}, mu});
        }
        if (explain_ && mu == frictions_.front()) {
          results.messages->say("limitcurve: note: " + contact.engine + ", " + contact.model + ": " + contact.caveat +
                                " (" + contact.documentation + ")");
        }
      }
    }
    rows.finish();
  }

  /// The numbers of one --read.
  static void append_numbers(const std::string& text, std::vector<engines::EngineNumber>& numbers) {
    const std::size_t point = text.find_first_of(".:");  // newton:torsionalFriction, too
    const std::size_t equals = text.rfind('=');
    std::istringstream values(equals == std::string::npos || point >= equals ? "" : text.substr(equals + 1));
    const std::size_t before = numbers.size();
    for (std::string word; values >> word;) {
      const auto value = word == "true" ? 1.0 : word == "false" ? 0.0 : parse_number(word);
      if (!value)
        throw std::invalid_argument("--read: got '" + text + "', expected a number or true or false after '='");
      const std::size_t index = numbers.size() - before;
      std::string name = text.substr(point + 1, equals - point - 1);
      if (index > 0) name.append("[").append(std::to_string(index)).append("]");
      numbers.push_back({text.substr(0, point), std::move(name), *value});
    }
    if (numbers.size() == before) {
      throw std::invalid_argument("--read: got '" + text +
                                  "', expected ENGINE.PARAMETER=VALUE, such as mujoco.torsional=0.005");
    }
  }

  void read(const Results& results) const {
    std::vector<engines::EngineNumber> numbers;
    for (const std::string& text : readings_) append_numbers(text, numbers);
    std::vector<engines::CoefficientMeaning> meanings;
    try {
      const auto with = [&](double mu) { return engines::read_coefficients(numbers, mu, law_); };
      const auto size = [](const auto& one) { return std::pair(if_any(one.moment_per_load), if_any(one.radius)); };
      const auto same = [&](const auto& one, const auto& other) { return size(one) == size(other); };
      const double mu = frictions_.empty() ? std::numeric_limits<double>::quiet_NaN() : frictions_.front();
      meanings = with(mu);
      const auto others = with(mu == 1.0 ? 2.0 : 1.0);
      results.warn_idle({{"--mu", std::equal(meanings.begin(), meanings.end(), others.begin(), same)}},
                        "numbers that have their own friction or set no moment");
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(std::string("--read: ") + error.what());
    }
    const ColumnList list(meaning_columns);
    Rows rows(results, list.names());
    for (std::size_t i = 0; i < meanings.size(); ++i) list.write(rows, {meanings[i], numbers[i].value});
    rows.finish();
  }

  Law law_;
  MomentArgument moment_;
  std::string patch_;
  std::vector<double> frictions_;
  std::optional<double> load_;
  std::vector<double> loads_;
  std::string engine_;
  std::vector<std::string> readings_;
  bool explain_ = false;
};

}  // namespace

std::unique_ptr<Subcommand> make_translate() {
  return std::make_unique<Translate>();
}

}  // namespace limitcurve::cli
