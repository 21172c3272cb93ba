// SPDX-License-Identifier: MIT
#include "godobject/scene/choose_step.hpp"

#include "godobject/finger_curve.hpp"
#include "godobject/scene/scene_walk.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/number.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/validate/shipped_costs.hpp"
#include "limitcurve/validate/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace limitcurve::godobject {

namespace {

void check(const Scene& scene, double tolerance) {
  const auto positive = [](const char* name, double value, const char* unit) {
    if (!(value > 0.0 && value < 1e12)) throw out_of_range(name, value, unit, "0 < value < 1e12");
  };
  const auto not_negative = [](const char* name, double value, const char* unit) {
    if (!(value >= 0.0 && value < 1e12)) throw out_of_range(name, value, unit, "0 <= value < 1e12");
  };
  if (scene.law == nullptr) throw std::invalid_argument("law is not set: expected a pressure law");
  if (!(tolerance >= 1e-6 && tolerance <= 1.0))
    throw out_of_range("tolerance", tolerance, "1", "1e-6 <= tolerance <= 1");
  positive("mu", scene.mu, "1");
  if (scene.mu_r) positive("moment coefficient", *scene.mu_r, "m");
  positive("least load", scene.least_load, "N");
  if (!(scene.most_load >= scene.least_load && scene.most_load < 1e12)) {
    throw out_of_range("most load", scene.most_load, "N", "least load <= most load < 1e12");
  }
  positive("stiffness", scene.stiffness, "N/m");
  positive("twist stiffness", scene.twist_stiffness, "N m/rad");
  if (!(scene.sample_time >= 1e-6 && scene.sample_time <= 1.0)) {
    throw out_of_range("sample time", scene.sample_time, "s", "1e-6 <= sample time <= 1");
  }
  not_negative("slide speed", scene.slide_speed, "m/s");
  not_negative("twist rate", scene.twist_rate, "rad/s");
  if (!(scene.slide >= 0.0)) throw out_of_range("slide", scene.slide, "m", "slide >= 0");
  if (!(scene.twist >= 0.0)) throw out_of_range("twist", scene.twist, "rad", "twist >= 0");
  if ((scene.slide_speed == 0.0 || scene.slide == 0.0) && (scene.twist_rate == 0.0 || scene.twist == 0.0)) {
    throw std::invalid_argument("no motion: expected a slide speed and a slide > 0, or a twist rate and a twist > 0");
  }
}

/// Friction on the user in units of its present limits: (F_x/μP, F_y/μP, M/Γ).
using UnitFriction = Eigen::Vector3d;
using Record = std::vector<UnitFriction>;

/// Steps fingers through a scene's test motion.
class Drive {
 public:
  Drive(const Scene& scene, double moment_ratio)
      : scene_(scene), moment_ratio_(moment_ratio), walk_(walk(scene, moment_ratio)) {}

  /// The friction at the samples of the test motion, with `substeps` steps from one to the next. The load changes in
  /// the first of these steps.
  [[nodiscard]] Record operator()(const FingerCurve& curve, Projection projection, FingerParameters parameters,
                                  int substeps = 1) const {
    parameters.stiffness *= walk_.stiffening;
    parameters.twist_stiffness *= walk_.stiffening;
    Record record;
    record.reserve(walk_.samples.size());
    SoftFinger finger(curve, parameters, projection);
    WalkSample from = walk_.samples.front();
    for (const WalkSample& to : walk_.samples) {
      FingerOutput output;
      for (int i = 1; i <= substeps; ++i) {
        const double fraction = static_cast<double>(i) / substeps;
        const Eigen::Vector3d point(std::lerp(from.x, to.x, fraction), std::lerp(from.y, to.y, fraction), 0.0);
        output = finger.update({point, Eigen::Vector3d::UnitZ(), to.load / parameters.stiffness},
                               std::lerp(from.twist, to.twist, fraction));
      }
      const double force = scene_.mu * to.load;
      record.emplace_back(output.force.x() / force, output.force.y() / force,
                          output.moment / largest_moment(scene_, moment_ratio_, to.load));
      from = to;
    }
    return record;
  }
  /// The scene's sample time divided by that of the test motion.
  [[nodiscard]] double finest_step() const { return walk_.finest_step; }

