// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/quadrature/closed_form.hpp"
#include "limitcurve/quadrature/tanh_sinh.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace limitcurve {

namespace {

constexpr Extended pi = closed_form::pi;

/// (n+1)(1−ρ²)ⁿ for any n > −1. The closed form is ₂F₁ as its Euler integral (DLMF 15.6.1) with t = sin²θ, w = 1 − z
/// sin²θ; geometrically, the mean over chords through the COR:
///   s ≤ 1, z = s²:    f = (4/π)(n+3/2)m₀ s ∫ cos²θ w^{n+½} dθ,  m = (2/π)m₀ ∫ w^{n+3/2} dθ,
///   s ≥ 1, z = s⁻²:   f = A ∫ cos^{2n+2}θ w^½ dθ,  A = 2Γ(n+2)/(√π Γ(n+3/2)),
///                     m = A'/(2(n+2)s) ∫ cos^{2n+4}θ w^{−½} dθ,  A' = A(n+2)/(n+3/2),
/// over [0, π/2]. Every term is positive; the terms of the hypergeometric series are not for large n.
class PowerFamilyLaw : public PressureLawOf<PowerFamilyLaw> {
 public:
  explicit PowerFamilyLaw(double n) : n_(n) {
    // tgamma_delta_ratio(x, δ) = Γ(x)/Γ(x+δ)
    using boost::math::tgamma_delta_ratio;
    moment_ratio_ = std::sqrt(pi) / 2 * tgamma_delta_ratio(n_ + 2, Extended(0.5));
    slope_at_rim_ = std::sqrt(pi) / 4 * tgamma_delta_ratio(n_ + 1, Extended(1.5));
    chord_scale_ = 2 / (std::sqrt(pi) * tgamma_delta_ratio(n_ + Extended(1.5), Extended(0.5)));
    // Uses n − ½ as rounded: near −1 its rounding would change the scale.
    if (n_ > -0.5L) punch_scale_ = 4 / (std::sqrt(pi) * tgamma_delta_ratio((n_ - Extended(0.5)) + 1, Extended(1.5)));
  }

  std::string name() const override { return "power:n=" + format_number(static_cast<double>(n_)); }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    const Real sum = 1 + at.radius;
    const auto n = static_cast<Real>(n_);
    return (n + 1) * std::pow(n < 0 ? sum : sum * at.rim, n);
  }
  Extended rim_exponent() const noexcept override { return n_ < 0 ? n_ : 0; }

  std::optional<Extended> punch_density(RadialPosition<Extended> at) const noexcept override {
    // For n ≤ −½ the superposition would need punches of negative load.
    if (n_ <= -0.5L) return std::nullopt;
    const Extended exponent = n_ - Extended(0.5);
    const Extended sum = 1 + at.radius;
    return punch_scale_ * at.radius * at.radius * std::pow(exponent < 0 ? sum : sum * at.rim, exponent);
  }
  Extended punch_exponent() const noexcept override { return std::fmin(n_ - Extended(0.5), 0); }

  std::optional<UnitForces<Extended>> closed(Extended s, Slope slope) const noexcept override {
    return s <= 1 ? inside(s, slope) : outside(s, slope);
  }
  UnitForces<double> forces(double s, Slope slope) const noexcept override {
    return s <= 1 ? inside(s, slope) : outside(s, slope);
  }

 private:
  template <class Real>
  using Triple = std::array<Real, 3>;

  /// w^exponent for w = 1 − below. A high power multiplies the rounding error of w, so it is computed from `below`,
  /// which has none.
  template <class Real>
  static Real power_below_one(Real w, Real below, Real exponent) noexcept {
    constexpr Real high = 16;
    return exponent > high && below < Real(0.5) ? std::exp(exponent * std::log1p(-below)) : std::pow(w, exponent);
  }

