// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"
#include "limitcurve/quadrature/closed_form.hpp"

#include <cmath>

namespace limitcurve {

namespace {

/// arccosh(1/ρ), logarithmically infinite at the centre; punches q(t) = 2t (indenter z ∝ r).
class ConeLaw final : public PressureLawOf<ConeLaw> {
 public:
  std::string name() const override { return "cone"; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    // arccosh(1/ρ) = log((1 + √(1−ρ²))/ρ) = log1p((rim + √(1−ρ²))/ρ), which keeps its digits at the rim.
    return std::log1p((at.rim + std::sqrt(at.rim * (1 + at.radius))) / at.radius);
  }
  std::optional<Extended> punch_density(RadialPosition<Extended> at) const noexcept override { return 2 * at.radius; }
  std::optional<UnitForces<Extended>> closed(Extended s, Slope /*slope*/) const noexcept override {
    return closed_form::cone(s);
  }
  UnitForces<double> forces(double s, Slope /*slope*/) const noexcept override { return closed_form::cone(s); }
};

}  // namespace

Law cone() {
  return std::make_shared<ConeLaw>();
}

}  // namespace limitcurve
