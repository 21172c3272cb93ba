// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::test {

/// A law of somebody's own: any function, and the radii where it says that it is not smooth.
class FunctionLaw final : public PressureLawOf<FunctionLaw> {
 public:
  FunctionLaw(std::string name, std::function<Extended(Extended)> pressure, std::vector<Extended> breaks)
      : name_(std::move(name)), pressure_(std::move(pressure)), breaks_(std::move(breaks)) {}

  std::string name() const override { return name_; }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    return static_cast<Real>(pressure_(at.radius));
  }

 private:
  std::string name_;
  std::function<Extended(Extended)> pressure_;
  std::vector<Extended> breaks_;
};

/// The law of a function in any unit, scaled to load 1 by Boost's quadrature between the breaks.
inline Law law_of_function(std::string name, std::function<Extended(Extended)> pressure, std::vector<Extended> breaks) {
  Extended load = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    load += boost::math::quadrature::gauss_kronrod<Extended, 61>::integrate(
        [&](Extended rho) { return 2 * rho * pressure(rho); }, breaks[i], breaks[i + 1], 15, Extended(1e-18L));
  }
  return std::make_shared<FunctionLaw>(
      std::move(name), [=](Extended rho) { return pressure(rho) / load; }, std::move(breaks));
}

}  // namespace limitcurve::test
