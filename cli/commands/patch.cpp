// SPDX-License-Identifier: MIT
#include "cli/commands/half_spaces.hpp"
#include "cli/commands/subcommands.hpp"
#include "cli/io/column_list.hpp"
#include "cli/io/csv_reader.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/contact/load_to_hold.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/patch/patch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

struct Slide {
  PatchTwist twist;
  PatchWrench wrench;
  double power;
  double error;
};

constexpr std::array slide_columns = std::to_array<ListedColumn<Slide>>({
    {"vx", of<&Slide::twist, &PatchTwist::vx>},
    {"vy", of<&Slide::twist, &PatchTwist::vy>},
    {"omega", of<&Slide::twist, &PatchTwist::omega>, "the twist"},
    {"fx", of<&Slide::wrench, &PatchWrench::fx>},
    {"fy", of<&Slide::wrench, &PatchWrench::fy>},
    {"moment", of<&Slide::wrench, &PatchWrench::moment>, "the wrench about the origin that keeps the patch sliding"},
    {"power", of<&Slide::power>, "mu P H [W], with H the power for mu P = 1"},
    {"error", of<&Slide::error>,
     "bound on the relative error of power, |dF|/(mu P) and |dM|/(mu P m0), a pure spin's moment"},
});

struct Slip {
  PatchWrench wrench;
  double load;
  PatchTwist twist;
  double error;
};

constexpr std::array slip_columns = std::to_array<ListedColumn<Slip>>({
    {"fx", of<&Slip::wrench, &PatchWrench::fx>},
    {"fy", of<&Slip::wrench, &PatchWrench::fy>},
    {"moment", of<&Slip::wrench, &PatchWrench::moment>, "the wrench; of a round contact force, moment"},
    {"hold_load", of<&Slip::load>, "the load that just holds it [N], inf if none does"},
    {"vx", of<&Slip::twist, &PatchTwist::vx>},
    {"vy", of<&Slip::twist, &PatchTwist::vy>},
    {"omega", of<&Slip::twist, &PatchTwist::omega>,
     "the slip at that load, scaled to a power of 1 W, nan for wrench 0 or if no load holds; of a round contact "
     "slide, spin"},
    {"error", of<&Slip::error>,
     "bound on |dF|/(mu P) and |dM|/(mu P m0) between the wrench and the one that this slip needs"},
});

/// A round contact has a force and a slide for fx, fy and vx, vy.
constexpr std::array round_slip_columns = std::to_array<ListedColumn<Slip>>({
    {"force", of<&Slip::wrench, &PatchWrench::fx>},
    slip_columns[2],
    slip_columns[3],
    {"slide", of<&Slip::twist, &PatchTwist::vx>},
    {"spin", of<&Slip::twist, &PatchTwist::omega>},
    slip_columns[7],
});

class PatchCommand final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "patch",
        "Contacts that are not round: wrench of a slip twist, slip under a wrench, or inequalities for a planner",
        R"(PATCH is points:FILE.csv (columns x,y,load), polygon:FILE.csv (x,y), rectangle:x=0.02,y=0.01 (full sides),
ellipse:law=hertz,a=0.004,b=0.002 (semi-axes), or image:FILE.csv,pixel=0.0005 (rows of pressures, first row at the
largest y, origin at the centre of pressure). Image options: pixel=0.004x0.005 along x and y (a Tekscan file brings
its own); columns=32 if each row is one flattened frame (also if a first row 8,8 gives the size); frame=2 selects a
frame; skip=1 if rows begin with a time; floor=P sets pressures up to P to 0 (default: 1.5 times the most negative). A
pixel that is empty, B or nan has no sensor. Append ,mx=...,my=... to multiply mu along x and y. Lengths are in
metres; loads and pressures may have any unit.
--twists: columns vx,vy,omega [m/s, rad/s], the velocity of the patch over the ground at the origin.
)" + ColumnList(slide_columns).help() +
            "--wrenches: columns fx,fy,moment [N, N m] about the origin.\n" + ColumnList(slip_columns).help() +
            R"(Where the limit surface is flat, the patch turns exactly about one of its points. error then leaves out
