// SPDX-License-Identifier: MIT
#include "godobject/pivot.hpp"

#include "cli/commands/subcommands.hpp"
#include "cli/io/csv_reader.hpp"
#include "cli/io/key_values.hpp"
#include "cli/io/materials.hpp"

#include <array>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

using godobject::GripOperator;
using godobject::GripSample;
using godobject::PivotCase;

constexpr std::array cases{PivotCase::coupled, PivotCase::uncoupled, PivotCase::exact};

std::vector<GripSample> read_grip(const std::string& file) {
  CsvReader reader(file, {"time", "load"});
  std::vector<GripSample> grip;
  while (reader.next()) {
    const GripSample sample{reader.number(0, finite), reader.number(1, non_negative)};
    if (!grip.empty() && !(sample.time > grip.back().time)) {
      throw reader.complaint(0, "got '" + std::string(reader.text(0)) + "', expected a later time than in the row before");
    }
    grip.push_back(sample);
  }
  return grip;
}

std::vector<GripSample> read_release(const std::string& text) {
  double from = 0.0;
  double to = 0.0;
  double over = 0.0;
  read_key_values(text, {number_key("from", from, non_negative), number_key("to", to, non_negative), number_key("over", over, positive)});
  return {{0.0, from}, {over, to}};
}

GripOperator read_operator(const std::string& text) {
  GripOperator hand;
  read_key_values(text, {angle_key("target", hand.target, positive), number_key("load", hand.start_load, positive, false),
                         number_key("rate", hand.rate, positive, false), number_key("regrip-rate", hand.regrip_rate, positive, false),
                         number_key("speed", hand.speed, positive, false)});
  return hand;
}

class Pivot final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"pivot", "The paper's experiment: a block turns between two fingers whose grip eases",
            "The block starts level, its centre of mass `offset` left of the grip point; x points right, y up.\n"
            "Cases: coupled (ellipse, radial), uncoupled (box, closest point), exact (table, closest point).\n"
            "Grip: --grip FILE (CSV time,load [s, N], linear in between), --release from=1,to=0,over=4 [N, N, s], or\n"
            "--operator target=30deg[,load=N,rate=N/s,regrip-rate=N/s,speed=rad/s], who lets go until the block turns, keeps\n"
            "it turning, and regrips at the target. Left out: a slow release.\n"
            "Columns: time [s]; x,y [m] of the centre of mass from the grip point; angle [rad]; grip_slip [m], how far the\n"
            "block has slid past the fingers; load of each finger [N]; friction_force [N] and friction_moment [N m] of both;\n"
            "state stick|slip|free; cor [m] of the slip (nan unless it slips).",
            "limitcurve pivot --case coupled --material sandpaper --operator target=30deg"};
  }

  void declare(Options& options) override {
    std::vector<std::string> names;
    for (const PivotCase kind : cases) names.emplace_back(godobject::to_string(kind));
    options.choice("--case", case_, names, "How friction is modelled", Presence::required);
    options.text("--material", material_, "NAME", "Coefficients from Table 1 (data/materials.csv): rayon, suede, sandpaper");
    options.number("--mu", mu_, non_negative, "Friction coefficient mu_l [1] (default: the material's, else sandpaper's)");
    options.number("--moment-coefficient", moment_coefficient_, non_negative, "mu_r [m] (default: the material's, else sandpaper's)");
    options.number("--mu-dynamic", settings_.mu_dynamic, non_negative, "mu_l while slipping [1] (mu_l if left out)");
    options.number("--moment-coefficient-dynamic", settings_.moment_coefficient_dynamic, non_negative,
                   "mu_r while slipping [m] (mu_r times mu-dynamic/mu if left out)");
    options.text("--grip", grip_file_, "FILE", "CSV with columns time,load");
    options.value(
        "--release", "LIST", [this](const std::string& text) { release_ = read_release(text); }, "from=N,to=N,over=SECONDS",
        Presence::optional);
    options.value(
        "--operator", "LIST", [this](const std::string& text) { settings_.grip_operator = read_operator(text); }, "target=ANGLE[,…]",
        Presence::optional);
    options.number("--length", settings_.length, positive, "Length of the block [m]");
    options.number("--height", settings_.height, positive, "Height of the block [m]");
    options.number("--mass", settings_.mass, positive, "Mass of the block [kg]");
    options.number("--offset", settings_.offset, non_negative, "Of the centre of mass from the grip point, along the block [m]");
    options.number("--gravity", settings_.gravity, non_negative, "Gravity [m/s^2]");
    options.number("--stiffness", settings_.stiffness, positive, "k_l of each finger [N/m]");
    options.number("--twist-stiffness", settings_.twist_stiffness, positive, "k_r of each finger [N m/rad] (default k_l (mu_r/mu_l)^2)");
    options.number("--damping", settings_.damping, non_negative, "b_l of each finger [N s/m]");
    options.number("--twist-damping", settings_.twist_damping, non_negative, "b_r of each finger [N m s/rad] (default b_l k_r/k_l)");
    options.number("--time-step", settings_.time_step, positive, "Time step [s]");
    options.number("--duration", settings_.duration, non_negative, "Duration [s]");
    options.count("--every", every_, 1, 1'000'000'000, "Rows to write: each Nth time step's, from the first on");
    options.law(settings_.law, Presence::optional);
    options.number("--tolerance", settings_.tolerance, positive, "Of the exact case's table, in unit wrenches");
  }

  void run(const Results& results) override {
    settings_.kind = cases.at(case_);
    if (!material_.empty()) {
      const Material material = find_material(material_);
      settings_.mu = material.mu;
      settings_.moment_coefficient = material.mu_r;
    }
    settings_.mu = mu_.value_or(settings_.mu);
    settings_.moment_coefficient = moment_coefficient_.value_or(settings_.moment_coefficient);
    if (!grip_file_.empty() + !release_.empty() + settings_.grip_operator.has_value() > 1) {
      throw std::invalid_argument("got several of --grip, --release and --operator, expected one");
    }
    settings_.grip = grip_file_.empty() ? release_ : read_grip(grip_file_);
    godobject::Pivot pivot(settings_);
    Rows rows(results, {"time", "x", "y", "angle", "grip_slip", "load", "friction_force", "friction_moment", "state", "cor"});
    std::size_t step = 0;
    do {
      if (step++ % every_ != 0) continue;
      const godobject::PivotRow& row = pivot.row();
      rows.row(row.time, row.x, row.y, row.angle, row.grip_slip, row.load, row.friction_force, row.friction_moment,
               godobject::to_string(row.state), row.cor);
    } while (pivot.step());
    rows.finish();
  }

 private:
  std::size_t case_ = 0;
  std::string material_;
  std::optional<double> mu_;
  std::optional<double> moment_coefficient_;
  std::string grip_file_;
  std::vector<GripSample> release_;
  std::size_t every_ = 1;
  godobject::PivotOptions settings_;
};

}  // namespace

std::unique_ptr<Subcommand> make_pivot() {
  return std::make_unique<Pivot>();
}

}  // namespace limitcurve::cli
