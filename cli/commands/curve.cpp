// SPDX-License-Identifier: MIT
#include "cli/commands/half_spaces.hpp"
#include "cli/commands/subcommands.hpp"

#include "limitcurve/contact/load_curves.hpp"

#include <optional>

namespace limitcurve::cli {

namespace {

class Curve final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"curve", "Compute the unit limit curve at even slip angles",
            "Columns: c in contact radii, from 0 (pure twist) to inf (pure slide), force in units of mu P, moment in\n"
            "units of mu P a, and x = F/F_max and y = M/M_max, the paper's normalised plane.\n"
            "--half-spaces: inequalities inside the limit surface for mu P = 1 and a = 1; columns as in 'limitcurve "
            "patch'. For a radius a,\ndivide the moments of rows by a, and multiply those of vertices by a.",
            "limitcurve curve --law uniform --points 181"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.count("--points", points_, 2, 10'000'000, "Number of points");
    options.count("--half-spaces", half_spaces_, 8, 1'000'000,
                  "At most N inequalities for a planner, instead of points");
  }

  void run(const Results& results) override {
    results.messages->say(law_->remarks());
    results.warn_idle({{"--points", half_spaces_.has_value()}}, "--half-spaces");
    if (half_spaces_) return write_half_spaces(results, half_spaces(Patch::ellipse(law_, 1.0, 1.0), *half_spaces_));
    Rows rows(results, {"c", "force", "moment", "x", "y"});
    const double moment_ratio = law_->moment_ratio();
    std::size_t done = 0;
    for (const SlipTwist twist : slip_twists(points_)) {
      results.messages->progress(static_cast<double>(done++) / static_cast<double>(points_));
      const UnitWrench wrench = law_->evaluate(twist.cor()).wrench;
      rows.row(twist.cor(), wrench.force, wrench.moment, wrench.force, wrench.moment / moment_ratio);
    }
    rows.finish();
  }

 private:
  Law law_;
  std::size_t points_ = 91;
  std::optional<std::size_t> half_spaces_;
};

}  // namespace

std::unique_ptr<Subcommand> make_curve() {
  return std::make_unique<Curve>();
}

}  // namespace limitcurve::cli
