// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/contact/load_curves.hpp"
#include "limitcurve/exact_curve.hpp"

#include <stdexcept>

namespace limitcurve::cli {

namespace {

/// p-curves or c-curves.
class LoadCurves final : public Subcommand {
 public:
  explicit LoadCurves(bool at_cors) : at_cors_(at_cors) {}

  [[nodiscard]] Manual manual() const override {
    const std::string plane =
        "\nWith both stiffnesses also r = force/k_l [m] and rho = moment/k_r [rad] (paper, Fig. 5).";
    if (at_cors_) {
      return {"c-curves", "Compute force and moment against load at fixed centres of rotation (paper, Fig. 4)",
              "Columns: c [m], load P [N], force [N], moment [N m]." + plane,
              "limitcurve c-curves --law hertz --radius-law power:c=0.00207,gamma=0.259 --mu 0.8 --cors 0,0.002,inf "
              "--loads 0.5,1,2"};
    }
    return {"p-curves", "Compute limit curves at fixed loads (paper, Fig. 4)",
            "Columns: load P [N], c [m], force [N], moment [N m]; points are evenly spaced in the slip angle "
            "atan(c/a(P))." +
                plane,
            "limitcurve p-curves --law hertz --radius-law hertz:R=0.008,E=2e5 --mu 0.8 --loads 0.5,1,2"};
  }

  void declare(Options& options) override {
    options.law(law_);
    options.moment(moment_);
    options.number("--mu", friction_, non_negative, "Friction coefficient mu [1]", Presence::required);
    if (at_cors_)
      options.numbers("--cors", distances_, distance,
                      "Distances from the contact centre to the centre of rotation [m]");
    options.numbers("--loads", loads_, non_negative, "Normal loads P [N]");
    if (!at_cors_) options.count("--points", points_, 2, 10'000'000, "Points per curve");
    options.number("--stiffness", stiffness_, positive, "k_l [N/m], for the columns r and rho");
    options.number("--twist-stiffness", twist_stiffness_, positive, "k_r [N m/rad], for the columns r and rho");
  }

  void run(const Results& results) override {
    if (stiffness_.has_value() != twist_stiffness_.has_value()) {
      throw std::invalid_argument(std::string(stiffness_ ? "--twist-stiffness" : "--stiffness") +
                                  " is missing: r and rho need both stiffnesses");
    }
    moment_.check(law_, *results.messages);
    const ContactFriction contact = moment_.with(friction_, law_);
    std::vector<std::string> columns{at_cors_ ? "c" : "load", at_cors_ ? "load" : "c", "force", "moment"};
    if (stiffness_) columns.insert(columns.end(), {"r", "rho"});
    Rows rows(results, columns);
    const auto write = [&](const std::vector<LoadPoint>& curve) {
      for (const LoadPoint& point : curve) {
        rows.row_by([&](const auto& cell) {
          cell(at_cors_ ? point.cor : point.load);
          cell(at_cors_ ? point.load : point.cor);
          cell(point.force);
          cell(point.moment);
          if (!stiffness_) return;
          cell(point.force / *stiffness_);
          cell(point.moment / *twist_stiffness_);
        });
      }
    };
    const ExactCurve exact(law_);
    for (const double c : distances_) write(c_curve(exact, contact, c, loads_));
    for (const double load : at_cors_ ? std::vector<double>() : loads_) write(p_curve(exact, contact, load, points_));
    rows.finish();
    results.messages->say(radius_warnings(contact.radius(law_->moment_ratio()), loads_));
  }

 private:
  bool at_cors_;
  Law law_;
  MomentArgument moment_;
  double friction_ = 0.0;
  std::vector<double> distances_;
  std::vector<double> loads_;
  std::size_t points_ = 91;
  std::optional<double> stiffness_;
  std::optional<double> twist_stiffness_;
};

}  // namespace

std::unique_ptr<Subcommand> make_p_curves() {
  return std::make_unique<LoadCurves>(false);
}

std::unique_ptr<Subcommand> make_c_curves() {
  return std::make_unique<LoadCurves>(true);
}

}  // namespace limitcurve::cli
