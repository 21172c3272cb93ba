// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/stated_error.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/internal/number.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

class Eval final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "eval", "Compute friction force and moment at given centres of rotation (eq. 17)",
        "Columns: c [m], force [N], moment [N m], and bounds on their absolute errors, the rounding of c included.\n"
        "Without --radius, --load and --mu, c is in contact radii, force in units of mu P, moment in units of mu P a.",
        "limitcurve eval --law hertz --c 0.25,0.5,1,inf"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.numbers("--c", distances_, signed_distance,
                    "Distances from the contact centre to the centre of rotation [m], such as 0,0.5,inf");
    options.number("--radius", radius_, positive, "Contact radius a [m] (default 1)");
    options.number("--load", load_, non_negative, "Normal load P [N]");
    options.number("--mu", friction_, non_negative, "Friction coefficient mu [1]");
    options.choice("--method", method_, method_names(), "Method for eq. (17): {}");
  }

  void run(const Results& results) override {
    results.messages->say(law_->remarks());
    const Method method = method_of(*law_, to_string(method_));
    const double radius = radius_.value_or(1.0);
    const double force_unit = friction_ * load_;
    const double moment_unit = force_unit * radius;
    if (!std::isfinite(force_unit) || !std::isfinite(moment_unit)) {
      throw std::invalid_argument("--mu, --load, --radius: their product is too large, expected a finite number");
    }
    UnitChecks questions;
    questions.load(load_);
    if (radius_) questions.length("--radius", 2.0 * *radius_);
    results.messages->say(questions.lines());
    if (!radius_ && law_->rim() > 0.0 && force_unit != 1.0) {
      results.messages->say("limitcurve: note: without --radius a is 1 m; that of " + law_->name() + " is --radius " +
                            format_number(law_->rim()) + " if its radii are in metres");
    }
    Rows rows(results, {"c", "force", "moment", "force_error", "moment_error"});
    for (const double c : distances_) {
      const double s = c / radius;
      const auto [wrench, error, slope] = in_units(law_->evaluate(s, method), s, force_unit, moment_unit);
      rows.row(c, wrench.force, wrench.moment, error.force, error.moment);
    }
    rows.finish();
  }

 private:
  Law law_;
  std::vector<double> distances_;
  std::optional<double> radius_;
  double load_ = 1.0;
  double friction_ = 1.0;
  Method method_ = Method::automatic;
};

}  // namespace

std::unique_ptr<Subcommand> make_eval() {
  return std::make_unique<Eval>();
}

}  // namespace limitcurve::cli
