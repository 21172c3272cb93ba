// SPDX-License-Identifier: MIT
#include "limitcurve/internal/number.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/laws/smooth_pieces.hpp"
#include "limitcurve/quadrature/evaluators.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

namespace limitcurve {

namespace {

/// A pressure given by a function in double.
class CallableLaw final : public PressureLawOf<CallableLaw> {
 public:
  CallableLaw(std::string name, std::function<double(double)> pressure, std::span<const double> breaks, double narrowest_feature)
      : name_(std::move(name)), pressure_(std::move(pressure)), outer_(breaks.back()) {
    std::vector<Extended> given;
    for (const double place : breaks) {
      // The quadrature does not evaluate the ends of a piece, so it would not notice a pressure that is infinite there.
      if (const double there = pressure_(place); !(there >= 0.0 && there <= std::numeric_limits<double>::max()))
        throw refused(place, there);
      given.push_back(place / outer_);
    }
    // Exceptions must not pass through the quadrature: the first is kept, and thrown after it.
    std::exception_ptr fault;
    const auto at = [&](Extended radius) -> Extended {
      if (fault) return 0;
      try {
        const double place = outer_ * static_cast<double>(radius);
        const double there = pressure_(place);
        if (there < 0.0) throw refused(place, there);
        return 2 * radius * Extended(there);
      } catch (...) {
        fault = std::current_exception();
        return 0;
      }
    };
    SmoothPieces pieces = smooth_pieces(at, given, narrowest_feature);
    if (fault) std::rethrow_exception(fault);
    const Extended load = pieces.integral;
    if (!(load > 0) || !(load <= std::numeric_limits<Extended>::max())) {
      throw std::invalid_argument("law '" + name_ + "': the pressure's integral is " + format_number(static_cast<double>(load)) +
                                  ", expected > 0 and finite");
    }
    scale_ = 1 / load;
    breaks_ = std::move(pieces.breaks);
    // Twice, because the integral that scales the pressure has the same error.
    unresolved_ = 2.0 * static_cast<double>(pieces.error) + load_at_jumps();
    most_moment_ = evaluators::ring(*this, Extended(0), Slope::unwanted).forces.moment;
  }

  std::string name() const override { return name_; }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    try {
      return static_cast<Real>(scale_) * static_cast<Real>(pressure_(outer_ * static_cast<double>(at.radius)));
    } catch (...) {
      return std::numeric_limits<Real>::quiet_NaN();
    }
  }

  UnitForces<double> forces(double s, Slope slope) const noexcept override { return possible(PressureLaw::forces(s, slope)); }
  WrenchEstimate evaluate(double s, Method method) const noexcept override {
    WrenchEstimate estimate = PressureLaw::evaluate(s, method);
    const auto [force, moment, slope] = possible(UnitForces<double>{estimate.wrench.force, estimate.wrench.moment, 0.0});
    estimate.wrench = {force, moment};
    estimate.error.force += rounding * force + unresolved_;
    estimate.error.moment += rounding * moment + unresolved_;
    return estimate;
  }
  evaluators::Quadrature<Extended> unrounded(Extended s, Slope slope) const noexcept override {
    evaluators::Quadrature<Extended> estimate = PressureLaw::unrounded(s, slope);
    estimate.forces = possible(estimate.forces);
    estimate.error.force += rounding * estimate.forces.force + unresolved_;
    estimate.error.moment += rounding * estimate.forces.moment + unresolved_;
    return estimate;
  }

 private:
  [[nodiscard]] std::invalid_argument refused(double place, double pressure) const {
    return std::invalid_argument("law '" + name_ + "': the pressure at radius " + format_number(place) + " is " + format_number(pressure) +
                                 ", expected >= 0 and finite");
  }

  /// The load within a rounding of a jump, where a double cannot resolve the side.
  [[nodiscard]] double load_at_jumps() const {
    const auto at = [&](Extended radius) { return this->pressure(RadialPosition<Extended>{radius, 1 - radius}); };
    constexpr Extended beside = 1e-12L;
    Extended sum = 0;
    Extended last = 0;
    for (const Extended place : breaks_) {
      // A jump that the search found lies between two breaks, or very near one.
      if (place - last > beside && place < 1) sum += 2 * place * place * std::fabs(at(place + beside) - at(place - beside));
      last = place;
    }
    return static_cast<double>(sum) * std::numeric_limits<double>::epsilon();
  }

  /// The function is assumed right to a few units in the last place of a double.
  static constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();

  /// Limits a wrench to those of pure sliding and pure spin, which quadrature of a rough pressure may exceed.
  template <class Real>
  [[nodiscard]] UnitForces<Real> possible(UnitForces<Real> forces) const noexcept {
    // In this order of arguments NaN stays NaN.
    forces.force = std::min<Real>(forces.force, 1);
    forces.moment = std::min(forces.moment, static_cast<Real>(most_moment_));
    return forces;
  }

  std::string name_;
  std::function<double(double)> pressure_;
  double outer_;
  Extended scale_ = 1;
  double unresolved_ = 0.0;   ///< error of the load from rough pressure; the kernels are at most 1, so it bounds both components' errors
  Extended most_moment_ = 0;  ///< m₀
  std::vector<Extended> breaks_;
};

}  // namespace

Law from_pressure(std::string name, std::function<double(double)> pressure, std::span<const double> breaks, double narrowest_feature) {
  if (!pressure) throw std::invalid_argument("law '" + name + "': no pressure function");
  if (breaks.size() < 2 || breaks.front() != 0.0) {
    throw std::invalid_argument("law '" + name + "': expected at least two breaks, the first 0");
  }
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    if (!(breaks[i] > breaks[i - 1]) || !(breaks[i] <= std::numeric_limits<double>::max())) {
      throw out_of_range("break " + std::to_string(i + 1), breaks[i], "1", "greater than the one before, and finite");
    }
  }
  if (!(narrowest_feature >= 1e-6 && narrowest_feature <= 1.0)) {
    throw out_of_range("narrowest_feature", narrowest_feature, "1", "1e-6 <= narrowest_feature <= 1");
  }
  return std::make_shared<CallableLaw>(std::move(name), std::move(pressure), breaks, narrowest_feature);
}

}  // namespace limitcurve
