// SPDX-License-Identifier: MIT
#pragma once

#include "../limitcurve/pressure_law.hpp"
#include "estimate.hpp"
#include "measurements.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace limitcurve::fit {

/// The limit curve to fit to samples of slip. Beside its shape, every model has the two limits of the contact: μ
/// (largest force divided by load) and μ_r (largest moment divided by load).
struct ContactModel {
  enum class Kind {
    ellipse,    ///< (F/μP)² + (M/μ_rP)² = 1
    law,        ///< the exact curve of a pressure law, which implies a contact radius a = μ_r/(μ m₀)
    power,      ///< exact, p ∝ (1−ρ²)ⁿ, n free, −0.75 to 6
    xydas_kao,  ///< exact, p ∝ (1−ρᵏ)^{1/k}, k free, 0.8 to 12
  };
  Kind kind = Kind::ellipse;
  Law pressure_law = nullptr;  ///< for Kind::law

  static ContactModel of(Law law) { return {Kind::law, std::move(law)}; }
  /// ellipse, power, xydas-kao, or the name of the pressure law.
  [[nodiscard]] std::string name() const;
};

struct ContactFitOptions {
  Loss loss;
  /// The contact radius is proportional to P^gamma, γ ∈ [−0.5, 1]; 0 is the paper's M = μ_r P. `fit_gamma` fits it.
  double gamma = 0.0;
  bool fit_gamma = false;
  /// Warn of a larger contact radius [m]. The pad of a human fingertip is about 16 mm wide.
  double largest_radius = 0.008;
  /// If there are more samples, `select_law` chooses the law by this many, drawn evenly over load and slip, and then
  /// fits the chosen law to all samples.
  std::size_t rows_of_choice = 10'000;
};

/// A model fitted to samples. Estimates, in this order:
///   exact curves: mu [1], mu_r [m], ratio = mu_r/mu [m], radius [m], then n or k if free;
///   ellipse: force_max [1] (= F/P), moment_max [m] (= M/P).
/// With gamma ≠ 0 or fitted, moments are those at a load of 1 N, in m/N^γ, the radius has the name c, and gamma follows
/// if free.
struct ContactFit {
  /// For charts: a point of the fitted limit curve per newton of load, and the edges of the 95 % band along its normal
  /// (in the normalised plane). With a load-dependent radius, at a load of 1 N.
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
  /// Distance of each sample from the curve in standard deviations (as given, or estimated from the scatter); positive
  /// outside.
  std::vector<double> residuals;
  std::vector<BandPoint> band;  ///< from pure slide to pure twist
  /// Samples (from 0) whose distance in a robust fit is larger than the scatter of the others explains (a normal error
  /// reaches it in one of 200 data sets). A warning names them, too.
  std::vector<std::size_t> outliers;
};

/// Fits by orthogonal distance, because force and moment have errors; each error counts in units of its sigma. If the
/// samples have sigmas, `report.rms` is in standard deviations. Otherwise the fit assumes errors that are proportional
/// to the load and equal in the normalised plane, and estimates their size from the scatter; `report.rms` is then
/// relative to the limit (0.02 is 2 %). You need no starting values. Whatever the loss, a second fit finds gross
/// outliers, and a γ that differs from the assumed γ by more than chance gives in one of 2000 data sets. The report
/// warns of them. Cost: 1 to 10 ms for 100 samples, and once per process 20 to 70 ms for each family with a free shape.
/// Throws std::invalid_argument that names the sample for bad samples, or the parameters that the samples cannot
/// determine (too few samples, all on an axis, no twist at all, or all about one centre). If a robust loss would follow
/// a long hold, the fit is repeated with the squared loss, and a warning says so.
///
/// `Loss::edge` needs no marked slips, but a law and a log with sigmas and grips, because it finds the limits that the
/// wrench reaches and never exceeds.
ContactFit fit_contact(std::span<const Sample> samples, const ContactModel& model,
                       const ContactFitOptions& options = {});

/// The fits of all pressure laws, best first by AIC.
struct LawSelection {
  std::vector<ContactFit> candidates;
  /// AIC minus the AIC of the best candidate, in the order of the candidates. A difference below 2 is not significant;
  /// a difference above 10 is decisive.
  std::vector<double> aic_difference;
};

/// Fits every law of `law_examples` that has no parameter and no pressure like 1/ρ at its centre, gaussian:sigma=1 (its
/// radius is σ) and the two families. The report of the best warns of every candidate that the data cannot distinguish
/// from it. Its standard errors cover the noise, the choice of law, with Akaike's weights exp(−AIC/2) of the
/// candidates' values, and, where the samples do not scatter evenly about the best curve, what a law that is none of
/// these may be off by; for a mixture of two laws that is found with 100 slips of 2 % noise.
LawSelection select_law(std::span<const Sample> samples, const ContactFitOptions& options = {});

/// The contact radius that a moment-to-force ratio μ_r/μ implies under a law, a = ratio/m₀ [m].
Estimate implied_radius(const Estimate& ratio, const PressureLaw& law);

}  // namespace limitcurve::fit
