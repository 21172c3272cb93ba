// SPDX-License-Identifier: MIT
#pragma once

#include "../version.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

/// SI units. Functions that make radius laws throw std::invalid_argument with the parameter, its value, unit and range;
/// call them offline.
namespace limitcurve {

/// A measured contact radius, or a measured limit of the friction moment, at a load.
struct LoadSample {
  double load;   ///< P [N] > 0
  double value;  ///< a [m] or Γ [N·m] > 0
};

/// The contact radius a(P) as a function of the normal load P. It is either a power law a = c·P^γ or an interpolation
/// of measured samples. The power law covers the published ones: constant (γ = 0), Hertz, a = (3PR/4E*)^{1/3} (γ =
/// 1/3), and soft finger (Xydas and Kao 1999, 0 ≤ γ ≤ 1/3). Between samples, each pair of neighbours defines its own
/// power law. If you measured the moment limit instead of the radius, use `of_moments`, or `of_mu_r` for Γ = μ_r
/// P^(1+γ): they solve Γ(P) = m₀ μ P a(P) for a. Immutable; copies share the samples.
class RadiusLaw {
 public:
  /// a = radius [m] > 0 at every load.
  static RadiusLaw constant(double radius);
  /// Sphere of radius R [m] > 0 and effective modulus E* [Pa] > 0.
  static RadiusLaw hertz(double sphere_radius, double modulus);
  /// a = c P^γ, c [m/N^γ] > 0, γ ∈ [0, 1].
  static RadiusLaw power(double coefficient, double exponent);
  /// Interpolates samples of the radius linearly in log–log; beyond the samples, the first and last lines continue.
  /// Requires at least two samples with increasing loads. Between two neighbours the exponent must be in (−1, 1], so
  /// that the moment limit grows with the load.
  static RadiusLaw sampled(std::span<const LoadSample> radii);
  /// Interpolates samples of the moment limit Γ [N·m] the same way: a = Γ/(m₀ μ P).
  static RadiusLaw of_moments(std::span<const LoadSample> moments, double mu, double moment_ratio);
  /// The radius at which Γ(P) = μ_r P^(1+γ) (paper, eq. 2): a = μ_r P^γ/(μ m₀), μ_r [m/N^γ] ≥ 0, γ ∈ [−0.5, 1]. If μ =
  /// 0, μ_r must be 0 too. For μ_r = 0 the radius is not 0 but so small that the moment is negligible; this keeps the
  /// limits continuous in the parameters.
  static RadiusLaw of_mu_r(double mu_r, double gamma, double mu, double moment_ratio);
  /// A text of the kind of one of the `examples`, such as `constant:a=0.005`.
  static RadiusLaw parse(std::string_view text);
  static std::span<const std::string_view> examples();

  // Moves are cheap copies; a moved-from law stays valid.
  RadiusLaw(const RadiusLaw&) = default;
  RadiusLaw& operator=(const RadiusLaw&) = default;

  /// a(P) [m] at load P [N] ≥ 0; relative error ≤ 4 ε.
  [[nodiscard]] double radius(double load) const noexcept {
    if (is_sampled()) return sampled_radius(load);
    return exponent_ == 0.0 ? coefficient_ : coefficient_ * std::pow(load, exponent_);
  }
  /// a(λP)/a(P) for a load ratio λ > 0. `load` is P; it matters for a sampled law only.
  [[nodiscard]] double growth(double load_ratio, double load = 1.0) const noexcept {
    if (!is_sampled()) return exponent_ == 0.0 ? 1.0 : std::pow(load_ratio, exponent_);
    return radius(load_ratio * load) / radius(load);
  }
  /// The load P [N] for which P·a(P) = `product` [N·m] ≥ 0.
  [[nodiscard]] double load_of_product(double product) const noexcept;
  /// d ln a/d ln P at a load: all that a search by the load needs. For a power law γ, for a sampled law that between
  /// the two samples around the load.
  [[nodiscard]] double exponent(double load = 1.0) const noexcept;
  [[nodiscard]] bool is_sampled() const noexcept { return stretches_ != nullptr; }
  /// Whether it was made from moments (`of_moments`, `of_mu_r`), which then hold whatever m₀ is.
  [[nodiscard]] bool is_of_moments() const noexcept { return is_of_moments_; }
  /// Whether the radius may change with the load. True for every sampled law, even if its radii are all equal.
  [[nodiscard]] bool depends_on_load() const noexcept { return is_sampled() || exponent_ != 0.0; }
  /// Whether the radius may fall while the load grows.
  [[nodiscard]] bool may_fall() const noexcept { return is_sampled() || exponent_ < 0.0; }
  /// The smallest and the largest load [N] of the samples, beyond which a sampled law extrapolates; 0 and infinity for
  /// any other law.
  [[nodiscard]] std::pair<double, double> sampled_loads() const noexcept { return sampled_loads_; }

 private:
  struct Stretch;

  RadiusLaw(double coefficient, double exponent) : coefficient_(coefficient), exponent_(exponent) {}

  [[nodiscard]] double sampled_radius(double load) const noexcept;
  [[nodiscard]] const Stretch& stretch_at(double load) const noexcept;

  double coefficient_;
  double exponent_;
  bool is_of_moments_ = false;
  std::pair<double, double> sampled_loads_{0.0, std::numeric_limits<double>::infinity()};
  std::shared_ptr<const std::vector<Stretch>> stretches_;  // of a sampled law; shared by its copies
};

namespace detail {
/// a(P) [m]; 0 without load where the law has no finite radius.
[[nodiscard]] inline double radius_at(const RadiusLaw& law, double load) noexcept {
  const double radius = law.radius(load);
  return load > 0.0 || std::isfinite(radius) ? radius : 0.0;
}
}  // namespace detail

}  // namespace limitcurve
