// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <boost/math/special_functions/bessel.hpp>

#include <cmath>

namespace limitcurve {

namespace {

constexpr Extended root_half_pi = 1.253314137315500251207882642405522627L;  // sqrt(pi/2)

/// e^{−z}I₀(z), e^{−z}I₁(z) and their difference, for z ≥ 0.
struct ScaledBessel {
  Extended zero;
  Extended one;
  Extended difference;
};

/// √(2πz) times the above by the asymptotic expansion (DLMF 10.40.1): for z ≥ 40 its smallest term is below 1e-34.
/// `inverse` is 1/z, which may be 0.
ScaledBessel asymptotic(Extended inverse) noexcept {
  Extended zero_term = 1;
  Extended one_term = 1;
  ScaledBessel sum{1, 1, 0};
  for (int k = 1; k <= 30; ++k) {
    const Extended odd = 2 * k - 1;
    zero_term *= odd * odd / (8 * k) * inverse;
    one_term *= (odd * odd - 4) / (8 * k) * inverse;
    sum.zero += zero_term;
    sum.one += one_term;
    sum.difference += zero_term - one_term;
  }
  return sum;
}

/// exp(−ρ²/2σ²)/(2σ²). With x = s/2σ, z = x² (Bessel functions scaled by e^{−z}):
///   f = √(π/2) x (I₀ + I₁),  m = σ√(π/2) I₀,  df/ds = √(π/2)/(2σ) (I₀ − I₁).
class GaussianLaw final : public PressureLawOf<GaussianLaw> {
 public:
  explicit GaussianLaw(double sigma) : sigma_(sigma), breaks_{0, 2 * sigma_, 13 * sigma_} {}

  std::string name() const override { return "gaussian:sigma=" + format_number(static_cast<double>(sigma_)); }

  /// The last break is 13σ: beyond it there is less than 1e-36 of the load.
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    const auto sigma = static_cast<Real>(sigma_);
    const Real ratio = at.radius / sigma;
    return std::exp(-ratio * ratio / 2) / (2 * sigma * sigma);
  }
  std::optional<Extended> punch_density(RadialPosition<Extended> at) const noexcept override {
    const Extended ratio = at.radius / sigma_;
    return 1 / root_half_pi * ratio * ratio * std::exp(-ratio * ratio / 2) / sigma_;
  }

  std::optional<UnitForces<Extended>> closed(Extended s, Slope /*slope*/) const noexcept override {
    const Extended x = s / (2 * sigma_);
    // For large z use the expansion: e^z overflows. NaN takes this branch, too, because Boost's functions do not accept
    // it.
    if (!(x * x <= 40)) {
      const Extended inverse = 1 / x;
      const ScaledBessel bessel = asymptotic(inverse * inverse);
      // √(π/2)·x/√(2πz) = ½
      return UnitForces<Extended>{(bessel.zero + bessel.one) / 2, sigma_ * bessel.zero * inverse / 2,
                                  bessel.difference * inverse / (4 * sigma_)};
    }
    const Extended z = x * x;
    const Extended decay = std::exp(-z);
    const Extended zero = decay * boost::math::cyl_bessel_i(0, z);
    const Extended one = decay * boost::math::cyl_bessel_i(1, z);
    return UnitForces<Extended>{root_half_pi * x * (zero + one), sigma_ * root_half_pi * zero,
                                root_half_pi / (2 * sigma_) * (zero - one)};
  }

 private:
  Extended sigma_;
  std::vector<Extended> breaks_;
};

}  // namespace

Law gaussian(double sigma) {
  if (!(sigma >= 1e-6 && sigma <= 1e6)) throw out_of_range("sigma", sigma, "1", "1e-6 <= sigma <= 1e6");
  return std::make_shared<GaussianLaw>(sigma);
}

}  // namespace limitcurve
