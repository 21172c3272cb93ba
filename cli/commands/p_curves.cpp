// SPDX-License-Identifier: MIT
#include "cli/commands/radius_check.hpp"
#include "cli/commands/subcommands.hpp"

#include "limitcurve/contact_radius.hpp"
#include "limitcurve/exact_curve.hpp"

namespace limitcurve::cli {

namespace {

class PCurves final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"p-curves", "Limit curves at fixed loads (paper, Fig. 4)",
            "Columns: load P [N], c [m], force [N], moment [N m]; the points of each load are evenly spaced in slip angle atan(c/a(P)).",
            "limitcurve p-curves --law hertz --radius-law hertz:R=0.008,E=2e5 --mu 0.8 --loads 0.5,1,2"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.radius_law(radius_law_);
    options.number("--mu", friction_, non_negative, "Friction coefficient mu [1]", Presence::required);
    options.numbers("--loads", loads_, non_negative, "Normal loads P [N]");
    options.count("--points", points_, 2, 10'000'000, "Number of points of each curve");
  }

  void run(const Results& results) override {
    const RadiusLaw radius_law = radius_law_->of(friction_, law_);
    warn_of_radii(*results.messages, radius_law, loads_);
    Rows rows(results, {"load", "c", "force", "moment"});
    const ExactCurve exact(law_);
    for (const double load : loads_) {
      for (const LoadPoint& point : p_curve(exact, radius_law, friction_, load, points_)) {
        rows.row(point.load, point.cor, point.force, point.moment);
      }
    }
    rows.finish();
  }

 private:
  Law law_;
  std::optional<RadiusLawArgument> radius_law_;
  double friction_ = 0.0;
  std::vector<double> loads_;
  std::size_t points_ = 91;
};

}  // namespace

std::unique_ptr<Subcommand> make_p_curves() {
  return std::make_unique<PCurves>();
}

}  // namespace limitcurve::cli