 private:
  const Scene& scene_;
  double moment_ratio_;
  SceneWalk walk_;
};

Effect difference(const Record& one, const Record& other) {
  std::vector<double> each;
  for (std::size_t i = 0; i < one.size(); ++i) each.push_back((one[i] - other[i]).norm());
  std::sort(each.begin(), each.end());
  const auto quantile = [&](double fraction) {
    return each[static_cast<std::size_t>(fraction * static_cast<double>(each.size() - 1))];
  };
  return {quantile(0.5), quantile(0.99), each.back()};
}

FingerParameters parameters_of(const Scene& scene) {
  FingerParameters result;
  result.mu = scene.mu;
  result.radius_law = scene.radius_law;
  result.mu_r = scene.mu_r;
  result.stiffness = scene.stiffness;
  result.twist_stiffness = scene.twist_stiffness;
  result.max_speed = std::numeric_limits<double>::infinity();  // the scene's own scale: a leg may be 5 μP/k_l long
  return result;
}

std::vector<std::string> verdict_of(const Effects& effects, const std::vector<Candidate>& candidates,
                                    double tolerance) {
  const auto is_needed = [&](const Effect& effect) { return error_margin * effect.largest > tolerance; };
  const auto line = [](const char* what, const Effect& effect) {
    return std::string(what) + " " + in_percent(effect.median) + ", " + in_percent(effect.percentile_99) + ", " +
           in_percent(effect.largest);
  };
  const char* const needed = !is_needed(effects.torsion)    ? "no torsion is needed"
                             : !is_needed(effects.coupling) ? "uncoupled will do"
                                                            : "coupling is needed";
  std::vector<std::string> lines{
      std::string(needed) + ": decided by " + format_number(error_margin) +
          " times the largest change, because another motion may change more",
      "changes of the wrench in the test motion, in friction limits: median, 99th percentile, largest",
      line("without torsion:", effects.torsion),
      line("without coupling:", effects.coupling),
      line("with the radius of the mean load:", effects.load_radius),
      line("with the ellipse:", effects.curve),
      line("with the radial projection:", effects.projection)};
  if (effects.sampling.largest > tolerance) {
    lines.push_back("half the sample time would change " + in_percent(effects.sampling.largest) +
                    ": sample faster first");
  }
  const auto chosen =
      std::find_if(candidates.begin(), candidates.end(), [](const Candidate& one) { return one.chosen; });
  const auto best =
      std::min_element(candidates.begin(), candidates.end(),
                       [](const Candidate& one, const Candidate& other) { return one.error < other.error; });
  lines.push_back(chosen != candidates.end()
                      ? "cheapest: " + chosen->model + ", " + in_percent(chosen->error) + " with that factor"
                      : "no step is within the tolerance: the best is " + best->model + ", " + best->reason);
  return lines;
}

double step_cost(std::string_view curve, Projection projection) {
  const auto& step = shipped_costs::of(curve).step;
  static_assert(std::tuple_size_v<std::decay_t<decltype(step)>> == projection_names.size());
  return step.at(static_cast<std::size_t>(projection));
}

}  // namespace

