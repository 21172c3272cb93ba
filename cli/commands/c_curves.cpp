// SPDX-License-Identifier: MIT
#include "cli/commands/radius_check.hpp"
#include "cli/commands/subcommands.hpp"

#include "limitcurve/contact_radius.hpp"
#include "limitcurve/exact_curve.hpp"

namespace limitcurve::cli {

namespace {

class CCurves final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"c-curves", "Force and moment against load at fixed centres of rotation (paper, Fig. 4)",
            "Columns: c [m], load P [N], force [N], moment [N m].",
            "limitcurve c-curves --law hertz --radius-law power:c=0.00207,gamma=0.259 --mu 0.8 --cors 0,0.002,inf --loads 0.5,1,2"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.radius_law(radius_law_);
    options.number("--mu", friction_, non_negative, "Friction coefficient mu [1]", Presence::required);
    options.numbers("--cors", distances_, distance, "Distances of the centre of rotation from the contact centre [m]");
    options.numbers("--loads", loads_, non_negative, "Normal loads P [N]");
  }

  void run(const Results& results) override {
    const RadiusLaw radius_law = radius_law_->of(friction_, law_);
    warn_of_radii(*results.messages, radius_law, loads_);
    Rows rows(results, {"c", "load", "force", "moment"});
    const ExactCurve exact(law_);
    for (const double c : distances_) {
      for (const LoadPoint& point : c_curve(exact, radius_law, friction_, c, loads_)) {
        rows.row(point.cor, point.load, point.force, point.moment);
      }
    }
    rows.finish();
  }

 private:
  Law law_;
  std::optional<RadiusLawArgument> radius_law_;
  double friction_ = 0.0;
  std::vector<double> distances_;
  std::vector<double> loads_;
};

}  // namespace

std::unique_ptr<Subcommand> make_c_curves() {
  return std::make_unique<CCurves>();
}

}  // namespace limitcurve::cli
