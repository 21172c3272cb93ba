// SPDX-License-Identifier: MIT
#include "godobject/scene/pivot.hpp"

#include "cli/commands/subcommands.hpp"
#include "cli/io/argument_parts.hpp"
#include "cli/io/csv_reader.hpp"
#include "cli/io/law_argument.hpp"
#include "cli/io/materials.hpp"
#include "cli/io/unit_checks.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

using godobject::CurveKind;
using godobject::GripOperator;
using godobject::GripSample;
using godobject::PivotCase;

std::vector<GripSample> read_grip(const std::string& file) {
  CsvReader reader(file, {"time", "load"});
  std::vector<GripSample> grip;
  while (reader.next()) {
    const GripSample sample{reader.number(0, finite), reader.number(1, non_negative)};
    if (!grip.empty() && !(sample.time > grip.back().time)) {
      throw reader.complaint(0,
                             "got '" + std::string(reader.text(0)) + "', expected a later time than in the row before");
    }
    grip.push_back(sample);
  }
  return grip;
}

std::vector<GripSample> read_release(const std::string& text) {
  double from = 0.0;
  double to = 0.0;
  double over = 0.0;
  read_key_values(text, {number_key("from", from, non_negative), number_key("to", to, non_negative),
                         number_key("over", over, positive)});
  return {{0.0, from}, {over, to}};
}

GripOperator read_operator(const std::string& text, UnitChecks& questions) {
  GripOperator hand;
  const auto positive_key = [](std::string_view key, std::optional<double>& value) {
    return KeyValue{key, [&value](std::string_view number) { value = read_number(number, positive); }, false};
  };
  const auto take_on_slide = [&](std::string_view word) {
    if (word != "regrip" && word != "keep")
      throw std::invalid_argument("got '" + std::string(word) + "', expected regrip|keep");
    hand.regrips_on_slide = word == "regrip";
  };
  const auto take_target = [&](std::string_view target) {
    angle_key("target", hand.target, positive).take(target);
    questions.angle("target", hand.target, target);
  };
  read_key_values(text, {{"target", take_target},
                         positive_key("load", hand.start_load),
                         positive_key("rate", hand.rate),
                         positive_key("regrip-rate", hand.regrip_rate),
                         number_key("speed", hand.speed, positive, false),
                         KeyValue{"on-slide", take_on_slide, false, "regrip|keep"}});
  return hand;
}

class Pivot final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"pivot", "Run the paper's experiment: a block turns between two fingers that loosen their grip",
            R"(The block starts level, its centre of mass left of the grip point; x points right, y up.
