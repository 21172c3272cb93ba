// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/projection.hpp"
#include "limitcurve/number.hpp"

#include <cmath>
#include <utility>

namespace limitcurve::godobject {

/// A disc that slides and spins on a horizontal plane under its own weight, slowed by nothing but dry friction that obeys a
/// limit boundary: the test that physics has an answer to. With the uniform law and the exact boundary sliding and spinning
/// end together, and just before v/(Rω) → 0.653 whatever they began with (Farkas et al. 2003).
///
/// Implicit Euler of m dv/dt = −μmg f, I dω/dt = −μmg R m(f): the same projection as a finger's, with the momentum in place
/// of the springs. The velocities that friction could take away in the step are the trial; what it does take lies on the
/// boundary, and the slip that is left is its normal. When the trial lies inside, the disc stops.
template <LimitBoundary Boundary, class Projection>
class FreeDisc {
 public:
  struct Parameters {
    double radius = 0.05;   ///< R [m] > 0, the contact radius too
    double inertia = 0.5;   ///< I/(mR²) > 0: ½ for a full disc
    double mu = 0.3;        ///< > 0
    double gravity = 9.81;  ///< [m/s²] > 0
  };

  /// Speeds [m/s], [rad/s] ≥ 0. Throws std::invalid_argument naming parameter, value, unit and range.
  FreeDisc(Boundary boundary, const Parameters& parameters, double speed, double spin, Projection projection = {})
      : boundary_(std::move(boundary)), projection_(projection), parameters_(parameters), speed_(speed), spin_(spin) {
    const auto positive = [](std::string_view name, double value, std::string_view unit) {
      if (!(value > 0.0 && value <= 1e15)) throw out_of_range(name, value, unit, "> 0, up to 1e15");
    };
    positive("radius", parameters.radius, "m");
    positive("inertia", parameters.inertia, "1");
    positive("mu", parameters.mu, "1");
    positive("gravity", parameters.gravity, "m/s^2");
    if (!(speed >= 0.0 && speed <= 1e15)) throw out_of_range("speed", speed, "m/s", ">= 0, up to 1e15");
    if (!(spin >= 0.0 && spin <= 1e15)) throw out_of_range("spin", spin, "rad/s", ">= 0, up to 1e15");
  }

  /// One time step [s] > 0 on.
  void step(double time_step) noexcept {
    if (speed_ == 0.0 && spin_ == 0.0) return;
    const double change = parameters_.mu * parameters_.gravity * time_step;           // of speed by the full force [m/s]
    const double twist_change = change / (parameters_.inertia * parameters_.radius);  // of spin by the unit moment [rad/s]
    Trial trial;
    trial.wrench = {speed_ / change, spin_ / twist_change};
    // What is left, (x̂ − f)·change : R(ŷ − m)·twist_change, is (x̂ − f) : (ŷ − m)/(I/mR²).
    trial.compliance_ratio = 1.0 / parameters_.inertia;
    trial.start = start_;
    const Projected projected = projection_(boundary_, trial);
    if (!projected.outside) {
      speed_ = 0.0;
      spin_ = 0.0;
      return;
    }
    start_ = projected.start;
    speed_ = std::max(speed_ - change * projected.wrench.force, 0.0);
    spin_ = std::max(spin_ - twist_change * projected.wrench.moment, 0.0);
  }

  [[nodiscard]] double speed() const noexcept { return speed_; }  ///< v [m/s]
  [[nodiscard]] double spin() const noexcept { return spin_; }    ///< ω [rad/s]
  /// v/(Rω); ∞ without spin, NaN at rest.
  [[nodiscard]] double ratio() const noexcept { return speed_ / (parameters_.radius * spin_); }
  /// Kinetic energy per mass [J/kg].
  [[nodiscard]] double energy() const noexcept {
    const double rim = parameters_.radius * spin_;
    return 0.5 * (speed_ * speed_ + parameters_.inertia * rim * rim);
  }

 private:
  Boundary boundary_;
  [[no_unique_address]] Projection projection_;
  Parameters parameters_;
  double speed_;
  double spin_;
  double start_ = -1.0;
};

}  // namespace limitcurve::godobject
