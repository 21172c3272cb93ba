// SPDX-License-Identifier: MIT
#include "cli/commands/radius_check.hpp"
#include "cli/commands/subcommands.hpp"

#include "fit/engine_coefficients.hpp"

#include <stdexcept>

namespace limitcurve::cli {

namespace {

class Translate final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"translate", "The coefficients to type into physics engines, with the error each keeps",
            "The coefficients give the exact limits of force and moment at --load; between the limits each engine has its own shape.\n"
            "Columns: engine; parameter, in the engine's spelling; value; unit; model, the shape (ellipse, diamond, box); max_error, its\n"
            "largest radial error against the exact curve (0.07 is 7 %); cor_error, the largest error of the wrench at the same centre of\n"
            "rotation, as a fraction of the limits; loads_error, the largest radial error over the --loads, because the coefficients\n"
            "are constant; note, the engine's name for the value.\n"
            "--explain writes the formula of each coefficient and the engine's documentation to standard error.",
            "limitcurve translate --law hertz --radius-law power:c=0.00207,gamma=0.259 --mu 0.8 --load 2"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.radius_law(radius_law_);
    options.number("--mu", friction_, positive, "Friction coefficient mu [1]", Presence::required);
    options.number("--load", load_, positive, "Normal load P [N] at which the limits are exact", Presence::required);
    options.numbers("--loads", loads_, positive,
                    "LOW,HIGH: range of loads [N] for loads_error (default: a quarter of --load to four times --load)", Presence::optional);
    options.flag("--explain", explain_, "Write the formulas of the coefficients to standard error");
  }

  void run(const Results& results) override {
    if (!loads_.empty() && (loads_.size() != 2 || loads_[0] > loads_[1])) {
      throw std::invalid_argument("--loads: expected two numbers LOW,HIGH with LOW <= HIGH");
    }
    std::vector<double> judged = loads_.empty() ? std::vector{load_ / 4.0, 4.0 * load_} : loads_;
    judged.push_back(load_);
    const RadiusLaw radius_law = radius_law_->of(friction_, law_);
    warn_of_radii(*results.messages, radius_law, judged);
    const std::vector<fit::EngineContact> contacts =
        loads_.empty() ? fit::translate(law_, radius_law, friction_, load_)
                       : fit::translate(law_, radius_law, friction_, load_, fit::LoadRange{loads_[0], loads_[1]});
    Rows rows(results, {"engine", "parameter", "value", "unit", "model", "max_error", "cor_error", "loads_error", "note"});
    for (const fit::EngineContact& contact : contacts) {
      for (const fit::EngineCoefficient& coefficient : contact.coefficients) {
        rows.row(contact.engine, coefficient.parameter, coefficient.value, coefficient.unit, contact.model, contact.error.max_error,
                 contact.max_wrench_error, contact.max_error_over_loads, coefficient.word);
      }
      if (explain_) explain(*results.messages, contact);
    }
    rows.finish();
  }

 private:
  static void explain(Messages& messages, const fit::EngineContact& contact) {
    std::string text;
    for (const fit::EngineCoefficient& coefficient : contact.coefficients) {
      text += coefficient.parameter + " = " + coefficient.formula + "; ";
    }
    text += contact.caveat + " (" + contact.documentation + ")";
    messages.say("limitcurve: note: " + contact.engine + ", " + contact.model + ": " + text);
  }

  Law law_;
  std::optional<RadiusLawArgument> radius_law_;
  double friction_ = 0.0;
  double load_ = 0.0;
  std::vector<double> loads_;
  bool explain_ = false;
};

}  // namespace

std::unique_ptr<Subcommand> make_translate() {
  return std::make_unique<Translate>();
}

}  // namespace limitcurve::cli
