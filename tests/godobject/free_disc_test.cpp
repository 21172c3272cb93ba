// SPDX-License-Identifier: MIT
#include "tests/godobject/free_disc.hpp"

#include "tests/godobject/scene.hpp"

#include <gtest/gtest.h>

namespace limitcurve::godobject::test {
namespace {

FreeDisc disc(const FingerCurve& curve, double speed, double spin) {
  return {curve, FreeDisc::Parameters{}, speed, spin};
}

/// v/(Rω) when all but the share 1e-10 of the energy is gone.
double last_ratio(FreeDisc sliding, double time_step) {
  const double energy = sliding.energy();
  while (sliding.energy() > 1e-10 * energy) sliding.step(time_step);
  return sliding.ratio();
}

// Farkas, Bartels, Unger, Wolf, Phys. Rev. Lett. 90:248302 (2003); Weidman, Malhotra, Phys. Rev. Lett. 95:264303 (2005):
// just before it stops a uniform disc has v/(Rω) = 0.653001789205598, for any start.
TEST(FreeDisc, StopsSlidingAndSpinningTogether) {
  const FingerCurve curve = exact_curve(uniform());
  EXPECT_NEAR(last_ratio(disc(curve, 1.0, 10.0), 1e-6), 0.653, 0.0005);
  EXPECT_NEAR(last_ratio(disc(curve, 1.0, 20.0), 1e-6), 0.653, 0.0005);
  EXPECT_NEAR(last_ratio(disc(curve, 0.5, 15.0), 1e-6), 0.653, 0.0005);
  EXPECT_NEAR(last_ratio(disc(Table::build(uniform(), 1e-8), 1.0, 20.0), 1e-6), 0.653, 0.0005);
}

TEST(FreeDisc, EndsBothInOneStep) {
  FreeDisc sliding = disc(exact_curve(uniform()), 1.0, 20.0);
  while (sliding.speed() > 0.0 || sliding.spin() > 0.0) {
    const bool both = sliding.speed() > 0.0 && sliding.spin() > 0.0;
    sliding.step(1e-5);
    ASSERT_TRUE(both);
  }
}

// With uncoupled limits one motion ends long before the other; the ellipse has no fixed ratio but spins on in the end.
TEST(FreeDisc, DoesSoWithNeitherBoxNorEllipse) {
  const double m0 = uniform()->moment_ratio();
  EXPECT_EQ(last_ratio(disc(box(1.0, m0), 1.0, 5.0), 1e-6), std::numeric_limits<double>::infinity());
  EXPECT_EQ(last_ratio(disc(box(1.0, m0), 1.0, 100.0), 1e-6), 0.0);
  EXPECT_LT(last_ratio(disc(Ellipse::through_intercepts(m0), 1.0, 20.0), 1e-6), 0.3);
}

TEST(FreeDisc, LosesEnergyInEveryStep) {
  FreeDisc sliding = disc(exact_curve(hertz()), 1.0, 20.0);
  while (sliding.energy() > 0.0) {
    const double before = sliding.energy();
    sliding.step(1e-3);
    ASSERT_LT(sliding.energy(), before);
  }
}

TEST(FreeDisc, PureMotionsStayPure) {
  FreeDisc sliding = disc(exact_curve(uniform()), 1.0, 0.0);
  FreeDisc spinning = disc(exact_curve(uniform()), 0.0, 10.0);
  for (int i = 0; i < 100; ++i) {
    sliding.step(1e-3);
    spinning.step(1e-3);
  }
  EXPECT_NEAR(sliding.speed(), 1.0 - 0.3 * 9.81 * 0.1, 1e-12);
  EXPECT_EQ(sliding.spin(), 0.0);
  EXPECT_EQ(spinning.speed(), 0.0);
  EXPECT_NEAR(spinning.spin(), 10.0 - 0.3 * 9.81 * (2.0 / 3.0) / (0.5 * 0.05) * 0.1, 1e-12);
}

}  // namespace
}  // namespace limitcurve::godobject::test