the force on that point, which may be anything up to its limit.
--half-spaces: inequalities inside the limit surface, and their vertices. Columns: kind; a row is fx F_x + fy F_y +
moment M <= mu N (units 1, 1, 1/m; N is the load); a vertex is a wrench for mu N = 1 (units 1, 1, m); share, the
polytope's radius over the limit surface's in the worst direction. There are 8, 14, 32, 62 or 128 rows.
--law instead of --patch: a round contact, with force,moment and slide,spin [m/s, rad/s].)",
        "limitcurve patch --patch rectangle:x=0.02,y=0.01 --twists data/patches/twists.csv --mu 0.5 --load 4"};
  }

  void declare(Options& options) override {
    options.text("--patch", patch_, "PATCH", "The contact (see below)");
    options.law(law_, Presence::optional);
    options.moment(moment_);
    options.text("--twists", twists_, "FILE", "CSV file of slip twists, or - for standard input");
    options.text("--wrenches", wrenches_, "FILE", "CSV file of wrenches, or - for standard input, instead of --twists");
    options.count("--half-spaces", half_spaces_, 8, 1'000'000,
                  "At most N inequalities, which do not depend on mu and load, instead of --twists");
    options.number("--mu", mu_, positive, "Friction coefficient mu");
    options.number("--load", load_, positive, "Normal load P [N] of --twists (default 1)");
  }

  void run(const Results& results) override {
    if (patch_.empty() == (law_ == nullptr)) throw std::invalid_argument(what_contact(!patch_.empty()));
    if (int{!twists_.empty()} + int{!wrenches_.empty()} + int{half_spaces_.has_value()} != 1) {
      throw std::invalid_argument("give one of --twists, --wrenches and --half-spaces");
    }
    if (load_ && twists_.empty()) throw std::invalid_argument("--load needs --twists; with --wrenches it is a result");
    if (law_ != nullptr) return slip_of_round_contact(results);
    if (moment_.given())
      throw std::invalid_argument(
          "--radius-law, --mu-r, --gamma have no effect with --patch, which has its own size and moments: leave them "
          "out");
    const Patch patch = read_patch(patch_, *results.messages);
    results.warn_idle({{"--mu", half_spaces_.has_value()}}, "--half-spaces, whose wrenches are in units of mu P");
    if (half_spaces_) return write_half_spaces(results, half_spaces(patch, *half_spaces_));
    if (!wrenches_.empty()) return slip(results, patch);
    UnitChecks questions;
    if (load_) questions.load(*load_);
    results.messages->say(questions.lines());
    const ColumnList list(slide_columns);
    Rows rows(results, list.names());
    const double limit = mu_ * load_.value_or(1.0);
    CsvReader reader(twists_, {"vx", "vy", "omega"});
    while (reader.next()) {
      const PatchTwist twist{reader.number(0, finite), reader.number(1, finite), reader.number(2, finite)};
      const PatchFriction friction = patch.about_origin(twist);
      const auto [fx, fy, moment] = friction.wrench;
      list.write(rows, {twist, {limit * fx, limit * fy, limit * moment}, limit * friction.power, friction.error});
    }
    rows.finish();
  }

 private:
  void slip(const Results& results, const Patch& patch) const {
    const ColumnList list(slip_columns);
    Rows rows(results, list.names());
    CsvReader reader(wrenches_, {"fx", "fy", "moment"});
    UnitChecks questions;
    while (reader.next()) {
      const PatchWrench wrench{reader.number(0, finite), reader.number(1, finite), reader.number(2, finite)};
      const auto [twist, gauge, error] = patch.slip(wrench);
      // A foot carries a large moment.
      if (patch.radius() < 0.05) questions.wrench(std::hypot(wrench.fx, wrench.fy), wrench.moment);
      questions.load(gauge / mu_);
      list.write(rows, {wrench, gauge / mu_, twist, error});
    }
    results.messages->say(questions.lines());
    rows.finish();
  }

  void slip_of_round_contact(const Results& results) {
    if (half_spaces_) throw std::invalid_argument("--half-spaces needs --patch; for a law see 'limitcurve help curve'");
    if (wrenches_.empty()) throw std::invalid_argument("--law needs --wrenches; for twists see 'limitcurve help eval'");
    moment_.check(law_, *results.messages);
    const ContactFriction contact = moment_.with(mu_, law_);
    const ExactCurve curve(law_);
    const RadiusLaw radius_law = contact.radius(curve.moment_ratio());
    std::array<double, 2> loads{infinite, 0.0};  // smallest and largest
    const ColumnList list(round_slip_columns);
    Rows rows(results, list.names());
    CsvReader reader(wrenches_, {"force", "moment"});
    UnitChecks questions;
    while (reader.next()) {
      const double force = reader.number(0, finite);
      const double moment = reader.number(1, finite);
      const double load = load_to_hold(curve, contact, force, moment);
      if (!(load > 0.0 && std::isfinite(load))) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        list.write(rows, {{force, 0.0, moment}, load, {nan, 0.0, nan}, nan});
        continue;
      }
      loads = {std::min(loads[0], load), std::max(loads[1], load)};
      questions.wrench(force, moment);
      const double radius = radius_law.radius(load);
      const double limit = mu_ * load;
      const UnitWrench wrench{std::fabs(force) / limit, std::fabs(moment) / (limit * radius)};
      const SlipTwist normal = curve.along(wrench).normal;
      const UnitWrench needed = curve.wrench(normal);
      const UnitWrench error = law_->evaluate(normal.cor()).error;
      const double power = limit * (wrench.force * normal.slide + wrench.moment * normal.spin);
      const double miss = std::max(std::fabs(needed.force - wrench.force) + error.force,
                                   (std::fabs(needed.moment - wrench.moment) + error.moment) / curve.moment_ratio());
      list.write(
          rows, {{force, 0.0, moment},
                 load,
                 {std::copysign(normal.slide / power, force), 0.0, std::copysign(normal.spin / power / radius, moment)},
                 miss});
    }
    if (loads[1] > 0.0) questions.radii(radius_law, loads);
    results.messages->say(questions.lines());
    rows.finish();
  }

  std::string patch_;
  Law law_;
  MomentArgument moment_;
  std::string twists_;
  std::string wrenches_;
  std::optional<std::size_t> half_spaces_;
  double mu_ = 1.0;
  std::optional<double> load_;
};

}  // namespace

std::unique_ptr<Subcommand> make_patch() {
  return std::make_unique<PatchCommand>();
}

}  // namespace limitcurve::cli
