// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/replay.hpp"
#include "limitcurve/contact_radius.hpp"
#include "limitcurve/pressure_law.hpp"
#include "limitcurve/validate.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace limitcurve::godobject {

/// What is known of a scene before it runs: its contact, and how the finger will move at most.
struct Scene {
  Law law = {};                                            ///< pressure law; must be set
  double mu = 0.5;                                         ///< μ > 0
  RadiusLaw radius_law = RadiusLaw::constant(0.005);       ///< a(P)
  std::optional<double> moment_coefficient = {};           ///< μ_r [m] > 0: Γ = μ_r P whatever the radius law
  double least_load = 0.5;                                 ///< [N] > 0
  double most_load = 2.0;                                  ///< [N] ≥ least_load
  double stiffness = 1000.0;                               ///< k_l [N/m] > 0
  double twist_stiffness = 0.04;                           ///< k_r [N m/rad] > 0
  double sample_time = 1e-3;                               ///< T [s], 1e-6 … 1
  double slide_speed = 0.05;                               ///< largest sliding speed [m/s] ≥ 0
  double twist_rate = 1.0;                                 ///< largest rate of the twist [rad/s] ≥ 0; one of the two > 0
  double slide = std::numeric_limits<double>::infinity();  ///< largest way from where the finger touched down [m] ≥ 0
  double twist = std::numeric_limits<double>::infinity();  ///< largest twist from there [rad] ≥ 0
};

/// A stated error is the largest that the scene's walk found, times this: other motions within the scene may change more. In 300 random scenes
/// (seeds 1101 to 1400) the worst of 20 random motions each was up to 1.8 times what the walk found, in 95 of 100 scenes up to 1.35 times.
/// Calibrated by tests/godobject/scene/choice_study.cpp, on other seeds than the test's.
inline constexpr double error_margin = 2.0;

/// What each simplification by itself changes, as the candidates' error: the rest is exact.
struct Effects {
  double torsion;      ///< without friction against twist
  double coupling;     ///< force and moment limited each on its own (box, closest point)
  double load_radius;  ///< the radius of the mean load at every load
  double curve;        ///< the ellipse through the intercepts for the exact curve
  double projection;   ///< radial for the closest point, on the exact curve
  double sampling;     ///< not a simplification: what half the sample time would change. No model is better than that
};

struct StepChoice {
  Effects effects;
  /// By cost; one is chosen. `model` is "no torsion", or curve/projection, with "/a(P)" where the radius follows the load, else it is that of
  /// the mean load. `error` is the largest change of (F/μP, M/Γ), as a distance: 0.01 is 1 % of what the contact bears. `nanoseconds` are
  /// those of a step that slips.
  std::vector<Candidate> candidates;
  /// "no torsion is needed", "uncoupled will do" or "coupling is needed", with the numbers that say why.
  std::string verdict;
  /// The one that is chosen, as `Replay` runs it, on a plane.
  ReplayOptions chosen;
};

/// The cheapest step that feels like the exact one to within `tolerance`, 1e-6 … 1, in this scene.
///
/// Every candidate is driven through the same motion as the exact curve under the closest point: a walk of a thousand legs that slide and
/// twist one after the other and at once, reverse and turn aside, within the scene's rates, ways and loads. So `error` is what one long motion
/// found, times `error_margin`, and the tables' own error, not a bound over all motions. Throws std::invalid_argument naming parameter, value, unit and range. Cost: half a
/// second as a rule, and the tables of the law.
StepChoice choose_step(const Scene& scene, double tolerance);

}  // namespace limitcurve::godobject
