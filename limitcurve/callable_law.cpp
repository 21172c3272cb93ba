// SPDX-License-Identifier: MIT
#include "limitcurve/laws.hpp"
#include "limitcurve/number.hpp"

#include <limits>
#include <stdexcept>

namespace limitcurve {

namespace {

/// A pressure that the user's program computes, in double.
class CallableLaw final : public PressureLawOf<CallableLaw> {
 public:
  CallableLaw(std::string name, std::function<double(double)> pressure, std::span<const double> breaks)
      : name_(std::move(name)), pressure_(std::move(pressure)), outer_(breaks.back()) {
    for (const double place : breaks) breaks_.push_back(place / outer_);
    Extended load = 0;
    for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
      const auto piece = DoubleExponential<Extended>::rule().integrate<1>(
          [&](Extended from_left, Extended) {
            const Extended radius = breaks_[i] + from_left;
            return std::array<Extended, 1>{2 * radius * this->pressure(RadialPosition<Extended>{radius, 1 - radius})};
          },
          breaks_[i + 1] - breaks_[i]);
      load += piece.value[0];
    }
    if (!(load > 0) || !(load <= std::numeric_limits<Extended>::max())) {
      throw std::invalid_argument("law '" + name_ + "': the pressure's integral is " + format_number(static_cast<double>(load)) +
                                  ", expected > 0 and finite");
    }
    scale_ = 1 / load;
  }

  std::string name() const override { return name_; }
  const std::vector<Extended>& breaks() const noexcept override { return breaks_; }

  template <class Real>
  Real pressure(RadialPosition<Real> at) const noexcept {
    return static_cast<Real>(scale_) * static_cast<Real>(pressure_(outer_ * static_cast<double>(at.radius)));
  }

  WrenchEstimate evaluate(double s, Method method) const noexcept override {
    WrenchEstimate estimate = PressureLaw::evaluate(s, method);
    // The pressure itself is right to a few units of the last place of a double.
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    estimate.error.force += rounding * estimate.wrench.force;
    estimate.error.moment += rounding * estimate.wrench.moment;
    return estimate;
  }

 private:
  std::string name_;
  std::function<double(double)> pressure_;
  double outer_;
  Extended scale_ = 1;
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
