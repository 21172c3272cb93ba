// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>

#include <cmath>

namespace limitcurve {

namespace {

/// C_k(1−ρᵏ)^{1/k}, C_k = (3k/2)/B(1/k, 2/k) (Xydas and Kao 1999, as normalised by ∫ 2ρ g dρ = 1).
class XydasKaoLaw final : public PressureLawOf<XydasKaoLaw> {
 public:
  explicit XydasKaoLaw(double k) : k_(k) {
    // In more digits, for B loses two of them for small k.
    const boost::multiprecision::number<boost::multiprecision::cpp_dec_float<30>> wide_k = k;
    scale_ = static_cast<Extended>(1.5 * wide_k / boost::math::beta(1 / wide_k, 2 / wide_k));
    // For large k the pressure falls only between about 1 − 1/k and the rim: give that range a piece of its own.
    breaks_ = k_ > 8 ? std::vector<Extended>{0, std::exp(-4 / k_), 1} : std::vector<Extended>{0, 1};
  }

  std::string name() const override { return "xydas-kao:k=" + format_number(static_cast<double>(k_)); }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    // Compute 1 − ρᵏ from the distance that is exact here: from the rim, or from the centre.
    const Real log_radius = at.rim < at.radius ? std::log1p(-at.rim) : std::log(at.radius);
    return static_cast<Real>(scale_) * std::pow(-std::expm1(static_cast<Real>(k_) * log_radius), static_cast<Real>(1 / k_));
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
