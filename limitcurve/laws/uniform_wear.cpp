// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"

#include <cmath>
#include <numbers>

namespace limitcurve {

namespace {

/// 1/(2ρ), infinite at the centre: the load is uniform in ρ.
class UniformWearLaw final : public PressureLawOf<UniformWearLaw> {
 public:
  std::string name() const override { return "uniform-wear"; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    return 1 / (2 * at.radius);
  }
  /// Where the quadrature would leave out load at the centre, the first term is exact.
  std::optional<UnitForces<Extended>> closed(Extended s, Slope /*slope*/) const noexcept override {
    if (!(s <= 1e-20L)) return std::nullopt;
    constexpr Extended ln2 = std::numbers::ln2_v<Extended>;
    const Extended logarithm = ln2 - (s > 0 ? std::log(s) : -1074 * ln2) / 2;  // 2^-1074 is the smallest double
    return UnitForces<Extended>{s * (logarithm + 0.25L), 0.5L, logarithm - 0.25L};
  }
};

}  // namespace

Law uniform_wear() {
  return std::make_shared<UniformWearLaw>();
}

}  // namespace limitcurve