The paper gives mu_l, mu_r, case A (coupled), case B (uncoupled) and the level start. It does not give the block's
size, mass and offset, nor k_l, k_r, dampers, release rate and time step, so these defaults are our choice. Three
decide the result: in case A the rate and, with the radial projection, k_r; in both cases the offset, because in case
B the block turns only if the offset exceeds mu_r/mu_l.
Cases: coupled (ellipse, radial), uncoupled (box, closest point), exact (table, closest point). --curve and
--projection replace the case's; without --case they default to table and closest-point.
Grip: --grip FILE (linear between rows), --release from=1,to=0,over=4, or --operator
target=30deg[,load=N,rate=N/s,regrip-rate=N/s,speed=rad/s,on-slide=regrip|keep]. The operator loosens the grip until
the block turns, keeps it turning, and grips again at the target angle, or (unless on-slide=keep) once the block has
slid more than 2 mm and more than 20 mm per radian turned. Defaults: load=2*P0, rate=P0 and regrip-rate=10*P0 per
second. Without any of these, the grip falls from P0 to P0/2 in 10 s. P0 is 0.5 N, or 1.3 times the load that an
ellipse needs to hold the block, rounded up to two digits, if that is more.
Columns: time [s], x and y [m] of the centre of mass from the grip point, angle [rad], grip_slip [m] (how far the
block has slid past the fingers), load [N] of each finger, friction_force [N] and friction_moment [N m] of both
fingers, state (stick|slip|free|invalid; a note gives the reason), cor [m] of the slip (nan without slip), r [m] and
rho [rad] (from one finger's god-object to its goal after step b), and trial_r and trial_rho (the same before step b,
eq. 7).)",
            "limitcurve pivot --case coupled --material sandpaper --operator target=30deg"};
  }

  void declare(Options& options) override {
    options.named("--case", case_, godobject::pivot_case_names(), godobject::parse_pivot_case,
                  "Friction model: {}; optional with --curve, --projection or --radius-law");
    options.named("--curve", settings_.curve, godobject::curve_kind_names(), godobject::parse_curve_kind,
                  "Limit curve instead of the case's: {}");
    options.named("--projection", settings_.projection, godobject::projection_names, godobject::parse_projection,
                  "Projection instead of the case's: {}");
    options.radius_law(radius_law_);
    options.text("--material", material_, "MATERIAL",
                 "Coefficients of rayon, suede or sandpaper from Table 1 (data/materials.csv)");
    options.number("--mu", mu_, non_negative,
                   "Friction coefficient mu_l [1] (default: the material's, else sandpaper's)");
    options.number("--mu-r", mu_r_, non_negative,
                   "mu_r [m] instead of --radius-law (default: the material's, else sandpaper's)");
    options.text("--grip", grip_file_, "FILE", "Grip from a CSV file, columns time,load [s, N]");
    options.value(
        "--release", "LIST", [this](const std::string& text) { release_ = read_release(text); },
        "Grip that falls: from=N,to=N,over=SECONDS", Presence::optional);
    options.value(
        "--operator", "LIST",
        [this](const std::string& text) { settings_.grip_operator = read_operator(text, questions_); },
        "Grip by a simulated operator: target=ANGLE[,…]", Presence::optional);
    options.number("--mass", settings_.mass, positive, "Mass of the block [kg]");
    options.number("--offset", settings_.offset, non_negative,
                   "Distance along the block from grip to centre of mass [m]");
    options.number("--stiffness", settings_.stiffness, positive, "Stiffness k_l of each finger [N/m]");
    options.number("--twist-stiffness", settings_.twist_stiffness, positive,
                   "Torsional stiffness k_r of each finger [N m/rad] (default k_l (mu_r/mu_l)^2, best for radial)");
    options.number("--duration", settings_.duration, non_negative, "Duration [s]");
    options.law(settings_.law, Presence::optional);
    options.rare();
    options.number("--mu-dynamic", settings_.mu_dynamic, non_negative, "mu_l during slip [1] (default mu_l)");
    options.number("--mu-r-dynamic", settings_.mu_r_dynamic, non_negative,
                   "mu_r during slip [m] (default mu_r times mu-dynamic/mu)");
    options.number("--length", settings_.length, positive, "Length of the block [m]");
    options.number("--height", settings_.height, positive, "Height of the block [m]");
    options.number("--gravity", settings_.gravity, non_negative, "Gravity [m/s^2]");
    options.number("--damping", settings_.damping, non_negative, "Damping b_l of each finger [N s/m]");
    options.number("--twist-damping", settings_.twist_damping, non_negative,
                   "Damping b_r of each finger [N m s/rad] (default b_l k_r/k_l)");
    options.number("--time-step", settings_.time_step, positive, "Time step [s]");
    options.count("--every", every_, 1, 1'000'000'000, "Write a row every N time steps, beginning with the first");
    options.number("--tolerance", settings_.tolerance, positive, "Error of the table, in unit wrenches");
  }

  void run(const Results& results) override {
    if (!case_ && !settings_.curve && !settings_.projection && !radius_law_) {
      throw std::invalid_argument(
          "choose a friction model: --case coupled, uncoupled or exact, or your own by --curve, --projection or "
          "--radius-law");
    }
    if (settings_.law != nullptr) results.messages->say(settings_.law->remarks());
    settings_.kind = case_.value_or(PivotCase::exact);
    if (!material_.empty()) {
      const Material material = find_material(material_);
      settings_.mu = material.mu;
      settings_.mu_r = material.mu_r;
    }
    if (radius_law_ && mu_r_) check_moment(true, true);
    settings_.mu = mu_.value_or(settings_.mu);
    if (radius_law_) {
      if (settings_.law == nullptr) settings_.law = hertz();
      settings_.radius_law = radius_law_->of(settings_.mu, settings_.law);
      settings_.mu_r.reset();
    }
    if (mu_r_) settings_.mu_r = mu_r_;
    if (!grip_file_.empty() + !release_.empty() + settings_.grip_operator.has_value() > 1) {
      throw std::invalid_argument("give only one of --grip, --release and --operator");
    }
    settings_.grip = grip_file_.empty() ? release_ : read_grip(grip_file_);
    godobject::Pivot pivot(settings_);
    const CurveKind curve = settings_.limit_curve();
    const bool is_ellipse = curve == CurveKind::ellipse;
    results.warn_idle(
        {{"--law", !radius_law_ && (is_ellipse || curve == CurveKind::box)},
         {"--tolerance", curve != CurveKind::table},
         // In units of the standard k_r and b_r the ellipse is a circle, onto which all projections are one.
         {"--projection", is_ellipse && !radius_law_ && !settings_.twist_stiffness && !settings_.twist_damping &&
                              !settings_.mu_r_dynamic}},
        "pivot with this limit curve");
    describe(*results.messages, pivot);
    Rows rows(results, {"time", "x", "y", "angle", "grip_slip", "load", "friction_force", "friction_moment", "state",
                        "cor", "r", "rho", "trial_r", "trial_rho"});
    std::size_t step = 0;
    std::array loads{std::numeric_limits<double>::infinity(), 0.0};
    godobject::Fault fault = godobject::Fault::none;
    double since = 0.0;
    do {
      if (fault == godobject::Fault::none && pivot.row().fault != fault) {
        fault = pivot.row().fault;
        since = pivot.row().time;
      }
      const godobject::PivotRow& row = pivot.row();
      if (row.load > 0.0) loads = {std::min(loads[0], row.load), std::max(loads[1], row.load)};
      if (step++ % every_ != 0) continue;
      rows.row(row.time, row.x, row.y, row.angle, row.grip_slip, row.load, row.friction_force, row.friction_moment,
               godobject::to_string(row.state), row.cor, row.r, row.rho, row.trial_r, row.trial_rho);
    } while (pivot.step());
    rows.finish();
    if (fault != godobject::Fault::none) {
      results.messages->say("limitcurve: note: invalid from time " + format_number(since) +
                            " s on: " + std::string(to_string(fault)) + "; a smaller --time-step may help");
    }
    if (radius_law_) questions_.radii(settings_.radius_law, loads);
    questions_.source = "loads must be in newtons, and --mass in kg";
    questions_.load(loads[1]);
    results.messages->say(questions_.lines());
  }

 private:
  /// Notes and warnings that the user must know before using the rows.
  void describe(Messages& messages, const godobject::Pivot& pivot) const {
    if (settings_.curve == CurveKind::exact) {
      messages.say("limitcurve: exact: a table with an error of at most " + format_number(pivot.curve_error(), 3) +
                   " in unit wrenches");
    }
    const double load = pivot.row().load;
    const double needed = pivot.holding_load();
    if (load < needed) {
      messages.say("limitcurve: warning: the grip starts at " + format_number(load, 3) +
                   " N per finger, which does not hold the block; " +
                   (std::isfinite(needed) ? "it needs " + format_number(needed, 3) + " N" : "no load does"));
    }
  }

  std::optional<PivotCase> case_;
  std::optional<RadiusLawArgument> radius_law_;
  std::string material_;
  std::optional<double> mu_;
  std::optional<double> mu_r_;
  std::string grip_file_;
  std::vector<GripSample> release_;
  std::size_t every_ = 1;
  UnitChecks questions_;
  godobject::PivotOptions settings_;
};

}  // namespace

std::unique_ptr<Subcommand> make_pivot() {
  return std::make_unique<Pivot>();
}

}  // namespace limitcurve::cli
