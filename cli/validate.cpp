// SPDX-License-Identifier: MIT
#include "cli/law_argument.hpp"
#include "cli/subcommands.hpp"

#include "fit/curve_fit.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/validate.hpp"

#include <array>
#include <limits>
#include <string_view>
#include <utility>

namespace limitcurve::cli {

namespace {

constexpr std::array<std::pair<std::string_view, fit::Criterion>, 4> ellipses{{{"ellipse", fit::Criterion::intercepts},
                                                                               {"ellipse-least-squares", fit::Criterion::least_squares},
                                                                               {"ellipse-inner", fit::Criterion::inner},
                                                                               {"ellipse-outer", fit::Criterion::outer}}};

class Validate final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"validate", "How wrong ellipse, superellipse, quartic and box are against the exact curve",
            "Errors are relative radii in the paper's normalised plane (0.07 is 7 %): over-estimates hold where the finger\n"
            "slips. max_cor_error is the largest |c_model/c_exact - 1|, inf where it has no bound.\n"
            "Models and their parameter: ellipse (through the intercepts), ellipse-least-squares, ellipse-inner (largest\n"
            "inside) and ellipse-outer (smallest outside): the force semi-axis in units of mu P; superellipse\n"
            "x^n + y^n = 1 and quartic x^4 + y^4 + kappa x^2 y^2 = 1, with the least largest error: n, kappa; box\n"
            "(uncoupled limits): inf, and diamond (x + y = 1): 1, both as exponents of a superellipse.",
            "limitcurve validate --law hertz --law uniform"};
  }

  void declare(Options& options) override {
    options.repeated(
        "--law", "LAW", [this](const std::string& text) { laws_.push_back(read_law(text)); },
        "Pressure law, samples:FILE.csv among them; may be repeated (default: all that 'limitcurve laws' lists)", Presence::optional);
  }

  void run(const Results& results) override {
    if (laws_.empty()) {
      for (const std::string_view name : law_examples()) laws_.push_back(parse_law(name));
    }
    Rows rows(results, {"law", "model", "parameter", "max_error", "rms_error", "max_over_estimate", "max_under_estimate", "max_cor_error"});
    for (const Law& law : laws_) {
      const auto row = [&](std::string_view model, double parameter, const BoundaryError& error) {
        rows.row(law->name(), model, parameter, error.max_error, error.rms_error, error.max_over_estimate, error.max_under_estimate,
                 error.max_cor_error);
      };
      for (const auto& [model, criterion] : ellipses) {
        const auto ellipse = fit::fit_ellipse(law, criterion);
        row(model, ellipse.boundary.force_max(), ellipse.error);
      }
      const auto superellipse = fit::fit_superellipse(law, fit::Criterion::minimax);
      row("superellipse", superellipse.boundary.exponent(), superellipse.error);
      const auto quartic = fit::fit_quartic(law, fit::Criterion::minimax);
      row("quartic", quartic.boundary.kappa(), quartic.error);
      const ExactCurve exact(law);
      row("box", std::numeric_limits<double>::infinity(), boundary_error(box(1.0, exact.moment_ratio()), exact));
      row("diamond", 1.0, boundary_error(diamond(1.0, exact.moment_ratio()), exact));
    }
    rows.finish();
  }

 private:
  std::vector<Law> laws_;
};

}  // namespace

std::unique_ptr<Subcommand> make_validate() {
  return std::make_unique<Validate>();
}

}  // namespace limitcurve::cli
