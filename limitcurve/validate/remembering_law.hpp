// SPDX-License-Identifier: MIT
#pragma once

#include "limitcurve/pressure_law.hpp"
#include "limitcurve/quadrature/evaluators.hpp"

#include <mutex>
#include <unordered_map>
#include <utility>

namespace limitcurve {

/// A law that keeps the wrenches of `forces`, for work that compares many models with it at the same CORs: by
/// quadrature a wrench costs up to 0.2 ms. It allocates and locks, so it is no law of a loop.
class RememberingLaw final : public PressureLaw {
 public:
  explicit RememberingLaw(Law law) : law_(std::move(law)) {}

  std::string name() const override { return law_->name(); }
  Extended density(RadialPosition<Extended> position) const noexcept override { return law_->density(position); }
  double density(RadialPosition<double> position) const noexcept override { return law_->density(position); }
  Extended rim_exponent() const noexcept override { return law_->rim_exponent(); }
  const std::vector<Extended>& breaks() const noexcept override { return law_->breaks(); }
  std::optional<UnitForces<Extended>> closed(Extended s, Slope slope) const noexcept override {
    return law_->closed(s, slope);
  }
  std::optional<Extended> punch_density(RadialPosition<Extended> position) const noexcept override {
    return law_->punch_density(position);
  }
  Extended punch_exponent() const noexcept override { return law_->punch_exponent(); }
  UnitForces<double> forces(double s, Slope slope) const noexcept override {
    if (slope == Slope::wanted) return law_->forces(s, slope);
    const std::scoped_lock lock(mutex_);
    const auto known = known_.find(s);
    if (known != known_.end()) return known->second;
    return known_.emplace(s, law_->forces(s, slope)).first->second;
  }
  WrenchEstimate evaluate(double s, Method method) const noexcept override { return law_->evaluate(s, method); }
  Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept override { return law_->unrounded(s, slope); }
  double profile_error() const noexcept override { return law_->profile_error(); }
  Quadrature<double> line_profile(double t) const noexcept override { return law_->line_profile(t); }
  bool allows(Method method) const noexcept override { return law_->allows(method); }

 private:
  Law law_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<double, UnitForces<double>> known_;
};

}  // namespace limitcurve
