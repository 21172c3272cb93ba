// SPDX-License-Identifier: MIT
#include "limitcurve/evaluators.hpp"
#include "limitcurve/laws.hpp"
#include "limitcurve/number.hpp"
#include "limitcurve/smooth_pieces.hpp"

#include <limits>
#include <stdexcept>

namespace limitcurve {

namespace {

/// A pressure that the user's program computes, in double.
class CallableLaw final : public PressureLawOf<CallableLaw> {
 public:
  CallableLaw(std::string name, std::function<double(double)> pressure, std::span<const double> breaks)
      : name_(std::move(name)), pressure_(std::move(pressure)), outer_(breaks.back()) {
    std::vector<Extended> told;
    for (const double place : breaks) told.push_back(place / outer_);
    SmoothPieces pieces = smooth_pieces(
        [&](Extended radius) {
          return 2 * radius * this->pressure(RadialPosition<Extended>{radius, 1 - radius});
        },
        told);
    const Extended load = pieces.integral;
    if (!(load > 0) || !(load <= std::numeric_limits<Extended>::max())) {
      throw std::invalid_argument("law '" + name_ + "': the pressure's integral is " + format_number(static_cast<double>(load)) +
                                  ", expected > 0 and finite");
    }
    scale_ = 1 / load;
    breaks_ = std::move(pieces.breaks);
    unresolved_ = static_cast<double>(pieces.error);
  }

  std::string name() const override { return name_; }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    return static_cast<Real>(scale_) * static_cast<Real>(pressure_(outer_ * static_cast<double>(at.radius)));
  }

  WrenchEstimate evaluate(double s, Method method) const noexcept override {
    WrenchEstimate estimate = PressureLaw::evaluate(s, method);
    estimate.error.force += rounding * estimate.wrench.force + unresolved_;
    estimate.error.moment += rounding * estimate.wrench.moment + unresolved_;
    return estimate;
  }
  evaluators::Quadrature<Extended> unrounded(Extended s) const noexcept override {
    evaluators::Quadrature<Extended> estimate = PressureLaw::unrounded(s);
    estimate.error.force += rounding * estimate.forces.force + unresolved_;
    estimate.error.moment += rounding * estimate.forces.moment + unresolved_;
    return estimate;
  }

 private:
  /// The pressure itself is right to a few units of the last place of a double.
  static constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();

  std::string name_;
  std::function<double(double)> pressure_;
  double outer_;
  Extended scale_ = 1;
  double unresolved_ = 0.0;  ///< of the load where the pressure is rough, and so of both components: their kernels are at most 1
  std::vector<Extended> breaks_;
};

}  // namespace

Law from_pressure(std::string name, std::function<double(double)> pressure, std::span<const double> breaks) {
  if (!pressure) throw std::invalid_argument("law '" + name + "': no pressure function");
  if (breaks.size() < 2 || breaks.front() != 0.0) {
    throw std::invalid_argument("law '" + name + "': expected at least two breaks, the first 0");
  }
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    if (!(breaks[i] > breaks[i - 1]) || !(breaks[i] <= std::numeric_limits<double>::max())) {
      throw out_of_range("break " + std::to_string(i + 1), breaks[i], "1", "greater than the one before, and finite");
    }
  }
  return std::make_shared<CallableLaw>(std::move(name), std::move(pressure), breaks);
}

}  // namespace limitcurve
