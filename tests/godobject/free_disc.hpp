// SPDX-License-Identifier: MIT
#pragma once

#include "godobject/finger_curve.hpp"
#include "godobject/friction.hpp"

#include <utility>

namespace limitcurve::godobject::test {

/// A disc that slides and spins on a horizontal plane under its own weight, slowed by nothing but dry friction that obeys a
/// limit curve: the test that physics has an answer to. With the uniform law and the exact curve sliding and spinning
/// end together, and just before the end v/(Rω) → 0.653 for any start (Farkas et al. 2003).
///
/// Implicit Euler of m dv/dt = −μmg f, I dω/dt = −μmg R m(f): the same friction as a finger's, with the momentum in place
/// of the springs. The velocities that friction could take away in the step are the trial; what it does take lies on the
/// curve, and the slip that is left is its normal. When the trial lies inside, the disc stops.
class FreeDisc {
 public:
  struct Parameters {
    double radius = 0.05;   ///< R [m] > 0, the contact radius too
    double inertia = 0.5;   ///< I/(mR²) > 0: ½ for a full disc
    double mu = 0.3;        ///< > 0
    double gravity = 9.81;  ///< [m/s²] > 0
  };

  /// Speeds [m/s], [rad/s] ≥ 0.
  FreeDisc(FingerCurve curve, const Parameters& parameters, double speed, double spin)
      : curve_(std::move(curve)), parameters_(parameters), speed_(speed), spin_(spin) {}

  /// One time step [s] > 0 on.
  void step(double time_step) noexcept {
    const double change = parameters_.mu * parameters_.gravity * time_step;           // of speed by the full force [m/s]
    const double twist_change = change / (parameters_.inertia * parameters_.radius);  // of spin by the unit moment [rad/s]
    // In unit wrenches: what slips on, (f̂ − f)·change : R(m̂ − m)·twist_change, is (f̂ − f) : (m̂ − m)/(I/mR²).
    const FrictionLimit<double> unit{1.0, 1.0};
    const FrictionLimits<double> limits{unit, unit, 1.0 / parameters_.inertia};
    const FrictionTrial<double> trial{speed_ / change, spin_ / twist_change};
    const FrictionResult<double> friction = apply_friction(curve_.view(), Projection::closest_point, limits, trial, memory_);
    speed_ *= 1.0 - friction.force_fraction;
    spin_ *= 1.0 - friction.moment_fraction;
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
  FingerCurve curve_;
  Parameters parameters_;
  double speed_;
  double spin_;
  FrictionMemory<double> memory_;
};

}  // namespace limitcurve::godobject::test
