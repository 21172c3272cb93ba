// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <string>
#include <vector>

namespace limitcurve::study {

/// A law without its closed form, to which it refers: `forces` is the quadrature over the radius, in double.
class ByRing final : public PressureLaw {
 public:
  explicit ByRing(const PressureLaw& law) : law_(&law) {}

  [[nodiscard]] std::string name() const override { return law_->name() + " by ring"; }
  [[nodiscard]] Extended density(RadialPosition<Extended> at) const noexcept override { return law_->density(at); }
  [[nodiscard]] double density(RadialPosition<double> at) const noexcept override { return law_->density(at); }
  [[nodiscard]] Extended rim_exponent() const noexcept override { return law_->rim_exponent(); }
  [[nodiscard]] const std::vector<Extended>& breaks() const noexcept override { return law_->breaks(); }

 private:
  const PressureLaw* law_;
};

}  // namespace limitcurve::study