  template <class Real>
  UnitForces<Real> inside(Real s, Slope slope) const noexcept {
    const Real eta = (1 - s) * (1 + s);
    const Real exponent = static_cast<Real>(n_ + 0.5L);
    // Near s = 1 and for n < −½ the integrand is steepest at θ = π/2: integrate over ψ = π/2 − θ.
    auto integral = integrate<3>(
        [&](Real psi, Real theta) -> Triple<Real> {
          const Real cosine = std::sin(psi);
          const Real sine = std::sin(theta);
          const Real w = cosine * cosine + eta * sine * sine;
          const Real weight = power_below_one(w, s * s * sine * sine, exponent);
          return {cosine * cosine * weight, w * weight, sine * sine * weight};
        },
        static_cast<Real>(pi / 2), slope == Slope::wanted ? 3 : 2);
    // An integrand with a power −1 < 2n + 1 < 0 at the end, too steep for the quadrature: use its closed form.
    if (s == 1) integral.value[2] = static_cast<Real>(slope_at_rim_);
    const auto scale = static_cast<Real>(4 / pi * (n_ + 1.5L) * moment_ratio_);
    return {scale * s * integral.value[0], static_cast<Real>(2 / pi * moment_ratio_) * integral.value[1],
            scale * integral.value[2]};
  }

  template <class Real>
  UnitForces<Real> outside(Real s, Slope slope) const noexcept {
    // At s = ∞ the complement below would be ∞/∞.
    if (std::isinf(s)) return {1, 0, 0};
    const Real q = 1 / s;
    const Real eta = (s - 1) / s * ((s + 1) / s);
    const auto integral = integrate<3>(
        [&](Real psi, Real theta) -> Triple<Real> {
          const Real cosine = std::sin(psi);
          const Real sine = std::sin(theta);
          const Real root = std::sqrt(cosine * cosine + eta * sine * sine);
          const Real weight = power_below_one(cosine * cosine, sine * sine, static_cast<Real>(n_ + 1));
          return {weight * root, weight * cosine * cosine / root, weight * sine * sine / root};
        },
        static_cast<Real>(pi / 2), slope == Slope::wanted ? 3 : 2);
    const auto scale = static_cast<Real>(chord_scale_);
    return {scale * integral.value[0], scale * q / static_cast<Real>(2 * n_ + 3) * integral.value[1],
            scale * q * q * q * integral.value[2]};
  }

  Extended n_;
  Extended moment_ratio_;  // m₀ = Γ(3/2)Γ(n+2)/Γ(n+5/2)
  Extended slope_at_rim_;  // ∫ sin²θ cos^{2n+1}θ dθ
  Extended chord_scale_;   // A
  Extended punch_scale_ = 0;
};

/// A member of the family whose integrals are elementary or elliptic (closed_form.hpp), under its own name.
template <UnitForces<Extended> (*exact)(Extended) noexcept, UnitForces<double> (*fast)(double) noexcept>
class NamedPowerLaw final : public PowerFamilyLaw {
 public:
  NamedPowerLaw(std::string name, double n) : PowerFamilyLaw(n), name_(std::move(name)) {}
  std::string name() const override { return name_; }
  std::optional<UnitForces<Extended>> closed(Extended s, Slope /*slope*/) const noexcept override { return exact(s); }
  UnitForces<double> forces(double s, Slope /*slope*/) const noexcept override { return fast(s); }

 private:
  std::string name_;
};

template <UnitForces<Extended> (*exact)(Extended) noexcept, UnitForces<double> (*fast)(double) noexcept>
Law make_named(std::string name, double n) {
  return std::make_shared<NamedPowerLaw<exact, fast>>(std::move(name), n);
}

/// The member n with the name `name`, and with its elementary or elliptic closed form if there is one.
Law member(std::string name, double n) {
  if (n == -0.5)
    return make_named<closed_form::flat_punch<Extended>, closed_form::flat_punch<double>>(std::move(name), n);
  if (n == 0.0) return make_named<closed_form::uniform<Extended>, closed_form::uniform<double>>(std::move(name), n);
  if (n == 0.5) return make_named<closed_form::hertz<Extended>, closed_form::hertz<double>>(std::move(name), n);
  if (n == 1.0) return make_named<closed_form::parabolic<Extended>, closed_form::parabolic<double>>(std::move(name), n);
  return std::make_shared<PowerFamilyLaw>(n);
}

}  // namespace

Law flat_punch() {
  return member("flat-punch", -0.5);
}
Law uniform() {
  return member("uniform", 0.0);
}
Law hertz() {
  return member("hertz", 0.5);
}
Law parabolic() {
  return member("parabolic", 1.0);
}

Law power(double n) {
  if (!(n > -1.0 && n <= 1000.0)) throw out_of_range("n", n, "1", "-1 < n <= 1000");
  return member("power:n=" + format_number(n), n);
}

}  // namespace limitcurve
