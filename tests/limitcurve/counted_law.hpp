// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"
#include "limitcurve/quadrature/evaluators.hpp"

#include <utility>

namespace limitcurve::test {

/// A law that counts the wrenches that are asked of it.
class CountedLaw final : public PressureLawOf<CountedLaw> {
 public:
  explicit CountedLaw(Law law) : law_(std::move(law)) {}
  std::string name() const override { return law_->name(); }
  const std::vector<Extended>& breaks() const noexcept override { return law_->breaks(); }
  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    return law_->density(at);
  }
  UnitForces<double> forces(double s, Slope slope) const noexcept override {
    ++count;
    return law_->forces(s, slope);
  }
  WrenchEstimate evaluate(double s, Method method) const noexcept override { return law_->evaluate(s, method); }
  Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept override { return law_->unrounded(s, slope); }
  mutable std::size_t count = 0;

 private:
  Law law_;
};

}  // namespace limitcurve::test
