// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/quadrature/evaluators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limitcurve {

namespace {

/// Σ wᵢ pᵢ. Each part is evaluated by its own best method, then the wrenches are added.
class MixtureLaw final : public PressureLawOf<MixtureLaw> {
 public:
  struct Part {
    double weight;      // as given
    Extended fraction;  // weight over the sum of weights
    Law law;
  };

  explicit MixtureLaw(std::vector<Part> parts) : parts_(std::move(parts)) {
    for (const Part& part : parts_) {
      const auto& breaks = part.law->breaks();
      breaks_.insert(breaks_.end(), breaks.begin(), breaks.end());
    }
    std::sort(breaks_.begin(), breaks_.end());
    breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
  }

  std::string name() const override {
    std::string text = "mix:";
    for (const Part& part : parts_) {
      if (text.back() != ':') text += '+';
      text += format_number(part.weight) + "*" + part.law->name();
    }
    return text;
  }

  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    Real sum = 0;
    for (const Part& part : parts_) {
      const Real rim = at.rim - static_cast<Real>(breaks_.back() - part.law->breaks().back());
      if (rim <= 0) continue;
      sum += static_cast<Real>(part.fraction) * part.law->density(RadialPosition<Real>{at.radius, rim}) *
             std::pow(rim, static_cast<Real>(part.law->rim_exponent()));
    }
    return sum;
  }

  bool allows(Method method) const noexcept override {
    return std::all_of(parts_.begin(), parts_.end(), [&](const Part& part) { return part.law->allows(method); });
  }

  WrenchEstimate evaluate(double s, Method method) const noexcept override {
    WrenchEstimate sum;
    for (const Part& part : parts_) {
      const auto fraction = static_cast<double>(part.fraction);
      const WrenchEstimate one = part.law->evaluate(s, method);
      sum.wrench.force += fraction * one.wrench.force;
      sum.wrench.moment += fraction * one.wrench.moment;
      sum.error.force += fraction * one.error.force;
      sum.error.moment += fraction * one.error.moment;
      sum.force_slope += fraction * one.force_slope;
    }
    // The fractions, their products and the sum round once each.
    const double rounding = 0.5 * std::numeric_limits<double>::epsilon() * (1.0 + static_cast<double>(parts_.size()));
    sum.error.force += rounding * sum.wrench.force;
    sum.error.moment += rounding * sum.wrench.moment;
    return sum;
  }

  Quadrature<double> line_profile(double t) const noexcept override {
    Quadrature<double> sum{};
    for (const Part& part : parts_) {
      const auto fraction = static_cast<double>(part.fraction);
      // Beyond the rim of a part its whole pressure is on one side.
      const bool beyond = t >= static_cast<double>(part.law->breaks().back());
      const auto one = beyond ? Quadrature<double>{{1.0, 0.0, 0.0}, {}} : part.law->line_profile(t);
      sum.forces += fraction * one.forces;
      sum.error += fraction * one.error;
    }
    return sum;
  }

  Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept override {
    Quadrature<Extended> sum{};
    for (const Part& part : parts_) {
      const auto [forces, error] = part.law->unrounded(s, slope);
      sum.forces += part.fraction * forces;
      sum.error += part.fraction * error;
    }
    return sum;
  }

  double profile_error() const noexcept override {
    double sum = 0.0;
    for (const Part& part : parts_) sum += static_cast<double>(part.fraction) * part.law->profile_error();
    return sum;
  }

  UnitForces<double> forces(double s, Slope slope) const noexcept override {
    UnitForces<double> sum{};
    for (const Part& part : parts_) sum += static_cast<double>(part.fraction) * part.law->forces(s, slope);
    return sum;
  }

 private:
  std::vector<Part> parts_;
  std::vector<Extended> breaks_;
};

}  // namespace

Law mixture(std::span<const std::pair<double, Law>> parts) {
  if (parts.empty()) throw std::invalid_argument("mixture has no parts: expected at least one");
  Extended total = 0;
  for (const auto& [weight, law] : parts) {
    checked(law);
    if (!(weight > 0.0 && weight <= 1e12))
      throw out_of_range("weight of " + law->name(), weight, "1", "0 < weight <= 1e12");
    total += weight;
  }
  std::vector<MixtureLaw::Part> scaled;
  for (const auto& [weight, law] : parts) scaled.push_back({weight, weight / total, law});
  return std::make_shared<MixtureLaw>(std::move(scaled));
}

}  // namespace limitcurve
