// SPDX-License-Identifier: MIT
#pragma once

#include "fit/estimate.hpp"
#include "fit/measurements.hpp"
#include "limitcurve/pressure_law.hpp"

#include <span>
#include <string>
#include <vector>

namespace limitcurve::fit {

/// Which limit curve to lay through samples of slip. Beside the shape, every model has the two limits of the contact:
/// μ (largest force over load) and μ_r (largest moment over load).
struct ContactModel {
  enum class Kind {
    ellipse,       ///< (F/μP)² + (M/μ_rP)² = 1
    superellipse,  ///< exponent free, 1.05 to 20
    quartic,       ///< κ free, 0 to 6
    law,           ///< the exact curve of one pressure law: implies a contact radius a = μ_r/(μ m₀)
    power,         ///< exact, p ∝ (1−ρ²)ⁿ, n free, −0.75 to 6
    xydas_kao,     ///< exact, p ∝ (1−ρᵏ)^{1/k}, k free, 0.8 to 12
  };
  Kind kind = Kind::ellipse;
  Law pressure_law = nullptr;  ///< for Kind::law

  static ContactModel of(Law law) { return {Kind::law, std::move(law)}; }
  /// ellipse, superellipse, quartic, power, xydas-kao, or the law's own name.
  [[nodiscard]] std::string name() const;
};

struct ContactFitOptions {
  Loss loss;
  /// The contact radius grows as P^gamma: 0 (the paper's M = μ_r P) unless known, or fitted with `fit_gamma`.
  double gamma = 0.0;
  bool fit_gamma = false;
  /// Largest radius [m] that the finger can have; a larger one is warned of. A human fingertip's pad is some 16 mm wide.
  double largest_radius = 0.008;
};

/// A model through samples. Estimates, in this order:
///   exact curves: mu [1], mu_r [m], ratio = mu_r/mu [m], radius [m], then n or k if free;
///   approximations: force_max [1] (= F/P), moment_max [m] (= M/P), then exponent or kappa.
/// With gamma ≠ 0 or fitted, moments are those at a load of 1 N, in m/N^γ, the radius is called c, and gamma follows if free.
struct ContactFit {
  /// A point of the fitted limit curve per newton of load, and those of the 95 % band on either side along the normal
  /// (in the normalised plane): what a chart of the fit shows. With a growing radius, at a load of 1 N.
  struct BandPoint {
    double force;   ///< F/P [1]
    double moment;  ///< M/P [m]
    double inner_force;
    double inner_moment;
    double outer_force;
    double outer_moment;
  };

  std::string model;
  FitReport report;
  /// Distance of each sample from the curve in standard deviations (as told, or as found from the scatter), outside positive.
  std::vector<double> residuals;
  std::vector<BandPoint> band;  ///< from pure slide to pure twist
  /// Samples (0 the first) that a robust fit finds farther off than the others' scatter explains (a normal error is in one of 200 data
  /// sets). Warned of, too.
  std::vector<std::size_t> outliers;
};

/// Fits by orthogonal distance: errors of force and moment both count, each in units of its own sigma. Without sigmas both
/// errors are taken as proportional to the load, equal in the normalised plane, and their size is found from the scatter;
/// then `report.rms` is relative to the limit (0.02 is 2 %), with sigmas it is in standard deviations.
/// No starting values are needed. Cost: some 1 ms for 100 samples, once a process 20 to 70 ms for each family with a free shape.
/// Throws std::invalid_argument that names the sample for bad samples, or the parameters that the samples cannot determine
/// (too few; all on an axis; no twist at all). Warns of gross outliers whatever the loss, and where a free γ is as far from the one
/// assumed as chance leads in one of 2000 sets: that takes one more fit.
ContactFit fit_contact(std::span<const Sample> samples, const ContactModel& model, const ContactFitOptions& options = {});

/// All pressure laws against each other, best first by AICc.
struct LawSelection {
  std::vector<ContactFit> candidates;
  /// AICc less the best one's, in the order of the candidates: below 2 there is nothing to choose, above 10 the matter is decided.
  std::vector<double> aic_difference;
};

/// Fits flat-punch, uniform, hertz, parabolic, cone, gaussian:sigma=1 (its radius is σ) and the two families. The best one's report warns
/// of every candidate that the data cannot tell from it, and its standard errors include the choice: the candidates' values count with
/// Akaike's weights, exp(−AICc/2).
LawSelection select_law(std::span<const Sample> samples, const ContactFitOptions& options = {});

/// The contact radius that a moment-to-force ratio μ_r/μ implies under a law, a = ratio/m₀ [m].
Estimate implied_radius(const Estimate& ratio, const PressureLaw& law);

}  // namespace limitcurve::fit