StepChoice choose_step(const Scene& scene, double tolerance) {
  check(scene, tolerance);
  const ExactCurve exact(scene.law);
  const double m0 = exact.moment_ratio();
  const Drive drive(scene, m0);
  const FingerParameters true_finger = parameters_of(scene);
  static_cast<void>(ContactLimits(true_finger, m0));
  // An error ε of f and m is an error of at most ε(1 + 1/m₀) of the limits; the error of a table is its tolerance times
  // max(1, m₀). Count it in full: the test motion may have missed its maximum.
  const double per_table_error = 1.0 + 1.0 / m0;
  const double per_table_tolerance = per_table_error * std::max(1.0, m0);
  const Table reference = finest_table(scene.law, std::max(1e-6 * tolerance / per_table_tolerance, 1e-12));
  const FingerCurve fine = reference;
  const Record truth = drive(fine, Projection::closest_point, true_finger);
  const auto effect_of = [&](const FingerCurve& curve, Projection projection, const FingerParameters& finger) {
    return difference(drive(curve, projection, finger), truth);
  };
  FingerParameters slippery = true_finger;
  slippery.mu_r = 0.0;
  FingerParameters mean_finger = true_finger;
  mean_finger.radius_law = RadiusLaw::constant(scene.radius_law.radius(0.5 * (scene.least_load + scene.most_load)));
  const Ellipse ellipse = Ellipse::through_intercepts(m0);

  StepChoice result;
  result.effects.torsion = effect_of(fine, Projection::closest_point, slippery);
  result.effects.coupling = effect_of(box(1.0, m0), Projection::closest_point, true_finger);
  result.effects.load_radius = effect_of(fine, Projection::closest_point, mean_finger);
  result.effects.curve = effect_of(ellipse, Projection::closest_point, true_finger);
  result.effects.projection = effect_of(fine, Projection::radial, true_finger);
  // The error of a step is proportional to its length.
  result.effects.sampling = difference(drive(fine, Projection::closest_point, true_finger, 2), truth);
  for (double* change :
       {&result.effects.sampling.median, &result.effects.sampling.percentile_99, &result.effects.sampling.largest}) {
    *change *= drive.finest_step();
  }

  // Cost of a power of the load in a step [ns].
  constexpr double load_radius_cost = 20.0;
  const bool radius_varies = !scene.mu_r && scene.radius_law.depends_on_load();
  // Each ten times as fine as the one before.
  std::vector<Table> tables{finest_table(scene.law, std::clamp(0.1 * tolerance / per_table_tolerance,
                                                               Table::finest_tolerance, Table::coarsest_tolerance))};
  auto& candidates = result.candidates;
  std::map<std::string, ReplayOptions> steps;
  const auto error_of = [&](const FingerCurve& curve, double of_table, Projection projection,
                            const FingerParameters& finger) {
    return error_margin * effect_of(curve, projection, finger).largest +
           per_table_error * (reference.checked_error() + of_table);
  };
  /// The coarsest table whose error fits, because all cost the same; the first if the error is not the table's. None is
  /// so fine that the reference's own error counts beside its.
  const auto sufficient_table = [&](Projection projection, const FingerParameters& finger,
                                    double& error) -> const Table& {
    for (std::size_t i = 0;; ++i) {
      error = error_of(tables[i], tables[i].checked_error(), projection, finger);
      if (error <= tolerance || tables[i].tolerance() < 100.0 * reference.tolerance()) return tables[i];
      if (i == 0 && !(error_of(fine, 0.0, projection, finger) <= tolerance)) return tables[i];
      if (i + 1 == tables.size()) tables.push_back(finest_table(scene.law, 0.1 * tables[i].tolerance()));
    }
  };
  const auto add = [&](const std::string& model, CurveKind kind, Projection projection, const FingerParameters& finger,
                       double cost) {
    Candidate candidate{model, 1.0, 0.0, cost};
    switch (kind) {
      case CurveKind::box:
        candidate.parameter = std::numeric_limits<double>::infinity();
        candidate.error = error_of(box(1.0, m0), 0.0, projection, finger);
        break;
      case CurveKind::ellipse:
        candidate.error = error_of(ellipse, 0.0, projection, finger);
        break;
      case CurveKind::table:
      case CurveKind::exact:
        candidate.parameter = sufficient_table(projection, finger, candidate.error).tolerance();
    }
    steps[model] = {
        .law = scene.law, .curve = kind, .projection = projection, .tolerance = candidate.parameter, .finger = finger};
    candidates.push_back(candidate);
  };
  // A clamp of the force alone is cheaper than the other candidates.
  add("no torsion", CurveKind::ellipse, Projection::radial, slippery, 0.5 * step_cost("ellipse", Projection::radial));
  candidates.back().parameter = std::numeric_limits<double>::quiet_NaN();
  for (const CurveKind kind : {CurveKind::box, CurveKind::ellipse, CurveKind::table}) {
    for (std::size_t i = 0; i < projection_names.size(); ++i) {
      const auto projection = static_cast<Projection>(i);
      const double cost = step_cost(to_string(kind), projection);
      if (std::isnan(cost)) continue;
      const std::string model = std::string(to_string(kind)) + "/" + std::string(to_string(projection));
      add(model, kind, projection, mean_finger, cost);
      if (radius_varies) add(model + "/a(P)", kind, projection, true_finger, cost + load_radius_cost);
    }
  }

  choose_cheapest(candidates, tolerance);
  result.verdict = verdict_of(result.effects, candidates, tolerance);
  for (const Candidate& candidate : candidates) {
    if (candidate.chosen) result.chosen = steps.at(candidate.model);
  }
  return result;
}

}  // namespace limitcurve::godobject
