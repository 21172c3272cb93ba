// SPDX-License-Identifier: MIT
#include "godobject/choose_step.hpp"

#include "godobject/finger_curve.hpp"
#include "godobject/soft_finger.hpp"
#include "limitcurve/approximations.hpp"
#include "limitcurve/exact_curve.hpp"
#include "limitcurve/internal/shipped_costs.hpp"
#include "limitcurve/number.hpp"
#include "limitcurve/table.hpp"
#include "limitcurve/validate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

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
  if (!(tolerance >= 1e-6 && tolerance <= 1.0)) throw out_of_range("tolerance", tolerance, "1", "1e-6 <= tolerance <= 1");
  positive("mu", scene.mu, "1");
  if (scene.moment_coefficient) positive("moment coefficient", *scene.moment_coefficient, "m");
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
  if (scene.slide_speed == 0.0 && scene.twist_rate == 0.0) {
    throw std::invalid_argument("slide speed and twist rate are both 0: expected a motion");
  }
}

/// Where the finger is at a time of one motion.
struct Pose {
  double x;
  double twist;
  double depth;
};

/// Forth and back between 0 and `most`, at unit speed.
double triangle(double way, double most) {
  if (most == 0.0) return 0.0;
  const double phase = way / most - 2.0 * std::floor(0.5 * way / most);
  return most * (phase <= 1.0 ? phase : 2.0 - phase);
}

/// What is felt, in units of what the contact bears at that moment.
struct Felt {
  double force;
  double moment;
};
using Record = std::vector<Felt>;

/// The motions of a scene, and the scales by which what is felt is judged.
class Motions {
 public:
  Motions(const Scene& scene, double moment_ratio) : scene_(scene), moment_ratio_(moment_ratio) {
    // Long enough for the springs to be wound up and the start forgotten, twice over for the way back; and for the load to swing.
    const double load = scene.most_load;
    const double force_reach = scene.mu * load / scene.stiffness;
    const double moment_reach = moment_of(load) / scene.twist_stiffness;
    constexpr double lengths = 8.0;
    double duration = 0.0;
    const double quarter = 0.25;
    if (scene.slide_speed > 0.0) duration = std::max(duration, lengths * force_reach / (quarter * scene.slide_speed));
    if (scene.twist_rate > 0.0) duration = std::max(duration, lengths * moment_reach / (quarter * scene.twist_rate));
    constexpr double most_samples = 4000.0;
    duration_ = std::max(2.0 * duration, 100.0 * scene.sample_time);
    step_ = std::max(scene.sample_time, duration_ / most_samples);
    for (const double slide : {0.0, 0.25, 1.0}) {
      for (const double twist : {0.0, 0.25, 1.0}) {
        if (slide * scene.slide_speed > 0.0 || twist * scene.twist_rate > 0.0) motions_.push_back({slide, twist});
      }
    }
  }

  /// Γ at a load [N m].
  [[nodiscard]] double moment_of(double load) const {
    return scene_.moment_coefficient ? *scene_.moment_coefficient * load
                                     : moment_ratio_ * scene_.mu * load * scene_.radius_law.radius(load);
  }

  /// Drives a finger; the record is at whole sample times, however many steps there are between.
  [[nodiscard]] Record drive(const FingerCurve& curve, Projection projection, const FingerParameters& parameters, int substeps = 1) const {
    Record record;
    const double mean = 0.5 * (scene_.least_load + scene_.most_load);
    const double swing = 0.5 * (scene_.most_load - scene_.least_load);
    const int samples = static_cast<int>(duration_ / step_);
    for (const auto& [slide, twist] : motions_) {
      SoftFinger finger(curve, parameters, projection);
      for (int i = 0; i <= samples * substeps; ++i) {
        const double time = step_ * i / substeps;
        const double load = mean + swing * std::sin(2.0 * std::numbers::pi * 3.0 * time / duration_);
        const auto forth_and_back = [&](double speed, double most) {
          return triangle(speed * time, std::min(most, 0.5 * speed * duration_));
        };
        const Pose pose{forth_and_back(slide * scene_.slide_speed, scene_.slide), forth_and_back(twist * scene_.twist_rate, scene_.twist),
                        load / scene_.stiffness};
        const FingerOutput output = finger.update({{pose.x, 0.0, 0.0}, {0.0, 0.0, 1.0}, pose.depth}, pose.twist);
        if (i % substeps == 0) record.push_back({output.force.x() / (scene_.mu * load), output.moment / moment_of(load)});
      }
    }
    return record;
  }

 private:
  struct Shares {
    double slide;
    double twist;
  };
  const Scene& scene_;
  double moment_ratio_;
  double duration_ = 0.0;
  double step_ = 0.0;
  std::vector<Shares> motions_;
};

double largest_difference(const Record& one, const Record& other) {
  double result = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    result = std::max(result, std::hypot(one[i].force - other[i].force, one[i].moment - other[i].moment));
  }
  return result;
}

