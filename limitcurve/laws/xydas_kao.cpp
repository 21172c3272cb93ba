// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <boost/math/special_functions/beta.hpp>

#include <cmath>
#include <numbers>

namespace limitcurve {

namespace {

/// ln Γ(x) less its leading terms, of Stirling's series (DLMF 5.11.1): to 3e-20 for x >= 16.
Extended stirling_remainder(Extended x) {
  const Extended square = 1 / (x * x);
  Extended sum = Extended(1) / 156;
  for (const Extended term :
       {-Extended(691) / 360360, Extended(1) / 1188, -Extended(1) / 1680, Extended(1) / 1260, -Extended(1) / 360}) {
    sum = sum * square + term;
  }
  return (sum * square + Extended(1) / 12) / x;
}

/// C_k = (3k/2)/B(1/k, 2/k). For small k, where B as a quotient of Γ loses two digits, with their leading terms summed
/// by hand: a ln a + 2a ln 2a − 3a ln 3a = −a ln(27/4), a = 1/k.
Extended scale_of(Extended k) {
  const Extended a = 1 / k;
  if (a < 16) return 1.5 * k / boost::math::beta(a, 2 * a);
  const Extended power =
      std::pow(Extended(6.75), a) * (1 + std::log(Extended(6.75)) * std::fma(-a, k, Extended(1)) * a);  // 1/k is not a
  const Extended rest = stirling_remainder(3 * a) - stirling_remainder(a) - stirling_remainder(2 * a);
  return 1.5 * power * std::exp(rest) / std::sqrt(3 * std::numbers::pi_v<Extended> * a);
}

/// C_k(1−ρᵏ)^{1/k} (Xydas and Kao 1999, as normalised by ∫ 2ρ g dρ = 1).
class XydasKaoLaw final : public PressureLawOf<XydasKaoLaw> {
 public:
  explicit XydasKaoLaw(double k) : k_(k), scale_(scale_of(k)) {
    // For large k the pressure falls only between about 1 − 1/k and the rim: give that range a piece of its own.
    breaks_ = k_ > 8 ? std::vector<Extended>{0, std::exp(-4 / k_), 1} : std::vector<Extended>{0, 1};
  }

  std::string name() const override { return "xydas-kao:k=" + format_number(static_cast<double>(k_)); }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    // Compute 1 − ρᵏ from the distance that is exact here: from the rim, or from the centre.
    const Real log_radius = at.rim < at.radius ? std::log1p(-at.rim) : std::log(at.radius);
    return static_cast<Real>(scale_) *
           std::pow(-std::expm1(static_cast<Real>(k_) * log_radius), static_cast<Real>(1 / k_));
  }

 private:
  Extended k_;
  Extended scale_;
  std::vector<Extended> breaks_;
};

}  // namespace

Law xydas_kao(double k) {
  if (!(k >= 0.01 && k <= 1e6)) throw out_of_range("k", k, "1", "0.01 <= k <= 1e6");
  return std::make_shared<XydasKaoLaw>(k);
}

}  // namespace limitcurve
