// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/engines/engine_coefficients.hpp"
#include "limitcurve/internal/number.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

/// An empty cell in place of NaN.
std::optional<double> if_any(double number) {
  return std::isnan(number) ? std::nullopt : std::optional(number);
}

class Translate final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "translate", "The coefficients to type into physics engines, with the error each keeps; or what such a number means",
        "The coefficients give the exact limits of force and moment at --load; between the limits each engine has its own shape.\n"
        "Columns: engine; parameter, in the engine's spelling; value; unit; model, the shape (ellipse, diamond, box, point: no\n"
        "moment); max_error, its largest radial error against the exact curve (0.07 is 7 %); cor_error,\n"
        "the largest error of the wrench at the same centre of rotation, as a fraction of the limits; loads_error, the largest\n"
        "radial error over the --loads, because the coefficients are constant; note, what the engine multiplies the value by, and\n"
        "its name for the value; formula, of mu, mu_r = mu m0 a, m0, a, and f, the other body's friction, taken as 1; two_bodies,\n"
        "how the engine combines the values of two bodies. With --loads also low and high: the range of the value over these loads,\n"
        "for randomisation.\n"
        "--mu-r R, as it is measured, with --gamma G if it grows with the load: in place of --radius-law.\n"
        "--patch P, in place of --law, --radius-law and --load: a contact that is not round (see 'limitcurve patch').\n"
        "--read ENGINE.PARAMETER=VALUE, with --mu and --law alone: what a number in a scene means. Columns: engine; parameter;\n"
        "value; moment_per_load [m], the largest moment over the load (none: it sets no moment); radius [m], the contact radius that a\n"
        "contact of the law needs for it; note. PARAMETER is the engine's name or a short one: friction, torsional, patch_radius, ...\n"
        "--explain writes what else each engine needs, and its documentation, to standard error.",
        "limitcurve translate --law hertz --radius-law power:c=0.00207,gamma=0.259 --mu 0.8 --load 2"};
  }

  void declare(Options& options) override {
    options.law(law_, Presence::optional);
    options.moment(moment_);
    options.text("--patch", patch_, "PATCH", "In place of --law, --radius-law and --load: a pressure patch");
    options.number("--mu", friction_, positive, "Friction coefficient mu [1]", Presence::required);
    options.number("--load", load_, positive, "Normal load P [N] at which the limits are exact");
    options.numbers("--loads", loads_, positive,
                    "LOW,HIGH: range of loads [N] for loads_error (default: a quarter of --load to four times --load)", Presence::optional);
    options.value(
        "--engine", "ENGINE", [this](const std::string& text) { engine_ = engines::find_engine(text); },
        "One engine alone: mujoco, newton, genesis, physx, isaac, sapien, bullet, ...", Presence::optional);
    options.repeated(
        "--read", "ENGINE.PARAMETER=VALUE", [this](const std::string& text) { readings_.push_back(text); },
        "What a number in an engine's scene means; may be repeated", Presence::optional);
    options.flag("--explain", explain_, "Write to standard error what else each engine needs");
  }

  void run(const Results& results) override {
    const auto refuse = [](const char* option, bool given, const char* why) {
      if (given) throw std::invalid_argument(std::string(option) + ": not with " + why);
    };
    if (!readings_.empty()) {
      refuse("--radius-law, --mu-r, --gamma", moment_.given(), "--read, which finds the radius");
      refuse("--patch", !patch_.empty(), "--read, which finds a radius");
      refuse("--load", load_.has_value(), "--read, which finds the moment over the load");
      refuse("--loads", !loads_.empty(), "--read, which finds the moment over the load");
      refuse("--engine", !engine_.empty(), "--read, which names the engine");
      if (law_ == nullptr) throw std::invalid_argument("--law is required");
      return read(results);
    }
    if (!patch_.empty()) {
      const char* const why = "--patch, which has its own size and moments at every load";
      refuse("--law", law_ != nullptr, why);
      refuse("--radius-law, --mu-r, --gamma", moment_.given(), why);
      refuse("--load", load_.has_value(), why);
      refuse("--loads", !loads_.empty(), why);
      const Patch patch = read_patch(patch_, *results.messages);
      refuse_factors(*results.messages, patch);
      return write(results, engines::translate(patch, friction_));
    }
    if (law_ == nullptr) throw std::invalid_argument("expected one of --law, --patch and --read");
    moment_.check();
    if (!load_) throw std::invalid_argument("--load is required");
    if (!loads_.empty() && (loads_.size() != 2 || loads_[0] > loads_[1])) {
      throw std::invalid_argument("--loads: expected two numbers LOW,HIGH with LOW <= HIGH");
    }
    const engines::LoadRange range =
        loads_.empty() ? engines::LoadRange{*load_ / 4.0, 4.0 * *load_} : engines::LoadRange{loads_[0], loads_[1]};
    const RadiusLaw radius_law = moment_.with(friction_, law_).radius(law_->moment_ratio());
    results.messages->say(radius_warnings(radius_law, std::array{range.low, range.high, *load_}));
    write(results, engines::translate(law_, radius_law, friction_, *load_, range));
  }

 private:
  /// Where friction along x and y differs: the engine that has one coefficient alone, or a note of them.
  void refuse_factors(Messages& messages, const Patch& patch) const {
    const auto [mx, my] = patch.factors();
    if (mx == my) return;
    std::string names;
    for (const std::string& engine : engines::engines_of_one_friction()) {
      if (engine == engine_) {
        throw std::invalid_argument("--engine: " + engine + " has one coefficient of friction, and mx = " + format_number(mx) +
                                    ", my = " + format_number(my) + " differ: expected an engine with two, mujoco, gazebo or ode");
      }
      names += ' ' + engine;
    }
    if (engine_.empty()) messages.say("limitcurve: note: left out, because they have one coefficient of friction for x and y:" + names);
  }

  void write(const Results& results, const std::vector<engines::EngineContact>& contacts) const {
    std::vector<std::string> columns{"engine",    "parameter",   "value", "unit",    "model",     "max_error",
                                     "cor_error", "loads_error", "note",  "formula", "two_bodies"};
    if (!loads_.empty()) columns.insert(columns.end(), {"low", "high"});
    Rows rows(results, columns);
    for (const engines::EngineContact& contact : contacts) {
      if (!engine_.empty() && contact.engine != engine_) continue;
      for (const engines::EngineCoefficient& coefficient : contact.coefficients) {
        rows.row_by([&](const auto& cell) {
          cell(contact.engine);
          cell(coefficient.parameter);
          cell(coefficient.value);
          cell(coefficient.unit);
          cell(contact.model);
          cell(contact.error.max_error);
          cell(contact.max_wrench_error);
          cell(contact.max_error_over_loads);
          cell(coefficient.note);
          cell(coefficient.formula);
          cell(coefficient.two_bodies);
          if (loads_.empty()) return;
          cell(coefficient.low);
          cell(coefficient.high);
        });
      }
      if (explain_) {
        results.messages->say("limitcurve: note: " + contact.engine + ", " + contact.model + ": " + contact.caveat + " (" +
                              contact.documentation + ")");
      }
    }
    rows.finish();
  }

  void read(const Results& results) const {
    Rows rows(results, {"engine", "parameter", "value", "moment_per_load", "radius", "note"});
    for (const std::string& text : readings_) {
      const std::size_t point = text.find('.');
      const std::size_t equals = text.rfind('=');
      const auto value = equals == std::string::npos ? std::nullopt : parse_number(text.substr(equals + 1));
      if (!value || point >= equals) {
        throw std::invalid_argument("--read: got '" + text + "', expected ENGINE.PARAMETER=VALUE, such as mujoco.torsional=0.005");
      }
      try {
        const auto found =
            engines::read_coefficient(text.substr(0, point), text.substr(point + 1, equals - point - 1), *value, friction_, law_);
        rows.row(found.engine, found.parameter, *value, if_any(found.moment_per_load), if_any(found.radius), found.note);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string("--read: ") + error.what());
      }
    }
    rows.finish();
  }

  Law law_;
  MomentArgument moment_;
  std::string patch_;
  double friction_ = 0.0;
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
