// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/column_list.hpp"
#include "cli/io/csv_reader.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/unit_checks.hpp"

#include "limitcurve/contact/load_to_hold.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/measured/hold_error.hpp"
#include "limitcurve/patch/patch.hpp"
#include "limitcurve/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

namespace limitcurve::cli {

namespace {

/// What a contact must bear.
struct Need {
  double fx = 0.0;
  double fy = 0.0;
  double moment = 0.0;
};

struct Held {
  Need need;
  double load;
  double margin;
  double error;
};

/// What the contact must bear, and the load that holds it.
ColumnList<Held> hold_columns(bool is_round) {
  static constexpr std::array round = std::to_array<ListedColumn<Held>>({
      {"force", of<&Held::need, &Need::fx>},
      {"moment", of<&Held::need, &Need::moment>, "[N, N m]; with --patch fx, fy, moment"},
  });
  static constexpr std::array patch = std::to_array<ListedColumn<Held>>({
      {"fx", of<&Held::need, &Need::fx>},
      {"fy", of<&Held::need, &Need::fy>},
      {"moment", of<&Held::need, &Need::moment>},
  });
  static constexpr std::array load = std::to_array<ListedColumn<Held>>({
      {"hold_load", of<&Held::load>, "[N] of one contact (of a patch the total over its points), inf if no load holds"},
  });
  return (is_round ? ColumnList(round) : ColumnList(patch)).add(load);
}

constexpr std::array margin_column = std::to_array<ListedColumn<Held>>({
    {"margin", of<&Held::margin>,
     "if --data has a column load: 1 if the contact uses no friction at that load, 0 if it slips"},
});
constexpr std::array error_column = std::to_array<ListedColumn<Held>>({
    {"hold_error", of<&Held::error>,
     "[N], if --law is measured: the estimated error of hold_load, because the pressure is sampled"},
});

class Hold final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {
        "hold", "Find how hard to grip: the smallest load that carries a force and a moment without slip",
        R"(First describe the contact by --mu, --law, and --radius-law or --mu-r. Then say what it must carry:
  (1) --force and --moment, whose signs do not matter
  (2) --data, with one force and moment per row
  (3) --mass m and --offset l: N fingers hold an object level. Each carries m g/N and m g l/N.
Contacts that are not round: give --patch P instead of --law and --radius-law (see 'limitcurve patch'). --force is
then FX,FY, --data has the columns fx,fy,moment, moments are about the patch's origin, and signs matter. With --mass,
gravity pulls along --down, and the centre of mass is --offset from the origin towards (-Y, X), by default positive x.
)" + hold_columns(true).add(margin_column).add(error_column).help(),
        "limitcurve hold --law hertz --radius-law hertz:R=0.008,E=2e5 --mu 0.8 --fingers 2 --mass 0.2 --offset 0.02"};
  }

  void declare(Options& options) override {
    options.law(law_, Presence::optional);
    options.moment(torsion_);
    options.named("--curve", curve_, godobject::curve_kind_names(), godobject::parse_curve_kind,
                  "Limit curve: {}; ellipse and box with --mu-r need no --law");
    options.text("--patch", patch_, "PATCH", "A contact that is not round, instead of --law and --radius-law");
    options.number("--mu", mu_, non_negative, "Friction coefficient mu [1]", Presence::required);
    options.numbers("--force", force_, finite, "Friction force F to carry [N]; with --patch FX,FY", Presence::optional);
    options.number("--moment", moment_, finite, "Friction moment M to carry [N m]");
    options.text("--data", data_, "FILE",
                 "CSV file of forces and moments, or - for standard input, instead of --force and --moment");
    options.file_columns(columns_);
    options.least_load(columns_);
    options.count("--fingers", fingers_, 1, 100,
                  "Number of fingers that hold an object, instead of --force and --moment (default 2)");
    options.number("--mass", mass_, positive, "Mass m of the object [kg]");
    options.number("--offset", offset_, finite, "Horizontal distance l from the grip to its centre of mass [m]");
    options.numbers("--down", down_, finite, "Direction of gravity X,Y, if --patch and --mass are given (default 0,-1)",
                    Presence::optional);
    options.number("--gravity", gravity_, non_negative, "Gravity g [m/s^2]");
  }

  void run(const Results& results) override {
    const godobject::CurveKind kind = curve_;
    if (patch_.empty()) law_ = law_if_needed(law_, kind, torsion_.mu_r.has_value());
    if (patch_.empty() == (law_ == nullptr)) throw std::invalid_argument(what_contact(!patch_.empty(), true));
    const int given = static_cast<int>(!force_.empty() || moment_) + static_cast<int>(!data_.empty()) +
                      static_cast<int>(fingers_ || mass_ || offset_);
    if (given != 1)
      throw std::invalid_argument(std::string(given == 0 ? "say what the contact must carry: " : "give only one of ") +
                                  "--force and --moment, or --data, or --mass, --offset and --fingers");
    columns_.messages = results.messages;
    if (data_.empty() && !columns_.names.empty()) throw std::invalid_argument("--columns needs --data");
    columns_.check_zero();
    if (data_.empty() && columns_.least_load) throw std::invalid_argument("--least-load needs --data");
    if (mass_ && columns_.given())
      throw std::invalid_argument("--units has no effect on --mass and --offset, which are in kg and m: leave it out");
    if (mass_) questions_.source = "--mass is in kg and --offset in m";
    if (!down_.empty() && (patch_.empty() || !mass_)) throw std::invalid_argument("--down needs --patch and --mass");
    results.warn_idle({{"--gravity", !fingers_ && !mass_ && !offset_}}, "hold without --mass");
    results.warn_idle({{"--law", patch_.empty() && law_if_needed(nullptr, kind, torsion_.mu_r.has_value()) != nullptr &&
                                     law_->profile_error() == 0.0}},
                      "hold with this --curve and --mu-r");
    if (data_.empty()) columns_.warn_idle_units({"force", "moment"}, "--force and --moment");
    if (patch_.empty()) {
      torsion_.check(law_, *results.messages);
      // Without friction no radius matters, and measured moments give none.
      const ContactFriction contact =
          mu_ > 0.0 ? torsion_.with(mu_, law_) : ContactFriction{0.0, RadiusLaw::constant(1e-3)};
      if (kind == godobject::CurveKind::exact) {
        hold_round(results, ExactCurve(law_), contact, kind);
      } else {
        hold_round(results, make_finger_curve(kind, law_, 1e-8), contact, kind);
      }
      results.messages->say(questions_.lines());
      return;
    }
    if (torsion_.given())
      throw std::invalid_argument(
          "--radius-law, --mu-r, --gamma have no effect with --patch, which has its own size and moments: leave them "
          "out");
    if (results.has("--curve"))
      throw std::invalid_argument("--curve has no effect with --patch, which is its own limit surface: leave it out");
    const Patch patch = read_patch(patch_, *results.messages);
    const auto least = [&](const Need& need) { return load_to_hold(patch, mu_, {need.fx, need.fy, need.moment}); };
    write(results, least, [&](const Need& need, double load) { return least(need) / load; }, {});
    results.messages->say(questions_.lines());
  }

 private:
  template <class Curve>
  void hold_round(const Results& results, const Curve& curve, const ContactFriction& contact,
                  godobject::CurveKind kind) {
    const RadiusLaw radius_law = contact.radius(curve.moment_ratio());
    const bool is_closed = kind == godobject::CurveKind::ellipse || kind == godobject::CurveKind::box;
    std::function<double(const Need&, double)> error;
    if (law_->profile_error() > 0.0) {
      error = [&](const Need& need, double load) {
        return hold_error(curve, *law_, contact, load, need.fx, need.moment, is_closed);
      };
    }
    // By quadrature a row costs up to some ms, a table up to some seconds.
    constexpr std::size_t rows_of_a_table = 500;
    const bool may_be_slow = kind == godobject::CurveKind::exact && !law_->closed(1);
    std::size_t rows = 0;
    std::optional<godobject::FingerCurve> table;
    write(
        results,
        [&](const Need& need) {
          if (may_be_slow && ++rows == rows_of_a_table) table = finest_table(law_, 1e-11);
          return table ? load_to_hold(*table, contact, need.fx, need.moment)
                       : load_to_hold(curve, contact, need.fx, need.moment);
        },
        [&](const Need& need, double load) {
          const double limit = mu_ * load;
          const UnitWrench wrench{std::fabs(need.fx) / limit,
                                  std::fabs(need.moment) / (limit * radius_law.radius(load))};
          return table ? table->gauge(wrench) : curve.gauge(wrench);
        },
        error);
    if (loads_[1] > 0.0) questions_.radii(radius_law, loads_);
  }

  /// `least(need)` is the load that holds, `gauge(need, load)` the fraction of the limit at a load, `error(need, load)`
  /// the error of the load that holds, if the law is measured.
  void write(const Results& results, const std::function<double(const Need&)>& least,
             const std::function<double(const Need&, double)>& gauge,
             const std::function<double(const Need&, double)>& error) {
    const bool is_round = patch_.empty();
    std::vector<std::string> columns =
        is_round ? std::vector<std::string>{"force", "moment"} : std::vector<std::string>{"fx", "fy", "moment"};
    std::optional<CsvReader> reader;
    if (!data_.empty()) reader.emplace(data_, columns, std::vector<std::string>{"load"}, columns_);
    const std::size_t load_column = columns.size();
    const bool has_loads = reader && reader->has(load_column);
    ColumnList list = hold_columns(is_round);
    if (has_loads) list.add(margin_column);
    if (error) list.add(error_column);
    Rows rows(results, list.names());
    const auto row = [&](const Need& need, std::optional<double> load) {
      questions_.wrench(std::hypot(need.fx, need.fy), need.moment);
      if (load) {
        questions_.load(*load);
        questions_.force_under(*load, std::hypot(need.fx, need.fy));
      }
      const double hold = least(need);
      questions_.load(hold);
      const auto use = [this](double one) { loads_ = {std::min(loads_[0], one), std::max(loads_[1], one)}; };
      if (hold > 0.0 && std::isfinite(hold)) use(hold);
      const auto margin = [&] {
        if (hold == 0.0) return 1.0;
        if (*load == 0.0 || mu_ == 0.0) return 0.0;
        use(*load);
        return std::max(0.0, 1.0 - gauge(need, *load));
      };
      list.write(rows, {need, hold, load ? margin() : 0.0, error ? error(need, hold) : 0.0});
    };
    if (!reader) {
      row(single(), std::nullopt);
    } else {
      while (reader->next()) {
        const auto number = [&](std::size_t i) { return reader->number(i, finite); };
        const Need need = is_round ? Need{number(0), 0.0, number(1)} : Need{number(0), number(1), number(2)};
        row(need, has_loads ? std::optional(reader->number(load_column, non_negative)) : std::nullopt);
        if (reader->share()) results.messages->progress(*reader->share());
      }
    }
    rows.finish();
  }

  [[nodiscard]] Need single() const {
    if (fingers_ || mass_ || offset_) {
      if (!mass_) throw std::invalid_argument("--mass is missing: --offset or --fingers needs it");
      if (!offset_) throw std::invalid_argument("--offset is missing: --mass needs it");
      const double weight = *mass_ * gravity_ / static_cast<double>(fingers_.value_or(2));
      if (patch_.empty()) return {weight, 0.0, weight * *offset_};
      const std::vector<double> down = down_.empty() ? std::vector{0.0, -1.0} : down_;
      const double length = down.size() == 2 ? std::hypot(down[0], down[1]) : 0.0;
      if (!(length > 0.0)) throw std::invalid_argument("--down: give two numbers X,Y that are not both 0");
      return {weight * down[0] / length, weight * down[1] / length, 0.0 - weight * *offset_};
    }
    const std::size_t expected = patch_.empty() ? 1 : 2;
    if (!force_.empty() && force_.size() != expected) {
      throw std::invalid_argument(
          "--force: got " + std::to_string(force_.size()) + " numbers, expected " +
          (expected == 1 ? "1, the size of the friction force; two components need --patch" : "2, FX,FY"));
    }
    if (force_.empty()) throw std::invalid_argument("--force is missing: --moment needs it");
    if (!moment_) throw std::invalid_argument("--moment is missing: --force needs it");
    const double unit = columns_.scale("force");
    return {unit * force_[0], expected == 2 ? unit * force_[1] : 0.0, columns_.scale("moment") * *moment_};
  }

  Law law_;
  MomentArgument torsion_;
  godobject::CurveKind curve_ = godobject::CurveKind::exact;
  std::string patch_;
  double mu_ = 0.0;
  std::vector<double> force_;
  std::optional<double> moment_;
  std::string data_;
  FileColumns columns_;
  std::optional<std::size_t> fingers_;
  std::optional<double> mass_;
  std::optional<double> offset_;
  std::vector<double> down_;
  double gravity_ = 9.81;
  UnitChecks questions_;
  std::array<double, 2> loads_{std::numeric_limits<double>::infinity(), 0.0};  ///< smallest and largest with a radius
};

}  // namespace

std::unique_ptr<Subcommand> make_hold() {
  return std::make_unique<Hold>();
}

}  // namespace limitcurve::cli
