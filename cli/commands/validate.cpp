// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/law_argument.hpp"
#include "cli/io/patch_argument.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/remembering_law.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/round_models.hpp"
#include "limitcurve/validate.hpp"
#ifdef LIMITCURVE_HAS_FIT
#include "fit/curve_fit.hpp"
#endif

#include <limits>
#include <stdexcept>
#include <string_view>

namespace limitcurve::cli {

namespace {

class Validate final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"validate", "Errors of ellipse, box and diamond against the exact curve",
            "Errors are relative radii in the paper's normalised plane (0.07 is 7 %). An over-estimate holds where the real finger slips.\n"
            "max_cor_error is the largest |c_model/c_exact - 1|, inf if it is unbounded.\n"
            "Models and their parameter: ellipse (through the intercepts), ellipse-least-squares and ellipse-inner (inside the curve,\n"
            "with the least largest error): the force semi-axis in units of mu P; box (uncoupled limits): inf, and diamond: 1, the\n"
            "exponents n of x^n + y^n = 1.\n"
            "With --patch the contact is not round (see 'limitcurve patch') and law names the patch. Errors compare the model's power\n"
            "with the patch's, over all sliding twists; rms_error is over centres of rotation in 128 directions at 121\n"
            "distances, evenly and logarithmically from 1e-3 to 1e3 m0 (m0: moment of a pure spin over mu P). Models and their parameter:\n"
            "disc:LAW, the law and radius with the least largest error, and disc-equal-area:LAW: the radius [m]; ellipsoid\n"
            "sqrt(v^2 + m0^2 w^2): m0 [m].",
            "limitcurve validate --law hertz --law uniform"};
  }

  void declare(Options& options) override {
    options.repeated(
        "--law", "LAW", [this](const std::string& text) { laws_.push_back(read_law(text)); },
        "Pressure law, also samples:FILE.csv; may be repeated (default: all laws of 'limitcurve laws')", Presence::optional);
    options.repeated(
        "--patch", "PATCH", [this](const std::string& text) { patches_.push_back(text); },
        "In place of --law: a pressure patch; may be repeated", Presence::optional);
  }

  void run(const Results& results) override {
    if (!patches_.empty()) return validate_patches(results);
    if (laws_.empty()) {
      for (const std::string_view name : law_examples()) laws_.push_back(parse_law(name));
    }
    Rows rows(results, columns());
    std::size_t done = 0;
    for (const Law& given : laws_) {
      const auto law = std::make_shared<const RememberingLaw>(given);
      results.messages->progress(static_cast<double>(done++) / static_cast<double>(laws_.size()));
      const auto row = [&](std::string_view model, double parameter, const CurveError& error) {
        write(rows, law->name(), model, parameter, error);
      };
      const ExactCurve exact(law);
      const auto ellipse = [&](std::string_view model, const Ellipse& curve) { row(model, curve.force_max(), curve_error(curve, exact)); };
      ellipse("ellipse", Ellipse::through_intercepts(exact.moment_ratio()));
#ifdef LIMITCURVE_HAS_FIT
      ellipse("ellipse-least-squares", fit::fit_ellipse(law, fit::Criterion::least_squares).curve);
#endif
      ellipse("ellipse-inner", inner_ellipse(exact));
      row("box", std::numeric_limits<double>::infinity(), curve_error(box(1.0, exact.moment_ratio()), exact));
      row("diamond", 1.0, curve_error(diamond(1.0, exact.moment_ratio()), exact));
    }
    rows.finish();
  }

 private:
  static std::vector<std::string> columns() {
    return {"law", "model", "parameter", "max_error", "rms_error", "max_over_estimate", "max_under_estimate", "max_cor_error"};
  }

  static void write(Rows& rows, const std::string& law, std::string_view model, double parameter, const CurveError& error) {
    rows.row(law, model, parameter, error.max_error, error.rms_error, error.max_over_estimate, error.max_under_estimate,
             error.max_cor_error);
  }

  void validate_patches(const Results& results) const {
    if (!laws_.empty()) throw std::invalid_argument("--patch: got --law too, expected one of them");
    std::vector<std::pair<std::string, std::vector<RoundModel>>> found;
    for (const std::string& text : patches_) {
      results.messages->progress(static_cast<double>(found.size()) / static_cast<double>(patches_.size()));
      const Patch patch = read_patch(text, *results.messages);
      note_factor(*results.messages, patch);
      found.emplace_back(text, round_models(patch));
    }
    Rows rows(results, columns());
    for (const auto& [text, models] : found) {
      for (const RoundModel& model : models) write(rows, text, model.name, model.parameter, model.error);
    }
    rows.finish();
  }

  std::vector<Law> laws_;
  std::vector<std::string> patches_;
};

}  // namespace

std::unique_ptr<Subcommand> make_validate() {
  return std::make_unique<Validate>();
}

}  // namespace limitcurve::cli
