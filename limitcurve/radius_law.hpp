// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace limitcurve {

/// A measured contact radius, or a measured limit of the friction moment, at a load.
struct LoadSample {
  double load;   ///< P [N] > 0
  double value;  ///< a [m] or Γ [N·m] > 0
};

/// How the contact radius grows with the load: a(P) = c·P^γ, which holds all published laws:
/// constant (γ = 0), Hertz a = (3PR/4E*)^{1/3} (γ = 1/3), soft finger c·P^γ (Xydas and Kao 1999, 0 ≤ γ ≤ 1/3);
/// or a table, a power law from sample to sample. Since Γ(P) = m₀ μ P a(P), a law of the moment limit is one of the
/// radius: see `of_moments`, and `linear_moment` for Γ = μ_r P. Immutable.
class RadiusLaw {
 public:
  /// a = radius [m] > 0 at every load.
  static RadiusLaw constant(double radius);
  /// Sphere of radius R [m] > 0 and effective modulus E* [Pa] > 0.
  static RadiusLaw hertz(double sphere_radius, double modulus);
  /// a = c P^γ, c [m/N^γ] > 0, γ ∈ [0, 1].
  static RadiusLaw power(double coefficient, double exponent);
  /// Straight lines between the samples (and beyond the outermost ones) in log–log. At least two, loads increasing;
  /// the exponent of every stretch in (−1, 1], so that larger loads bear more moment.
  static RadiusLaw sampled(std::span<const LoadSample> radii);
  /// The radius at which Γ(P) = m₀ μ P a(P) is the sampled moment limit [N·m]; as `sampled`.
  static RadiusLaw of_moments(std::span<const LoadSample> moments, double mu, double moment_ratio);
  /// The constant radius at which Γ(P) = μ_r P (paper, eq. 2): a = μ_r/(μ m₀), μ_r [m] > 0.
  static RadiusLaw linear_moment(double moment_coefficient, double mu, double moment_ratio);
  /// `constant:a=0.005`, `hertz:R=0.008,E=2e5`, `power:c=0.00207,gamma=0.259`.
  /// This and the factories throw `std::invalid_argument` naming parameter, value, unit and range.
  static RadiusLaw parse(std::string_view text);

  /// a(P) [m] at load P [N] ≥ 0; relative error ≤ 4 ε.
  [[nodiscard]] double radius(double load) const noexcept {
    if (is_sampled()) return sampled_radius(load);
    return exponent_ == 0.0 ? coefficient_ : coefficient_ * std::pow(load, exponent_);
  }
  /// a(λP)/a(P). But for a sampled law it does not depend on P.
  [[nodiscard]] double growth(double load_ratio, double load = 1.0) const noexcept {
    if (!is_sampled()) return exponent_ == 0.0 ? 1.0 : std::pow(load_ratio, exponent_);
    return radius(load_ratio * load) / radius(load);
  }
  /// The load [N] at which P·a(P) is `product` [N·m] ≥ 0.
  [[nodiscard]] double load_of_product(double product) const noexcept;
  /// c [m/N^γ] and γ at a load: of a sampled law, those of the stretch that holds it.
  [[nodiscard]] double coefficient(double load = 1.0) const noexcept;
  [[nodiscard]] double exponent(double load = 1.0) const noexcept;
  [[nodiscard]] bool is_sampled() const noexcept { return stretches_ != nullptr; }
  /// The least and the largest load [N] that a sample stands at; beyond them a sampled law is extrapolated. Of any other law 0 and infinity.
  [[nodiscard]] std::pair<double, double> sampled_loads() const noexcept { return sampled_loads_; }

 private:
  struct Stretch;

  RadiusLaw(double coefficient, double exponent) : coefficient_(coefficient), exponent_(exponent) {}

  [[nodiscard]] double sampled_radius(double load) const noexcept;
  [[nodiscard]] const Stretch& stretch_at(double load) const noexcept;

  double coefficient_;
  double exponent_;
  std::pair<double, double> sampled_loads_{0.0, std::numeric_limits<double>::infinity()};
  std::shared_ptr<const std::vector<Stretch>> stretches_;  // of a sampled law; shared, because laws are copied about
};

}  // namespace limitcurve
