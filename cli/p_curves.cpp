// SPDX-License-Identifier: MIT
#include "cli/slip_angles.hpp"
#include "cli/subcommands.hpp"

#include <cmath>

namespace limitcurve::cli {

namespace {

class PCurves final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"p-curves", "Limit curves at fixed loads (paper, Fig. 4)",
            "Columns: load P [N], c [m], force [N], moment [N m]; each load's points evenly in slip angle atan(c/a(P)).",
            "limitcurve p-curves --law hertz --radius-law hertz:R=0.008,E=2e5 --mu 0.8 --loads 0.5,1,2"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.radius_law(radius_law_);
    options.number("--mu", friction_, non_negative, "Friction coefficient mu [1]", Presence::required);
    options.numbers("--loads", loads_, non_negative, "Normal loads P [N]");
    options.count("--points", points_, 2, 10'000'000, "Number of points a curve");
  }

  void run(Results results) override {
    Rows rows(results, {"load", "c", "force", "moment"});
    for (const double load : loads_) {
      const double radius = radius_law_->radius(load);
      const double limit = friction_ * load;
      for (std::size_t i = 0; i < points_; ++i) {
        const double s = cor_at_slip_angle(i, points_);
        const UnitWrench unit = law_->evaluate(s).wrench;
        // A load of zero may leave no contact at all; its pure slide is infinitely far all the same.
        rows.row(load, std::isinf(s) ? s : s * radius, limit * unit.force, limit * radius * unit.moment);
      }
    }
    rows.finish();
  }

 private:
  Law law_;
  std::optional<RadiusLaw> radius_law_;
  double friction_ = 0.0;
  std::vector<double> loads_;
  std::size_t points_ = 91;
};

}  // namespace

std::unique_ptr<Subcommand> make_p_curves() {
  return std::make_unique<PCurves>();
}

}  // namespace limitcurve::cli
