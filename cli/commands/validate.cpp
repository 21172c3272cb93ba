// SPDX-License-Identifier: MIT
#include "cli/commands/subcommands.hpp"
#include "cli/io/column_list.hpp"
#include "cli/io/csv_reader.hpp"
#include "cli/io/law_argument.hpp"
#include "cli/io/patch_argument.hpp"

#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/patch/disc_models.hpp"
#include "limitcurve/validate/remembering_law.hpp"
#include "limitcurve/validate/validate.hpp"
#ifdef LIMITCURVE_HAS_FIT
#include "fit/curve_fit.hpp"
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace limitcurve::cli {

namespace {

struct Judged {
  std::string law;
  std::string model;
  double parameter;
  CurveError error;
  std::optional<double> cor_error;
};

constexpr std::array judged_columns = std::to_array<ListedColumn<Judged>>({
    {"law", of<&Judged::law>, "the pressure law, or the patch"},
    {"model", of<&Judged::model>, "see below; with --points the file"},
    {"parameter", of<&Judged::parameter>, "of the model; with --points the number of points"},
    {"max_error", of<&Judged::error, &CurveError::max_error>, "the largest error, of either sign"},
    {"rms_error", of<&Judged::error, &CurveError::rms_error>,
     "root mean square; with --patch over centres of rotation in 128 directions at 121 distances, spaced "
     "logarithmically from 1e-3 to 1e3 m0 (m0 is the moment of a pure spin over mu P; of a patch with mx and my, over "
     "mu P 2 mx my/(mx + my))"},
    {"max_over_estimate", of<&Judged::error, &CurveError::max_over_estimate>,
     "the largest error where the model holds although the finger slips"},
    {"max_under_estimate", of<&Judged::error, &CurveError::max_under_estimate>,
     "the largest error where it slips although the finger can hold"},
    {"max_cor_error", of<&Judged::cor_error>,
     "the largest |c_model/c_exact - 1| (c: distance of the centre of rotation), inf if unbounded"},
});

class Validate final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"validate", "Compare ellipse, box, diamond and Padé model with the exact curve",
            "Errors compare radii on one ray of the paper's normalised plane (0.07 is 7 %).\n" +
                ColumnList(judged_columns).help() +
                R"(Models and their parameter: ellipse (through the intercepts), ellipse-least-squares and
ellipse-inner (inside the curve, with the smallest maximum error): the force semi-axis over mu P; box (separate
limits): inf, and diamond: 1, the exponent n of x^n + y^n = 1; pade (Zhuravlev's model, at its own twist, because it
has no normal): c/a at half the force. There is none for uniform-wear, whose force rises infinitely steeply from a
pure spin.
With --patch the contact is not round (see 'limitcurve patch'). Errors compare the friction power of model and patch
over all slip twists. Models and their parameter: disc:LAW (the law and radius with the smallest maximum error) and
disc-equal-area:LAW: the radius [m]; ellipsoid, with power sqrt((mx vx)^2 + (my vy)^2 + m0^2 w^2): m0 [m].
With --points: a file may have force,moment in units of mu P and mu P a (unless you give --mu, --load and --radius),
or, with --patch, fx,fy,moment about its origin. A column c adds max_cor_error, but leaves out points whose c has a
wrench within 1e-6 of theirs. With --law signs do not matter. Errors are gauge - 1; the gauge is 1 on the limit.)",
            "limitcurve validate --law hertz --law uniform"};
  }

  void declare(Options& options) override {
    options.repeated(
        "--law", "LAW", [this](const std::string& text) { laws_.push_back(read_law(text)); },
        "Pressure law, or samples:FILE.csv; may be repeated (default: all in 'limitcurve laws')", Presence::optional);
    options.repeated(
        "--patch", "PATCH", [this](const std::string& text) { patches_.push_back(text); },
        "A contact that is not round, instead of --law; may be repeated", Presence::optional);
    options.text("--points", file_, "FILE",
                 "CSV file of points of your limit curve, or - for standard input, instead of models");
    options.number("--mu", mu_, positive, "Friction coefficient that scales --points (default 1)");
    options.number("--load", load_, positive, "Normal load P [N] that scales --points (default 1)");
    options.number("--radius", radius_, positive, "Contact radius a [m] that scales --points under --law (default 1)");
  }

  void run(const Results& results) override {
    if (!laws_.empty() && !patches_.empty()) throw std::invalid_argument(what_contact(true));
    for (const Law& law : laws_) results.messages->say(law->remarks());
    if (!file_.empty()) return validate_points(results);
    if (mu_ || load_ || radius_) throw std::invalid_argument("--mu, --load, --radius need --points");
    if (!patches_.empty()) return validate_patches(results);
    if (laws_.empty()) {
      for (const std::string_view name : law_examples()) laws_.push_back(parse_law(name));
    }
    const ColumnList list(judged_columns);
    Rows rows(results, list.names());
    std::size_t done = 0;
    for (const Law& given : laws_) {
      const auto law = std::make_shared<const RememberingLaw>(given);
      results.messages->progress(static_cast<double>(done++) / static_cast<double>(laws_.size()));
      const auto row = [&](std::string_view model, double parameter, const CurveError& error) {
        list.write(rows, {law->name(), std::string(model), parameter, error, error.max_cor_error});
      };
      const ExactCurve exact(law);
      const auto ellipse = [&](std::string_view model, const Ellipse& curve) {
        row(model, curve.force_max(), curve_error(curve, exact));
      };
      ellipse("ellipse", Ellipse::through_intercepts(exact.moment_ratio()));
#ifdef LIMITCURVE_HAS_FIT
      ellipse("ellipse-least-squares", fit::fit_ellipse(law, fit::Criterion::least_squares).curve);
#endif
      ellipse("ellipse-inner", inner_ellipse(exact));
      row("box", std::numeric_limits<double>::infinity(), curve_error(box(1.0, exact.moment_ratio()), exact));
      row("diamond", 1.0, curve_error(diamond(1.0, exact.moment_ratio()), exact));
      const PadeModel pade = pade_model(exact);
      if (pade.force_cor() > 0.0) row("pade", pade.force_cor(), curve_error(pade, exact));  // not of uniform-wear
    }
    rows.finish();
  }

 private:
  void validate_patches(const Results& results) const {
    std::vector<std::pair<std::string, std::vector<DiscModel>>> found;
    for (const std::string& text : patches_) {
      results.messages->progress(static_cast<double>(found.size()) / static_cast<double>(patches_.size()));
      const Patch patch = read_patch(text, *results.messages);
      note_factor(*results.messages, patch);
      found.emplace_back(text, disc_models(patch));
    }
    const ColumnList list(judged_columns);
    Rows rows(results, list.names());
    for (const auto& [text, found_models] : found) {
      for (const auto& [name, parameter, error] : found_models)
        list.write(rows, {text, name, parameter, error, error.max_cor_error});
    }
    rows.finish();
  }

  /// A c whose unit wrench is as close as this to that of the point is right: six digits of force and moment tell no
  /// more, least near the ends, where large changes of c change neither.
  static constexpr double same_wrench = 1e-6;

  /// A point of a curve that is to be judged.
  struct Point {
    PatchWrench wrench;  ///< of a round contact its force is fx
    double cor;
  };

  void validate_points(const Results& results) const {
    const bool is_round = patches_.empty();
    if (is_round && laws_.empty())
      throw std::invalid_argument("--points needs --law or --patch to compare the points with");
    if (!is_round && radius_)
      throw std::invalid_argument("--radius has no effect with --patch, which has its own size: leave it out");
    CsvReader reader(
        file_, is_round ? std::vector<std::string>{"force", "moment"} : std::vector<std::string>{"fx", "fy", "moment"},
        is_round ? std::vector<std::string>{"c"} : std::vector<std::string>{});
    const bool has_cor = is_round && reader.has(2);
    std::vector<Point> points;
    while (reader.next()) {
      const auto number = [&](std::size_t i) { return reader.number(i, finite); };
      points.push_back(
          is_round ? Point{{number(0), 0.0, number(1)}, has_cor ? std::fabs(reader.number(2, signed_distance)) : 0.0}
                   : Point{{number(0), number(1), number(2)}, 0.0});
      const auto [fx, fy, moment] = points.back().wrench;
      if (fx == 0.0 && fy == 0.0 && moment == 0.0)
        throw reader.complaint(0, "force and moment are 0, expected a point of the limit curve");
    }
    const ColumnList list(judged_columns);
    Rows rows(results, list.names());
    const double limit = mu_.value_or(1.0) * load_.value_or(1.0);
    const auto row = [&](const std::string& name, const std::function<double(const Point&, CurveError&)>& gauge) {
      CurveError error;
      double squares = 0.0;
      for (const Point& point : points) {
        const double excess = gauge(point, error) - 1.0;
        error.max_over_estimate = std::max(error.max_over_estimate, excess);
        error.max_under_estimate = std::max(error.max_under_estimate, -excess);
        squares += excess * excess;
      }
      error.max_error = std::max(error.max_over_estimate, error.max_under_estimate);
      error.rms_error = std::sqrt(squares / static_cast<double>(points.size()));
      list.write(rows, {name, file_, static_cast<double>(points.size()), error,
                        has_cor ? std::optional(error.max_cor_error) : std::nullopt});
    };
    for (const std::string& text : patches_) {
      const Patch patch = read_patch(text, *results.messages);
      row(text, [&](const Point& point, CurveError&) { return load_to_hold(patch, limit, point.wrench); });
    }
    for (const Law& law : laws_) {
      const ExactCurve exact(law);
      const double radius = radius_.value_or(1.0);
      row(law->name(), [&](const Point& point, CurveError& error) {
        const UnitWrench wrench{std::fabs(point.wrench.fx) / limit, std::fabs(point.wrench.moment) / (limit * radius)};
        const RadialPoint on_curve = exact.along(wrench);
        const double cor = radius * on_curve.normal.cor();
        const UnitWrench given =
            exact.wrench(std::isinf(point.cor) ? SlipTwist{1.0, 0.0} : SlipTwist{point.cor, radius});
        if (has_cor &&
            std::hypot(given.force - on_curve.wrench.force, given.moment - on_curve.wrench.moment) > same_wrench) {
          error.max_cor_error = std::max(
              error.max_cor_error, cor == 0.0 || std::isinf(point.cor) ? infinite : std::fabs(point.cor / cor - 1.0));
        }
        return gauge_from(wrench, on_curve.wrench);
      });
    }
    rows.finish();
  }

  std::vector<Law> laws_;
  std::vector<std::string> patches_;
  std::string file_;
  std::optional<double> mu_;
  std::optional<double> load_;
  std::optional<double> radius_;
};

}  // namespace

std::unique_ptr<Subcommand> make_validate() {
  return std::make_unique<Validate>();
}

}  // namespace limitcurve::cli
