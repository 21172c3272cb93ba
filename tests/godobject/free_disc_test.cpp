// SPDX-License-Identifier: MIT
#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

namespace limitcurve::godobject::test {
namespace {

/// A disc that slides and spins on a horizontal plane under its own weight, slowed by nothing but dry friction that
/// obeys a limit curve: the test that physics has an answer to. With the uniform law and the exact curve sliding and
/// spinning end together, and just before the end v/(Rω) → 0.653 for any start (Farkas et al. 2003).
///
/// Implicit Euler of m dv/dt = −μmg f, I dω/dt = −μmg R m(f): the same friction as a finger's, with the momentum in
/// place of the springs. The velocities that friction could take away in the step are the trial; what it does take lies
/// on the curve, and the slip that is left is its normal. When the trial lies inside, the disc stops.
class FreeDisc {
 public:
  static constexpr double radius = 0.05;              ///< R [m], the contact radius too
  static constexpr double inertia = 0.5;              ///< I/(mR²) of a full disc
  static constexpr double deceleration = 0.3 * 9.81;  ///< μg [m/s²]

  /// Speeds [m/s], [rad/s] ≥ 0.
  FreeDisc(FingerCurve curve, double speed, double spin) : curve_(std::move(curve)), speed_(speed), spin_(spin) {}

  /// One time step [s] > 0 on.
  void step(double time_step) noexcept {
    const double change = deceleration * time_step;           // of speed by the full force [m/s]
    const double twist_change = change / (inertia * radius);  // of spin by the unit moment [rad/s]
    // In unit wrenches: what slips on, (f̂ − f)·change : R(m̂ − m)·twist_change, is (f̂ − f) : (m̂ − m)/(I/mR²).
    const FrictionLimit<double> unit{1.0, 1.0};
    const FrictionLimits<double> limits{unit, unit, 1.0 / inertia};
    const FrictionTrial<double> trial{speed_ / change, spin_ / twist_change};
    const FrictionResult<double> friction =
        apply_friction(curve_.view(), Projection::closest_point, limits, trial, memory_);
    speed_ *= 1.0 - friction.force_fraction;
    spin_ *= 1.0 - friction.moment_fraction;
  }

  /// v/(Rω); ∞ without spin, NaN at rest.
  [[nodiscard]] double ratio() const noexcept { return speed_ / (radius * spin_); }
  /// Kinetic energy per mass [J/kg].
  [[nodiscard]] double energy() const noexcept {
    const double rim = radius * spin_;
    return 0.5 * (speed_ * speed_ + inertia * rim * rim);
  }

 private:
  FingerCurve curve_;
  double speed_;
  double spin_;
  FrictionMemory<double> memory_;
};

/// v/(Rω) when all but the share 1e-10 of the energy is gone.
double last_ratio(FreeDisc sliding) {
  const double energy = sliding.energy();
  while (sliding.energy() > 1e-10 * energy) sliding.step(1e-6);
  return sliding.ratio();
}

// Farkas, Bartels, Unger, Wolf, Phys. Rev. Lett. 90:248302 (2003); Weidman, Malhotra, Phys. Rev. Lett. 95:264303
// (2005): just before it stops a uniform disc has v/(Rω) = 0.653001789205598, for any start.
TEST(FreeDisc, StopsSlidingAndSpinningTogether) {
  const FingerCurve curve = exact_curve(uniform());
  EXPECT_NEAR(last_ratio({curve, 1.0, 10.0}), 0.653, 0.0005);
  EXPECT_NEAR(last_ratio({curve, 1.0, 20.0}), 0.653, 0.0005);
  EXPECT_NEAR(last_ratio({curve, 0.5, 15.0}), 0.653, 0.0005);
  EXPECT_NEAR(last_ratio({Table::build(uniform(), 1e-8), 1.0, 20.0}), 0.653, 0.0005);
}

}  // namespace
}  // namespace limitcurve::godobject::test
