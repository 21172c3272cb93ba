// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"

#include <cmath>
#include <limits>
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
    const Extended logarithm =
        std::numbers::ln2_v<Extended> - std::log(std::fmax(s, Extended(std::numeric_limits<double>::min()))) / 2;
    return UnitForces<Extended>{s * (logarithm + 0.25L), 0.5L, logarithm - 0.25L};
  }
};

}  // namespace

Law uniform_wear() {
  return std::make_shared<UniformWearLaw>();
}

}  // namespace limitcurve
