// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <string_view>

namespace limitcurve {

/// How the contact radius grows with the load: a(P) = c·P^γ, which holds all published laws:
/// constant (γ = 0), Hertz a = (3PR/4E*)^{1/3} (γ = 1/3), soft finger c·P^γ (Xydas and Kao 1999, 0 ≤ γ ≤ 1/3).
/// Immutable.
class RadiusLaw {
 public:
  /// a = radius [m] > 0 at every load.
  static RadiusLaw constant(double radius);
  /// Sphere of radius R [m] > 0 and effective modulus E* [Pa] > 0.
  static RadiusLaw hertz(double sphere_radius, double modulus);
  /// a = c P^γ, c [m/N^γ] > 0, γ ∈ [0, 1].
  static RadiusLaw power(double coefficient, double exponent);
  /// `constant:a=0.005`, `hertz:R=0.008,E=2e5`, `power:c=0.00207,gamma=0.259`.
  /// This and the factories throw `std::invalid_argument` naming parameter, value, unit and range.
  static RadiusLaw parse(std::string_view text);

  /// a(P) [m] at load P [N] ≥ 0; relative error ≤ 4 ε.
  [[nodiscard]] double radius(double load) const noexcept {
    return exponent_ == 0.0 ? coefficient_ : coefficient_ * std::pow(load, exponent_);
  }
  /// a(λP)/a(P), which no law of this kind lets depend on P.
  [[nodiscard]] double growth(double load_ratio) const noexcept { return exponent_ == 0.0 ? 1.0 : std::pow(load_ratio, exponent_); }
  [[nodiscard]] double coefficient() const noexcept { return coefficient_; }  ///< c [m/N^γ]
  [[nodiscard]] double exponent() const noexcept { return exponent_; }        ///< γ

 private:
  RadiusLaw(double coefficient, double exponent) : coefficient_(coefficient), exponent_(exponent) {}

  double coefficient_;
  double exponent_;
};

}  // namespace limitcurve
