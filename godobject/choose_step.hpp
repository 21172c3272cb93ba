// SPDX-License-Identifier: MIT
#pragma once

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
};

/// The cheapest step that feels like the exact one to within `tolerance`, 1e-6 … 1, in this scene.
///
/// Every candidate is driven through the same motions as the exact curve under the closest point: slide and twist at the
/// scene's rates, and a quarter of them, in every combination, forth and back, while the load swings between its limits.
/// So `error` is what these motions found, not a bound over all motions. Long motions are sampled coarser than the scene's
/// time, in 4000 steps. Throws std::invalid_argument naming parameter,
/// value, unit and range. Cost: some 20 ms, and the tables of the law.
StepChoice choose_step(const Scene& scene, double tolerance);

}  // namespace limitcurve::godobject