FingerParameters parameters_of(const Scene& scene) {
  FingerParameters result;
  result.mu = scene.mu;
  result.radius_law = scene.radius_law;
  result.moment_coefficient = scene.moment_coefficient;
  result.stiffness = scene.stiffness;
  result.twist_stiffness = scene.twist_stiffness;
  return result;
}

std::string verdict_of(const Effects& effects, const Candidate& chosen, double tolerance) {
  std::string text = effects.torsion <= tolerance    ? "no torsion is needed"
                     : effects.coupling <= tolerance ? "uncoupled will do"
                                                     : "coupling is needed";
  text += ". Of what the contact bears, " + in_percent(effects.torsion) + " would change without torsion, " + in_percent(effects.coupling) +
          " without coupling, " + in_percent(effects.load_radius) + " with the radius of the mean load, " + in_percent(effects.curve) +
          " with the ellipse, " + in_percent(effects.projection) + " with the radial projection; tolerance " + in_percent(tolerance) +
          ". Cheapest: " + chosen.model + ", off by " + in_percent(chosen.error);
  if (effects.sampling > tolerance) {
    text += ". But half the sample time would change " + in_percent(effects.sampling) + ": sample faster first";
  }
  return text;
}

}  // namespace

StepChoice choose_step(const Scene& scene, double tolerance) {
  check(scene, tolerance);
  const ExactCurve exact(scene.law);
  const double m0 = exact.moment_ratio();
  const Motions motions(scene, m0);
  const FingerParameters true_finger = parameters_of(scene);
  const FingerCurve fine = Table::build(scene.law, std::max(1e-4 * tolerance, 1e-9));
  const Record truth = motions.drive(fine, Projection::closest_point, true_finger);
  const auto error_of = [&](const FingerCurve& curve, Projection projection, const FingerParameters& finger) {
    return largest_difference(motions.drive(curve, projection, finger), truth);
  };
  FingerParameters slippery = true_finger;
  slippery.moment_coefficient = 0.0;
  FingerParameters mean_finger = true_finger;
  mean_finger.radius_law = RadiusLaw::constant(scene.radius_law.radius(0.5 * (scene.least_load + scene.most_load)));
  const Ellipse ellipse = Ellipse::through_intercepts(m0);

  StepChoice result;
  result.effects.torsion = error_of(fine, Projection::closest_point, slippery);
  result.effects.coupling = error_of(box(1.0, m0), Projection::closest_point, true_finger);
  result.effects.load_radius = error_of(fine, Projection::closest_point, mean_finger);
  result.effects.curve = error_of(ellipse, Projection::closest_point, true_finger);
  result.effects.projection = error_of(fine, Projection::radial, true_finger);
  result.effects.sampling = largest_difference(motions.drive(fine, Projection::closest_point, true_finger, 2), truth);

  // What a power of the load costs in a step, [ns].
  constexpr double load_radius_cost = 20.0;
  const bool radius_varies =
      !scene.moment_coefficient && scene.radius_law.radius(scene.least_load) != scene.radius_law.radius(scene.most_load);
  auto& candidates = result.candidates;
  const auto add = [&](const std::string& model, double parameter, const FingerCurve& curve, Projection projection, double cost) {
    candidates.push_back({model, parameter, error_of(curve, projection, mean_finger), cost});
    if (radius_varies)
      candidates.push_back({model + "/a(P)", parameter, error_of(curve, projection, true_finger), cost + load_radius_cost});
  };
  const auto add_both = [&](const char* model, double parameter, const FingerCurve& curve) {
    const shipped_costs::Cost& cost = shipped_costs::of(model);
    add(std::string(model) + "/radial", parameter, curve, Projection::radial, cost.radial);
    add(std::string(model) + "/closest-point", parameter, curve, Projection::closest_point, cost.closest_point);
  };
  const double none = std::numeric_limits<double>::quiet_NaN();
  // A clamp of the force alone is less than any of the others.
  candidates.push_back({"no torsion", none, result.effects.torsion, 0.5 * shipped_costs::of("ellipse").radial});
  add("box/closest-point", std::numeric_limits<double>::infinity(), box(1.0, m0), Projection::closest_point,
      shipped_costs::of("box").closest_point);
  add_both("ellipse", 1.0, ellipse);
  const Quartic quartic = minimax_quartic(exact);
  add_both("quartic", quartic.kappa(), make_finger_curve(CurveKind::quartic, scene.law, tolerance).curve);
  const Superellipse superellipse = minimax_superellipse(exact);
  add_both("superellipse", superellipse.exponent(), make_finger_curve(CurveKind::superellipse, scene.law, tolerance).curve);
  const double table_tolerance = std::clamp(0.1 * tolerance, Table::finest_tolerance, Table::coarsest_tolerance);
  add_both("table", table_tolerance, Table::build(scene.law, table_tolerance));

  choose_cheapest(candidates, tolerance);
  const auto best = std::find_if(candidates.begin(), candidates.end(), [](const Candidate& candidate) { return candidate.chosen; });
  result.verdict = verdict_of(result.effects, *best, tolerance);
  return result;
}

}  // namespace limitcurve::godobject
